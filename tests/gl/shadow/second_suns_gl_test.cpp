// Several suns that cast shadows at once.

#include "tests/support/scenes/lit_frame.h"
#include "tests/support/scenes/ray_scene.h"

#include <array>

namespace rushlight {
namespace {

constexpr uint32_t kSide = 96;
constexpr float kHalf = 2;

// A box that floats above the ground, and a camera below it that looks down.
class SecondSunsGl : public LitFrame {
protected:
    SecondSunsGl() : LitFrame(kSide, kSide) {}

    void SetUp() override {
        LitFrame::SetUp();
        MaterialDesc matte;
        matte.metallic = 0;
        const MaterialHandle material = *renderer->createMaterial(matte);
        addBox({0, -0.5f, 0}, {6, 0.5f, 6}, material);
        addBox({0, 1, 0}, {0.3f, 0.05f, 0.3f}, material);
        lookDown(kHalf, 0.5f);
        input.settings.dither = false;
        input.settings.antiAliasing = AntiAliasing::off;
        // The way they travel takes the box's shadow to (1, 0), (0, 1), (-1, 0) and (0, -1).
        const vec3 ways[] = {{1, -1, 0}, {0, -1, 1}, {-1, -1, 0}, {0, -1, -1}};
        for (size_t i = 0; i < suns.size(); ++i) {
            suns[i].direction = glm::normalize(ways[i]);
            suns[i].illuminance = vec3(1 + float(i));
        }
    }
    void use(size_t count) { input.lighting.directional = std::span(suns).first(count); }
    static float at(const CapturedImage& image, float x, float z) {
        const auto pixel = [](float v) { return uint32_t((v / kHalf + 1) / 2 * kSide); };
        return pixelOf(image, pixel(x), pixel(z)).x;
    }
    /// What of the open ground's light is missing where each sun's shadow falls.
    std::array<float, 4> missing() {
        const CapturedImage image = render();
        const float open = at(image, 1, 1);
        EXPECT_GT(open, 0.1f);
        return {1 - at(image, 1, 0) / open, 1 - at(image, 0, 1) / open, 1 - at(image, -1, 0) / open,
                1 - at(image, 0, -1) / open};
    }

    std::array<DirectionalLight, 4> suns;
};

TEST_F(SecondSunsGl, EachCastsAShadowAtItsPlace) {
    for (const ShadowFilter filter : {ShadowFilter::hard, ShadowFilter::pcf, ShadowFilter::soft}) {
        input.settings.shadowFilter = filter;
        use(2);
        auto gone = missing();
        EXPECT_NEAR(gone[0], 1.0f / 3, 0.01f);
        EXPECT_NEAR(gone[1], 2.0f / 3, 0.01f);
        EXPECT_NEAR(gone[2], 0, 0.01f);
        use(4);
        gone = missing();
        for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(gone[i], float(i + 1) / 10, 0.01f) << i;
    }
}

// Suns at heights of their own over boxes in no order: no map could stand for another one's.
TEST_F(SecondSunsGl, ShadowsLieWhereRaysSay) {
    const vec3 towards[] = {{-0.4f, 1, 0.1f}, {0.2f, 1, -0.7f}, {0.9f, 1, 0.3f}, {-0.2f, 1, 0.4f}};
    const vec3 boxes[] = {{-0.9f, 0.8f, 0.4f},
                          {0.7f, 1, 0.9f},
                          {0.3f, 0.7f, -0.8f},
                          {-0.5f, 1.2f, -1.1f},
                          {1.3f, 0.9f, -0.2f}};
    RayScene scene(*renderer);
    scene.addBox({-6, -1, -6}, {6, 0, 6}, instances[0].material);
    for (const vec3& box : boxes)
        scene.addBox(box - vec3(0.3f, 0.05f, 0.2f), box + vec3(0.3f, 0.05f, 0.2f),
                     instances[0].material);
    const std::span<const Instance> all = scene.instances();
    std::array<float, 4> open{};
    for (size_t i = 0; i < suns.size(); ++i) {
        suns[i].direction = -glm::normalize(towards[i]);
        instances = {all[0]};
        input.lighting.directional = std::span(suns).subspan(i, 1);
        open[i] = at(render(), 0, 0);
    }
    instances.assign(all.begin(), all.end());
    // Where a shadow's edge is near, the filter decides.
    const float near = 0.05f;
    const auto reaches = [&](const vec3& point, size_t sun) {
        int lit = 0;
        for (const float x : {-near, 0.0f, near})
            for (const float z : {-near, 0.0f, near})
                lit += !scene.cast(point + vec3(x, 1e-3f, z), glm::normalize(towards[sun]));
        return lit == 0 ? 0.0f : lit == 9 ? 1.0f : -1.0f;
    };
    for (const size_t count : {2u, 3u, 4u}) {
        use(count);
        const CapturedImage image = render();
        std::array<uint32_t, 4> shadowed{};
        uint32_t wrong = 0, compared = 0;
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x) {
                const vec3 point((float(x) + 0.5f) / kSide * 2 * kHalf - kHalf, 0,
                                 (float(y) + 0.5f) / kSide * 2 * kHalf - kHalf);
                float want = 0;
                bool known = true;
                for (size_t i = 0; i < count; ++i) {
                    const float share = reaches(point, i);
                    known = known && share >= 0;
                    want += share * open[i];
                    shadowed[i] += share == 0;
                }
                compared += known;
                wrong += known && std::abs(pixelOf(image, x, y).x - want) > 0.01f * want + 1e-3f;
            }
        EXPECT_EQ(wrong, 0u) << count << " suns";
        EXPECT_GT(compared, kSide * kSide / 2);
        for (size_t i = 0; i < count; ++i) EXPECT_GT(shadowed[i], 200u) << "of the sun " << i;
    }
}

TEST_F(SecondSunsGl, ThoseThatCastNoneShineBetweenThem) {
    use(4);
    suns[0].castsShadow = suns[2].castsShadow = false;
    auto gone = missing();
    EXPECT_NEAR(gone[0], 0, 0.01f);
    EXPECT_NEAR(gone[1], 0.2f, 0.01f);
    EXPECT_NEAR(gone[2], 0, 0.01f);
    EXPECT_NEAR(gone[3], 0.4f, 0.01f);
    input.settings.shadows = false;
    for (const float share : missing()) EXPECT_NEAR(share, 0, 0.01f);
}

TEST_F(SecondSunsGl, OneCascadeAndLampsBesideThemToo) {
    input.settings.shadowCascades = 1;
    input.settings.lightShadows = true;
    use(2);
    PunctualLight lamp;  // straight above: its shadow is in the middle
    lamp.position = {0, 3, 0};
    lamp.intensity = vec3(9);
    lamp.castsShadow = true;
    const float before = at(render(), 0, 0);
    input.lighting.punctual = {&lamp, 1};
    const CapturedImage lit = render();
    EXPECT_NEAR(at(lit, 0, 0), before, 0.01f * before) << "the box hides the lamp";
    EXPECT_GT(at(lit, 1, 1), 1.2f * before);
    input.lighting.punctual = {};
    const auto gone = missing();
    EXPECT_NEAR(gone[0], 1.0f / 3, 0.01f);
    EXPECT_NEAR(gone[1], 2.0f / 3, 0.01f);
}

TEST_F(SecondSunsGl, EachKeepsItsMapsUntilItTurns) {
    use(3);
    const auto drawn = [&] {
        render();
        return renderer->report().shadowViewsDrawn;
    };
    EXPECT_EQ(drawn(), 8u) << "four cascades of the first, two of each other";
    EXPECT_EQ(drawn(), 0u);
    EXPECT_EQ(renderer->report().shadowViewsCached, 8u);
    suns[1].direction = glm::normalize(vec3(0.1f, -1, 1));
    EXPECT_EQ(drawn(), 2u);
    suns[0].direction = glm::normalize(vec3(1, -1, 0.1f));
    EXPECT_EQ(drawn(), 4u);
    instances[1].worldFromLocal[3].y += 0.1f;
    EXPECT_EQ(drawn(), 8u);
}

}  // namespace
}  // namespace rushlight
