// Pixels explained: the measured shares, put through exposure and tone map, are the pixel.
#include "renderer/answers/explain.h"

#include "renderer/testing/scene_frames.h"
#include "tests/support/random.h"
#include "tests/support/scenes/lit_frame.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace rushlight {
namespace {

constexpr float kCode = 1.0f / 255 + 1e-5f;

class Explain : public LitFrame {
protected:
    Explain() : LitFrame(96, 64) {}

    void SetUp() override {
        LitFrame::SetUp();
        input.settings.bloom = true;
        input.view.viewFromWorld = glm::lookAt(vec3(0, 3, 6), vec3(0, 0.5f, 0), vec3(0, 1, 0));
    }
    std::vector<PixelExplanation> explained(std::span<const uvec2> pixels) {
        if (!instances.empty()) input.instances = instances;
        auto result = explain(*renderer, input, {width, height}, pixels);
        EXPECT_TRUE(result) << result.error().text();
        return result ? std::move(*result) : std::vector<PixelExplanation>{};
    }
    PixelExplanation explained(uvec2 pixel) { return explained(std::span(&pixel, 1)).at(0); }
    std::vector<uvec2> somePixels(size_t count, uint32_t seed) const {
        Random random(seed);
        std::vector<uvec2> pixels;
        for (size_t i = 0; i < count; ++i)
            pixels.push_back({random.below(width), random.below(height)});
        return pixels;
    }
    /// How many of them do not add up.
    size_t wrongSums(std::span<const PixelExplanation> pixels) {
        size_t wrong = 0;
        for (const PixelExplanation& p : pixels) {
            if (p.error <= kCode) continue;
            ++wrong;
            ADD_FAILURE() << "pixel " << p.pixel.x << "," << p.pixel.y << " is off by "
                          << p.error * 255 << " of 255: " << p.sum.x * 255 << " " << p.sum.y * 255
                          << " " << p.sum.z * 255 << ", shown " << int(p.shown[0]) << " "
                          << int(p.shown[1]) << " " << int(p.shown[2]);
        }
        return wrong;
    }
    void explainScene(const std::string& scene, const SceneView& view, size_t count,
                      const std::string& environment = {}) {
        width = view.width, height = view.height;
        auto frames = SceneFrames::open(*renderer, scene, environment);
        ASSERT_TRUE(frames) << frames.error().text();
        ASSERT_TRUE((*frames)->fill(view, input));
        if (fog > 0) input.lighting.fog.density = fog;
        const auto pixels = explained(somePixels(count, 7));
        ASSERT_EQ(pixels.size(), count);
        EXPECT_EQ(wrongSums(pixels), 0u);
        brightest = 0;
        for (const PixelExplanation& p : pixels)
            for (const LightShare& light : p.lights)
                brightest = std::max(brightest, light.radiance.g);
        input.instances = {};
    }
    float fog = 0;
    float brightest = 0;  ///< share of a light that was found
};

TEST_F(Explain, RandomPixelsOfTheTestCardAddUp) {
    SceneView view;
    explainScene(RUSHLIGHT_SOURCE "/content/testcard/testcard.gltf", view, 400);
    EXPECT_GT(brightest, 0.0f);
}

TEST_F(Explain, RandomPixelsOfTheSquareWithEverythingOnAddUp) {
    SceneView view;
    view.width = 240, view.height = 135;
    view.settings.lightShadows = true;
    view.settings.ambientOcclusion = AmbientOcclusion::medium;
    view.settings.reflections = true;
    view.settings.contactShadows = ContactShadows::lights;
    view.settings.toneMap = ToneMap::aces;
    fog = 0.01f;
    explainScene(RUSHLIGHT_SOURCE "/content/square/square.gltf", view, 400,
                 RUSHLIGHT_SOURCE "/content/square/dusk.hdr");
    EXPECT_GT(brightest, 0.0f);
}

TEST_F(Explain, RandomPixelsUnderAutomaticExposureAddUp) {
    SceneView view;
    view.width = 160, view.height = 90;
    view.settings.autoExposure = true;
    view.settings.toneMap = ToneMap::agx;
    explainScene(RUSHLIGHT_SOURCE "/content/square/square.gltf", view, 200,
                 RUSHLIGHT_SOURCE "/content/square/dusk.hdr");
}

/// A floor, a box on it, a pane before the box; a sun, a lamp and an area light.
class ExplainRoom : public Explain {
protected:
    void SetUp() override {
        Explain::SetUp();
        MaterialDesc red;
        red.baseColor = vec4(0.8f, 0.1f, 0.1f, 1);
        red.metallic = 0;
        red.roughness = 0.4f;
        red.emissive = vec3(0.02f, 0, 0.01f);
        MaterialDesc floor;
        floor.baseColor = vec4(0.5f, 0.5f, 0.5f, 1);
        floor.metallic = 0;
        MaterialDesc pane;
        pane.baseColor = vec4(0.1f, 0.3f, 0.8f, 0.4f);
        pane.metallic = 0;
        pane.alphaMode = AlphaMode::blend;
        addBox(vec3(0, -0.1f, 0), vec3(5, 0.1f, 5), *renderer->createMaterial(floor)).id = 11;
        addBox(vec3(0, 0.5f, 0), vec3(0.5f), *renderer->createMaterial(red)).id = 22;
        addBox(vec3(1.6f, 0.6f, 1), vec3(0.5f, 0.5f, 0.02f), *renderer->createMaterial(pane))
            .id = 33;
        suns[0].direction = glm::normalize(vec3(-1, -1, -0.2f));
        suns[0].illuminance = vec3(2, 1.9f, 1.7f);
        lamps[0].position = vec3(-2, 1.5f, 1);
        lamps[0].intensity = vec3(1, 2, 4);
        lamps[0].castsShadow = true;
        panels[0].position = vec3(0, 3, 2);
        panels[0].halfY = vec3(0, 0, -0.5f);
        panels[0].halfX = vec3(-0.5f, 0, 0);
        panels[0].luminance = vec3(2);
        input.lighting.directional = suns;
        input.lighting.punctual = lamps;
        input.lighting.area = panels;
        input.lighting.ambientSky = vec3(0.1f, 0.15f, 0.2f);
        input.lighting.ambientGround = vec3(0.05f);
        input.settings.lightShadows = true;
    }
    /// The pixel where a point of the world is.
    uvec2 pixelOfPoint(const vec3& point) const {
        const vec4 view = input.view.viewFromWorld * vec4(point, 1);
        const float t = std::tan(input.view.verticalFov / 2);
        const vec2 ndc = vec2(view) / -view.z / vec2(t * float(width) / float(height), t);
        return uvec2((ndc.x * 0.5f + 0.5f) * float(width), (0.5f - ndc.y * 0.5f) * float(height));
    }
    std::array<DirectionalLight, 1> suns;
    std::array<PunctualLight, 1> lamps;
    std::array<AreaLight, 1> panels;
};

TEST_F(ExplainRoom, EveryPixelAddsUp) {
    std::vector<uvec2> all;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) all.push_back({x, y});
    EXPECT_EQ(wrongSums(explained(all)), 0u);
}

TEST_F(ExplainRoom, AWrongShareDoesNotAddUp) {
    PixelExplanation p = explained(pixelOfPoint(vec3(0, 1, 0)));
    ASSERT_LE(p.error, kCode);
    ASSERT_EQ(p.lights.size(), 3u);
    for (vec3* share : {&p.lights[0].radiance, &p.lights[1].radiance, &p.ambientDiffuse}) {
        const vec3 right = *share;
        *share *= 1.2f;
        addUp(p, input, {width, height});
        EXPECT_GT(p.error, kCode);
        *share = right;
    }
    p.exposure *= 1.1f;
    addUp(p, input, {width, height});
    EXPECT_GT(p.error, kCode);
}

TEST_F(ExplainRoom, TheSurfaceIsThatOfThePixel) {
    const PixelExplanation box = explained(pixelOfPoint(vec3(0, 1, 0)));
    ASSERT_TRUE(box.surface && box.surface->object);
    EXPECT_EQ(box.surface->object->instance.id, 22u);
    EXPECT_NEAR(box.surface->position.y, 1, 0.05f);
    EXPECT_NEAR(box.surface->baseColor.r, 0.8f, 0.02f);
    EXPECT_NEAR(box.surface->roughness, 0.4f, 0.01f);
    EXPECT_NEAR(box.surface->normal.y, 1, 0.02f);
    EXPECT_NEAR(box.emissive.r, 0.02f, 0.004f);
    EXPECT_FALSE(box.blended);
    const PixelExplanation floor = explained(pixelOfPoint(vec3(-2, 0, -1)));
    ASSERT_TRUE(floor.surface && floor.surface->object);
    EXPECT_EQ(floor.surface->object->instance.id, 11u);
    const PixelExplanation pane = explained(pixelOfPoint(vec3(1.6f, 0.8f, 1)));
    ASSERT_TRUE(pane.blended);
    EXPECT_EQ(pane.blended->instance.id, 33u);
    EXPECT_NE(pane.blendedSurfaces, vec3(0));
}

TEST_F(ExplainRoom, TheSunsShareIsHiddenInTheBoxesShadow) {
    // The sun comes from +x: the floor at -x of the box is in its shadow.
    const auto sunOf = [&](const vec3& point) {
        const auto p = explained(pixelOfPoint(point));
        for (const LightShare& light : p.lights)
            if (light.kind == LightKind::sun) return light;
        ADD_FAILURE() << "the sun is not listed";
        return LightShare{};
    };
    const LightShare shadowed = sunOf(vec3(-0.9f, 0, 0)), open = sunOf(vec3(2.5f, 0, 2));
    EXPECT_LT(shadowed.shadow, 0.02f);
    EXPECT_EQ(shadowed.radiance.g < 0.01f, true);
    EXPECT_GT(open.shadow, 0.98f);
    EXPECT_GT(open.radiance.g, 0.1f);
}

TEST_F(ExplainRoom, TheBackgroundIsTheBackground) {
    input.lighting.backgroundColor = vec3(0.2f, 0.3f, 0.4f);
    input.settings.bloom = false;
    input.view.viewFromWorld = glm::lookAt(vec3(0, 3, 6), vec3(0, 9, 0), vec3(0, 1, 0));
    const PixelExplanation p = explained(uvec2(5, 5));
    EXPECT_FALSE(p.surface);
    EXPECT_TRUE(p.lights.empty());
    EXPECT_NEAR(p.background.g, 0.3f, 0.001f);
    EXPECT_LE(p.error, kCode);
}

TEST_F(ExplainRoom, KeptWorldsAreExplainedAsGivenInstances) {
    const WorldHandle world = renderer->createWorld();
    std::vector<InstanceHandle> handles(instances.size());
    ASSERT_TRUE(renderer->addInstances(world, instances, handles));
    instances.clear();
    input.instances = {};
    input.world = world;
    const PixelExplanation pane = explained(pixelOfPoint(vec3(1.6f, 0.8f, 1)));
    ASSERT_TRUE(pane.blended && pane.surface && pane.surface->object);
    EXPECT_EQ(pane.blended->instance.id, 33u);
    EXPECT_TRUE(pane.blended->kept);
    EXPECT_LE(pane.error, kCode);
}

TEST_F(ExplainRoom, APixelOutsideIsAnError) {
    input.instances = instances;
    const uvec2 outside(width, 0);
    const auto result = explain(*renderer, input, {width, height}, std::span(&outside, 1));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::wrongUse);
}

}  // namespace
}  // namespace rushlight
