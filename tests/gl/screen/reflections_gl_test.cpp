// Reflections of the screen against rays that a plane mirrors.

#include "tests/support/scenes/screen_frames.h"

#include <cmath>

namespace rushlight {
namespace {

class ReflectionsGl : public ScreenFrames {
protected:
    void SetUp() override {
        ScreenFrames::SetUp();
        input.settings.reflections = true;
    }
    MaterialHandle glowing(vec3 radiance) {
        MaterialDesc desc;
        desc.baseColor = vec4(0, 0, 0, 1);
        desc.metallic = 1;  // reflects nothing
        desc.emissive = radiance;
        return *renderer->createMaterial(desc);
    }
    MaterialHandle unlit(float radiance) {
        MaterialDesc desc;
        desc.baseColor = vec4(vec3(radiance), 1);
        desc.unlit = true;
        return *renderer->createMaterial(desc);
    }
    MaterialHandle metal(float roughness) {
        MaterialDesc desc;
        desc.roughness = roughness;
        return *renderer->createMaterial(desc);
    }
    /// A mirror on the ground, a wall behind it, and the camera over the mirror's near end.
    void buildHall(MaterialHandle floor, MaterialHandle wall) {
        scene->addBox({-30, -1, -6}, {30, 0, 9}, floor);
        scene->addBox({-30, -1, -7}, {30, 30, -6}, wall);
        look({0, 1.5f, 2}, {0, 1.2f, -6});
    }
    std::vector<float> radiance() { return render(CaptureKind::hdr).rgba32f; }
    static vec3 at(const std::vector<float>& image, uint32_t x, uint32_t y) {
        const float* texel = &image[(size_t(y) * kWidth + x) * 4];
        return {texel[0], texel[1], texel[2]};
    }
    struct Mirrored {
        RayHit hit;
        vec2 pixel;  ///< where the hit is seen, rows from the top
    };
    /// What a mirror at `seen` shows, if the camera sees that too.
    std::optional<Mirrored> mirrored(const CameraMatrices& view, const Seen& seen) const {
        const vec3 direction = glm::reflect(-seen.view, seen.normal);
        const auto hit = scene->cast(seen.position, direction, 1e-3f);
        if (!hit || glm::dot(hit->normal, direction) >= 0) return {};
        const vec3 point = seen.position + direction * hit->distance;
        const vec4 clip = view.clipFromWorld * vec4(point, 1);
        const vec2 uv = vec2(clip) / clip.w * 0.5f + 0.5f;
        if (clip.w <= 0 || glm::any(glm::lessThan(uv, vec2(0))) ||
            glm::any(glm::greaterThan(uv, vec2(1))))
            return {};
        const vec3 to = point - view.position;
        const auto first = scene->cast(view.position, glm::normalize(to));
        if (!first || first->distance < glm::length(to) - 0.01f) return {};
        return Mirrored{*hit, vec2(uv.x, 1 - uv.y) * vec2(kWidth, kHeight)};
    }
    /// Whether all about a pixel of the mirror shows the same object: the image of its edge is as
    /// coarse as the march.
    bool isInside(const CameraMatrices& view, uint32_t x, uint32_t y, uint32_t object) const {
        for (int dy : {-3, 3})
            for (int dx : {-3, 3}) {
                const uint32_t px = uint32_t(int(x) + dx), py = uint32_t(int(y) + dy);
                if (px >= kWidth || py >= kHeight) return false;
                const auto seen = seenAt(view, px, py);
                const auto truth = seen ? mirrored(view, *seen) : std::nullopt;
                if (!truth || truth->hit.object != object) return false;
            }
        return true;
    }
};

// Energy: a perfect mirror shows a wall of one radiance with that radiance, or leaves what was
// there.
TEST_F(ReflectionsGl, AMirrorShowsAWallOfOneRadianceWithThatRadiance) {
    const vec3 emitted(2, 1, 4);
    buildHall(metal(0), glowing(emitted));
    const std::vector<float> image = radiance();
    const CameraMatrices view = camera();
    uint32_t expected = 0, shown = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const auto seen = seenAt(view, x, y);
            if (!seen || seen->object != 0 || seen->normal.y < 0.9f) continue;
            const vec3 got = at(image, x, y);
            ASSERT_LT(glm::length(got / emitted -
                                  vec3(glm::dot(got, emitted) / glm::dot(emitted, emitted))),
                      0.03f)
                << "another colour at " << x << ", " << y;
            ASSERT_LT(got.x, emitted.x * 1.03f) << "more than there is at " << x << ", " << y;
            const auto wall = mirrored(view, *seen);
            const float edge = 0.1f;
            if (!wall || wall->pixel.x < edge * kWidth || wall->pixel.x > (1 - edge) * kWidth ||
                wall->pixel.y < edge * kHeight || seen->position.z < -5.8f)
                continue;
            ++expected;
            shown += std::abs(got.x / emitted.x - 1) < 0.03f;
        }
    std::printf("%u of %u mirror pixels show the wall\n", shown, expected);
    EXPECT_GT(expected, 3000u);
    EXPECT_GT(float(shown), 0.98f * float(expected));
}

// A furnace: where all there is to be seen is as bright as the surroundings, to know it better
// changes nothing.
TEST_F(ReflectionsGl, WhatIsAsBrightAsTheSurroundingsChangesNothing) {
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0.5f);
    for (const float roughness : {0.0f, 0.3f, 0.5f}) {
        SCOPED_TRACE(roughness);
        scene = std::make_unique<RayScene>(*renderer);
        buildHall(metal(roughness), unlit(0.5f));
        const std::vector<float> with = radiance();
        input.settings.reflections = false;
        const std::vector<float> without = radiance();
        input.settings.reflections = true;
        float worst = 0;
        for (size_t i = 0; i < with.size(); ++i)
            worst = std::max(worst, std::abs(with[i] - without[i]));
        EXPECT_LT(worst, 0.005f);
    }
}

TEST_F(ReflectionsGl, AMirrorShowsWhatRaysFind) {
    scene->addBox({-30, -1, -6}, {30, 0, 9}, metal(0));
    std::vector<vec3> colors = {vec3(0)};
    const auto add = [&](vec3 low, vec3 high, vec3 color) {
        scene->addBox(low, high, glowing(color));
        colors.push_back(color);
    };
    add({-30, -1, -7}, {30, 30, -6}, {1, 1, 1});
    add({-2, 0, -4}, {-1, 1.5f, -3}, {4, 0, 0});
    add({-0.4f, 0.5f, -5}, {0.4f, 1.3f, -4.5f}, {0, 4, 0});  // in the air
    add({1.2f, 0, -3}, {1.6f, 2, -2.6f}, {0, 0, 4});
    look({0, 1.5f, 2}, {0, 0.8f, -6});
    const std::vector<float> image = radiance();
    const CameraMatrices view = camera();
    uint32_t compared = 0, right = 0, missing = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const auto seen = seenAt(view, x, y);
            if (!seen || seen->object != 0 || seen->normal.y < 0.9f) continue;
            const auto truth = mirrored(view, *seen);
            if (!truth || truth->hit.object == 0) continue;
            if (!isInside(view, x, y, truth->hit.object)) continue;
            if (truth->pixel.x < 26 || truth->pixel.x > kWidth - 26 || truth->pixel.y < 20)
                continue;
            const vec3 got = at(image, x, y), wanted = colors[truth->hit.object];
            ++compared;
            right += glm::length(got - wanted) < 0.15f * glm::length(wanted);
            missing += glm::length(got) < 0.1f;
        }
    std::printf("of %u mirror pixels %u are right, %u show nothing\n", compared, right, missing);
    EXPECT_GT(compared, 4000u);
    EXPECT_GT(float(right), 0.97f * float(compared));
}

// A bar before the camera crosses the way of rays on the screen. They pass far behind it, and go on
// to the wall.
TEST_F(ReflectionsGl, RaysPassBehindWhatIsFarBeforeThem) {
    const vec3 wall(1, 2, 4), red(8, 0, 0);
    buildHall(metal(0), glowing(wall));
    scene->addBox({-9, 1.15f, 0.9f}, {9, 1.22f, 0.95f}, glowing(red));
    const std::vector<float> image = radiance();
    const CameraMatrices view = camera();
    uint32_t compared = 0, right = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 26; x < kWidth - 26; ++x) {
            const auto seen = seenAt(view, x, y);
            if (!seen || seen->object != 0 || seen->normal.y < 0.9f || seen->position.z < -5.8f)
                continue;
            const auto truth = mirrored(view, *seen);
            if (!truth || truth->hit.object != 1 || !isInside(view, x, y, 1)) continue;
            // Between the pixel and where its wall is seen lies the bar.
            bool crosses = false;
            for (uint32_t row = uint32_t(truth->pixel.y); row < y; ++row) {
                const auto between = seenAt(view, x, row);
                crosses = crosses || (between && between->object == 2);
            }
            if (!crosses || truth->pixel.y < 20) continue;
            const vec3 got = at(image, x, y);
            ASSERT_LT(got.x, 1.1f) << "the bar is mirrored at " << x << ", " << y;
            ++compared;
            right += glm::length(got - wall) < 0.05f * glm::length(wall);
        }
    std::printf("of %u rays behind the bar %u reach the wall\n", compared, right);
    EXPECT_GT(compared, 1000u);
    EXPECT_GT(float(right), 0.97f * float(compared));
}

// A thin board whose front glows and whose back does not, before a mirror: where that shows the
// back, nobody has seen it.
TEST_F(ReflectionsGl, TheFrontOfThingsIsNotMirroredAsTheirBack) {
    scene->addBox({-9, -1, -5}, {9, 9, -4}, metal(0));
    scene->addBox({-0.6f, 0.4f, -2.98f}, {0.6f, 1.6f, -2.96f}, glowing({4, 4, 4}));
    scene->addBox({-0.6f, 0.4f, -3}, {0.6f, 1.6f, -2.98f}, glowing(vec3(0)));
    look({2.2f, 1, 2}, {0.3f, 1, -4});
    const std::vector<float> image = radiance();
    const CameraMatrices view = camera();
    uint32_t backs = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const auto seen = seenAt(view, x, y);
            if (!seen || seen->object != 0) continue;
            const auto hit = scene->cast(seen->position, glm::reflect(-seen->view, seen->normal),
                                         1e-3f);
            backs += hit && hit->object == 2;
            ASSERT_LT(at(image, x, y).x, 0.01f) << "the front is mirrored at " << x << ", " << y;
        }
    EXPECT_GT(backs, 500u);
}

TEST_F(ReflectionsGl, ARoughSurfaceKeepsItsSurroundings) {
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0.5f);
    buildHall(metal(0.65f), unlit(1));
    const std::vector<float> with = radiance();
    input.settings.reflections = false;
    EXPECT_EQ(with, radiance());
}

TEST_F(ReflectionsGl, AFrameThatAsksForNoneHasNoPassOfIt) {
    buildHall(metal(0), unlit(1));
    for (const bool on : {true, false}) {
        input.settings.reflections = on;
        render(CaptureKind::display);
        for (const char* pass :
             {"pyramid.base", "pyramid.levels", "reflections.trace", "reflections"})
            EXPECT_EQ(hasPass(pass), on) << pass;
    }
}

TEST_F(ReflectionsGl, EverySizeAndViewGivesFiniteNumbersAndTheSameBytes) {
    input.lighting.ambientSky = vec3(1);
    input.settings.ambientOcclusion = AmbientOcclusion::medium;
    buildHall(metal(0.1f), glowing({6e4f, 1, 0}));
    scene->addBall({0.3f, 0.6f, -2}, 0.6f, metal(0.05f));
    input.instances = scene->instances();
    for (const bool perspective : {true, false})
        for (const uvec2 size : {uvec2(1, 1), uvec2(2, 3), uvec2(37, 23), uvec2(129, 65)})
            for (const vec3 eye : {vec3(0, 1.5f, 2), vec3(0.3f, 40, -2), vec3(9, 0.01f, 4)}) {
                input.view.perspective = perspective;
                input.view.orthoHalfHeight = 3;
                input.view.farPlane = 100;
                look(eye, {0.3f, 0.4f, -2});
                std::vector<float> first;
                for (int repeat = 0; repeat < 2; ++repeat) {
                    const auto ticket = renderer->renderOffscreen(input, size.x, size.y,
                                                                  CaptureKind::hdr);
                    ASSERT_TRUE(ticket) << ticket.error().text();
                    CapturedImage image;
                    ASSERT_TRUE(renderer->takeCapture(*ticket, true, image));
                    for (const float value : image.rgba32f) ASSERT_TRUE(std::isfinite(value));
                    if (repeat == 0) first = image.rgba32f;
                    EXPECT_EQ(image.rgba32f, first);
                }
            }
}

}  // namespace
}  // namespace rushlight
