// The sun's shadows where one cascade fades into the next, and light on triangles that face away
// from it.

#include "interop/frame_uniforms.h"
#include "renderer/visibility/shadow_cascades.h"
#include "tests/support/scenes/lit_frame.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

class SunShadowsGl : public LitFrame {
protected:
    SunShadowsGl() : LitFrame(32, 32) {}

    void SetUp() override {
        LitFrame::SetUp();
        matte.metallic = 0;
        input.settings.dither = false;
        input.settings.antiAliasing = AntiAliasing::off;
        sun.illuminance = vec3(3);
    }
    void shine() { input.lighting.directional = {&sun, 1}; }

    MaterialDesc matte;
    DirectionalLight sun;
};

// An edge's shadow is as wide as texels are: sharp in a cascade, blurred in the next. Along the
// edge the light goes from the one to the other in the band and in no other place, in equal steps.
TEST_F(SunShadowsGl, ACascadeFadesIntoTheNextAlongItsBand) {
    width = 8;
    height = 256;
    const float half = 6, reach = 100;
    const MaterialHandle material = *renderer->createMaterial(matte);
    addBox({0, -1, 0}, {reach, 1, reach}, material).flags = 0;
    const size_t roof = instances.size();
    addBox({}, {10, 0.5f, reach}, material);
    sun.direction = {0, -1, 0};
    shine();
    input.settings.shadowCascades = 2;
    input.settings.shadowResolution = 128;
    input.settings.shadowDistance = 30;
    input.view.perspective = false;
    input.view.orthoHalfHeight = half;
    input.view.farPlane = 60;
    input.view.viewFromWorld = glm::lookAt(vec3(0, 10, 10), vec3(0), vec3(0, 1, 0));

    const CameraMatrices camera = *makeCamera(input.view, float(width) / float(height));
    ShadowCascadeDesc desc;
    desc.lightDirection = sun.direction;
    desc.count = 2;
    desc.resolution = input.settings.shadowResolution;
    desc.distance = input.settings.shadowDistance;
    desc.sceneBounds.low = {-reach, -2, -reach};
    desc.sceneBounds.high = {reach, 9, reach};
    const ShadowCascades cascades = makeShadowCascades(camera, desc);
    const auto shareOfTheFirst = [&](float z) {
        const ShadowCascade& c = cascades.cascades[0];
        const vec3 point(0, 0, z);
        const vec2 metres(glm::dot(vec3(cascades.rows[0]), point),
                          glm::dot(vec3(cascades.rows[1]), point));
        const vec2 away = glm::abs(metres * c.uvPerMetre + c.uvOffset - 0.5f);
        const float inside = 0.5f - float(RL_SHADOW_RIM) / float(desc.resolution) -
                             std::max(away.x, away.y);
        return std::clamp(inside / float(RL_CASCADE_BAND), 0.0f, 1.0f);
    };
    float mostApart = 0;
    uint32_t inBand = 0;
    for (const float edge : {0.05f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.35f}) {
        instances[roof].worldFromLocal[3] = {-10 - edge, 8, 0};
        const CapturedImage image = render();
        const auto light = [&](uint32_t y) { return pixelOf(image, width / 2, y).x; };
        const float first = light(height - 2), next = light(1);
        mostApart = std::max(mostApart, std::abs(first - next));
        for (uint32_t y = 1; y + 1 < height; ++y) {
            const float z = ((float(y) + 0.5f) / float(height) * 2 - 1) * half * std::sqrt(2.0f);
            const float share = shareOfTheFirst(z);
            inBand += share > 0.05f && share < 0.95f;
            ASSERT_NEAR(light(y), glm::mix(next, first, share),
                        0.03f * std::abs(first - next) + 2e-3f)
                << "row " << y << ", share " << share << ", edge " << edge;
        }
    }
    std::printf("%u rows in bands, cascades up to %.3f apart\n", inBand, double(mostApart));
    EXPECT_GT(inBand, 30u);
    EXPECT_GT(mostApart, 0.1f);
}

// A sheet with normals that lean towards the light, as those of a smooth body at its terminator do.
// What is below the horizon of a flat sheet does not reach its upper side, however its normals
// lean.
TEST_F(SunShadowsGl, NoLightComesThroughATriangleFromBehind) {
    const std::vector<vec3> corners{{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
    const std::vector<uint32_t> indices{0, 1, 2, 0, 2, 3};
    MeshDesc desc;
    desc.label = "leaning sheet";
    desc.positions = corners;
    desc.indices = indices;
    const auto leaning = [&](float lean) {
        const std::vector<vec3> normals(4, vec3(std::sin(lean), std::cos(lean), 0));
        desc.normals = normals;
        return *renderer->createMesh(desc);
    };
    Instance sheet;
    lookDown(1, 5);
    input.settings.lightShadows = true;
    PunctualLight lamp;
    lamp.castsShadow = true;
    lamp.intensity = vec3(100);
    matte.doubleSided = true;
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend})
        for (const bool casts : {false, true})
            for (const bool lampInstead : {false, true}) {
                SCOPED_TRACE(testing::Message() << "blended " << (mode == AlphaMode::blend)
                                                << ", casts " << casts << ", lamp " << lampInstead);
                // The G-buffer knows triangles by the depths around them, and only where those
                // agree with its normal.
                const float lean = mode == AlphaMode::blend ? 0.7f : 0.35f;  // radians
                sheet.mesh = leaning(lean);
                matte.alphaMode = mode;
                sheet.material = *renderer->createMaterial(matte);
                sheet.flags = casts ? uint32_t(kInstanceCastsShadow) : 0;
                instances = {sheet};
                const auto lightFrom = [&](float elevation) {
                    const vec3 towards(std::cos(elevation), std::sin(elevation), 0);
                    sun.direction = -towards;
                    lamp.position = 20.0f * towards;
                    if (lampInstead)
                        input.lighting.punctual = {&lamp, 1};
                    else
                        input.lighting.directional = {&sun, 1};
                    const float got = centre().x;
                    input.lighting.punctual = {};
                    input.lighting.directional = {};
                    return got;
                };
                EXPECT_GT(lightFrom(0.3f), 0.01f);
                for (const float below : {0.1f, 0.15f, 0.2f, 0.3f})
                    EXPECT_LT(lightFrom(-below), 1e-4f)
                        << below << " below; its normals see it at " << std::sin(lean - below);
            }
}

}  // namespace
}  // namespace rushlight
