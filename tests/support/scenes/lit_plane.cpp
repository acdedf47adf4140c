#include "tests/support/scenes/lit_plane.h"

#include "engine/core/jobs.h"
#include "interop/brdf.h"
#include "renderer/lighting/brdf_table.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

void LitPlane::SetUp() {
    LitFrame::SetUp();
    const std::vector<vec3> corners{{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
    const std::vector<vec3> normals(4, vec3(0, 1, 0));
    const std::vector<uint32_t> indices{0, 1, 2, 0, 2, 3};
    MeshDesc plane;
    plane.label = "plane";
    plane.positions = corners;
    plane.normals = normals;
    plane.indices = indices;
    plane_ = renderer->createMesh(plane).value();
    lookDown(kHalf, 5);
    input.settings.dither = false;
    input.settings.toneMap = ToneMap::none;
    input.settings.antiAliasing = AntiAliasing::off;
}

CapturedImage LitPlane::render(const MaterialDesc& material, CaptureKind kind) {
    const MaterialHandle handle = renderer->createMaterial(material).value();
    Instance instance;
    instance.mesh = plane_;
    instance.material = handle;
    instances = {instance};
    const CapturedImage image = LitFrame::render(kind);
    renderer->destroy(handle);
    return image;
}

std::vector<vec3> LitPlane::irradiance() {
    MaterialDesc material;
    material.metallic = 0;
    const CapturedImage white = render(material);
    material.baseColor = {0, 0, 0, 1};
    const CapturedImage black = render(material);
    SerialJobs jobs;
    const vec2 table = makeBrdfTable(jobs).lookUp(1, 1);
    const vec3 albedo = interop::makeShadingPoint(vec3(0), 0, 1, {0, 0, 1}, {0, 0, 1}, table)
                            .specularAlbedo;
    std::vector<vec3> result;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x)
            result.push_back((pixelOf(white, x, y) - pixelOf(black, x, y)) *
                             (kPi / (1 - albedo.x)));
    return result;
}

vec3 LitPlane::pointOf(uint32_t x, uint32_t y) {
    return {(2 * (float(x) + 0.5f) / kSide - 1) * kHalf, 0,
            (2 * (float(y) + 0.5f) / kSide - 1) * kHalf};
}

void LitPlane::expectIrradiance(const std::function<float(vec3)>& expected, float least) {
    const std::vector<vec3> got = irradiance();
    ASSERT_EQ(got.size(), size_t(kSide) * kSide);
    float worst = 0;
    size_t compared = 0;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const float truth = expected(pointOf(x, y)), value = got[y * kSide + x].x;
            if (truth < 0) continue;
            if (truth <= least) {
                EXPECT_LE(value, least * 1.1f + 1e-4f) << x << " " << y;
                continue;
            }
            worst = std::max(worst, std::abs(value / truth - 1));
            ++compared;
        }
    EXPECT_LT(worst, 0.01f);
    EXPECT_GT(compared, 500u);
}

}  // namespace rushlight
