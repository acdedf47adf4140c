// Light through coloured panes: what is seen behind them, and what falls behind them.

#include "engine/core/jobs.h"
#include "interop/brdf.h"
#include "renderer/lighting/brdf_table.h"
#include "tests/support/scenes/lit_frame.h"

namespace rushlight {
namespace {

constexpr uint32_t kSide = 96;
constexpr float kHalf = 2;
constexpr vec3 kRed{0.9f, 0.3f, 0.2f}, kGreen{0.2f, 0.8f, 0.4f};
constexpr float kShare = 0.75f;
constexpr ShadowFilter kFilters[] = {ShadowFilter::hard, ShadowFilter::pcf, ShadowFilter::soft};

// White ground, a sun straight above, and panes between it and a camera that looks down from below
// them.
class GlassGl : public LitFrame {
protected:
    GlassGl() : LitFrame(kSide, kSide) {}

    void SetUp() override {
        LitFrame::SetUp();
        white = opaque();
        addBox({0, -0.5f, 0}, {6, 0.5f, 6}, white);
        lookDown(kHalf, 0.5f);
        input.settings.dither = false;
        input.settings.antiAliasing = AntiAliasing::off;
        input.settings.lightShadows = true;
        sun.direction = {0, -1, 0};
        sun.illuminance = vec3(3);
    }
    MaterialHandle opaque() {
        MaterialDesc desc;
        desc.metallic = 0;
        return *renderer->createMaterial(desc);
    }
    static MaterialDesc glassDesc(const vec3& color) {
        MaterialDesc desc;
        desc.baseColor = vec4(color, 1);
        desc.metallic = 0;
        desc.transmission = kShare;
        return desc;
    }
    MaterialHandle glass(const vec3& color) { return *renderer->createMaterial(glassDesc(color)); }
    /// One metre wide, over the middle of the ground.
    size_t addPane(float y, const vec3& color, float halfSize = 0.5f) {
        addBox({0, y, 0}, {halfSize, 0.02f, halfSize}, glass(color));
        return instances.size() - 1;
    }
    void shine() { input.lighting.directional = {&sun, 1}; }
    void shine(PunctualLight light) {
        lamp = light;
        lamp.position = {0, 3, 0};
        lamp.direction = {0, -1, 0};
        lamp.intensity = vec3(20);
        lamp.castsShadow = true;
        input.lighting.punctual = {&lamp, 1};
    }
    static vec3 at(const CapturedImage& image, float x, float z) {
        const auto pixel = [](float v) { return uint32_t((v / kHalf + 1) / 2 * kSide); };
        return pixelOf(image, pixel(x), pixel(z));
    }
    /// Of the light that a frame without anything above the ground has there.
    vec3 share(float x = 0, float z = 0) {
        const CapturedImage image = render();
        const std::vector<Instance> all = instances;
        instances.resize(1);
        const CapturedImage open = render();
        instances = all;
        return at(image, x, z) / at(open, x, z);
    }
    static void expectColor(const vec3& got, const vec3& wanted, const char* what = "") {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], wanted[c], 0.02f * wanted[c] + 1e-4f) << what << " channel " << c;
    }
    /// One pane and two; an opaque box before them and behind them; the ground beside them.
    void expectColoredShadows() {
        for (const ShadowFilter filter : kFilters) {
            input.settings.shadowFilter = filter;
            instances.resize(1);
            addPane(1.2f, kRed);
            expectColor(share(), kRed * kShare, "one");
            expectColor(share(1.6f, 1.6f), vec3(1), "outside");
            addPane(0.9f, kGreen);
            expectColor(share(), kRed * kGreen * (kShare * kShare), "two");
            for (const float y : {0.7f, 1.05f, 1.4f}) {
                addBox({0, y, 0}, {0.15f, 0.02f, 0.15f}, white);
                expectColor(share(), vec3(0), "hidden");
                expectColor(share(0.4f, 0.4f), kRed * kGreen * (kShare * kShare),
                            "beside what hides");
                instances.pop_back();
            }
        }
    }

    MaterialHandle white;
    DirectionalLight sun;
    PunctualLight lamp;
};

TEST_F(GlassGl, TheSunTakesTheColoursOfAllPanes) {
    shine();
    expectColoredShadows();
}

TEST_F(GlassGl, ASpotLightDoes) {
    PunctualLight spot;
    spot.innerConeAngle = 0.7f;
    spot.outerConeAngle = 0.9f;
    shine(spot);
    expectColoredShadows();
}

TEST_F(GlassGl, APointLightDoes) {
    shine(PunctualLight{});
    expectColoredShadows();
}

TEST_F(GlassGl, AnAreaLightDoes) {
    AreaLight light;
    light.position = {0, 3, 0};
    light.halfX = {0.05f, 0, 0};
    light.halfY = {0, 0, 0.05f};
    light.twoSided = true;
    light.luminance = vec3(1000);
    light.castsShadow = true;
    input.lighting.area = {&light, 1};
    for (const ShadowFilter filter : kFilters) {
        input.settings.shadowFilter = filter;
        instances.resize(1);
        addPane(1.2f, kRed);
        addPane(0.9f, kGreen);
        expectColor(share(), kRed * kGreen * (kShare * kShare), "two");
        expectColor(share(1.8f, 1.8f), vec3(1), "outside");
    }
}

TEST_F(GlassGl, ASecondSunDoesToo) {
    const DirectionalLight suns[] = {
        {.direction = glm::normalize(vec3(1, -1, 0)), .illuminance = vec3(2)},
        {.direction = glm::normalize(vec3(-1, -1, 0)), .illuminance = vec3(2)}};
    input.lighting.directional = suns;
    addPane(1, kRed, 0.3f);
    expectColor(share(1, 0), (vec3(1) + kRed * kShare) * 0.5f, "the first's");
    expectColor(share(-1, 0), (vec3(1) + kRed * kShare) * 0.5f, "the second's");
    expectColor(share(0, 1.5f), vec3(1), "outside");
}

TEST_F(GlassGl, WhatIsBeforeAPaneIsNotColoured) {
    shine();
    input.settings.shadowFilter = ShadowFilter::pcf;
    // A caster would hide the pane from the map itself.
    for (const bool lampInstead : {false, true}) {
        if (lampInstead) {
            input.lighting.directional = {};
            shine(PunctualLight{});
        }
        instances.resize(1);
        addPane(0.1f, kRed);
        addBox({0, 0.2f, 0}, {0.3f, 0.02f, 0.3f}, white).flags &= ~uint32_t(kInstanceCastsShadow);
        const vec3 colored = at(render(), 0, 0);
        instances.erase(instances.begin() + 1);
        expectColor(colored, at(render(), 0, 0), lampInstead ? "lamp" : "sun");
    }
}

TEST_F(GlassGl, APaneDoesNotColourTheLightOnItsFront) {
    instances[0].material = glowing(vec3(0));  // of what is behind nothing is seen
    shine();
    for (const ShadowFilter filter : kFilters) {
        input.settings.shadowFilter = filter;
        instances.resize(1);
        addPane(0.1f, kRed);
        const vec3 colored = at(render(), 0, 0);
        EXPECT_GT(colored.x, 0.05f);
        instances.back().flags &= ~uint32_t(kInstanceCastsShadow);
        expectColor(colored, at(render(), 0, 0));
    }
}

TEST_F(GlassGl, HolesAndCoverageLetLightThrough) {
    shine();
    MaterialDesc desc = glassDesc(kRed);
    desc.baseColor.w = 0.4f;
    addBox({0, 1, 0}, {0.5f, 0.02f, 0.5f}, *renderer->createMaterial(desc));
    expectColor(share(), kRed * kShare, "alpha of an opaque material is nothing");
    desc.alphaMode = AlphaMode::blend;
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), glm::mix(vec3(1), kRed * kShare, 0.4f), "coverage");
    desc.alphaMode = AlphaMode::mask;
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), vec3(1), "cut");
    desc.alphaCutoff = 0.3f;
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), kRed * kShare, "not cut");
    desc.transmissionColor = vec3(0.5f, 1, 0.25f);
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), kRed * desc.transmissionColor * kShare, "a body's colour");
    desc.metallic = 1;
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), vec3(0), "metal");
    desc.transmission = 0;
    desc.metallic = 0;
    desc.alphaMode = AlphaMode::blend;
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), vec3(1), "blended by alpha alone");
}

TEST_F(GlassGl, ATextureSaysWhereLightGoesThrough) {
    shine();
    // White where green and blue would say nothing: R alone counts.
    const std::vector<uint8_t> pixels{255, 0, 0, 255};
    ImageDesc image{"share", 1, 1, false, pixels};
    std::vector<uint8_t> half{128, 255, 255, 255};
    MaterialDesc desc = glassDesc(kRed);
    desc.transmissionTexture.image = *renderer->createImage(image);
    addBox({0, 1, 0}, {0.5f, 0.02f, 0.5f}, *renderer->createMaterial(desc));
    expectColor(share(), kRed * kShare);
    image.pixels = half;
    desc.transmissionTexture.image = *renderer->createImage(image);
    desc.transmissionTexture.offset = {0.25f, 0};
    instances.back().material = *renderer->createMaterial(desc);
    expectColor(share(), kRed * (kShare * 128 / 255));
}

TEST_F(GlassGl, BehindAPaneIsSeenThroughItsColour) {
    const vec3 light(1);  // the most that an unlit surface of the G-buffer has
    instances[0].material = glowing(light);
    SerialJobs jobs;
    const vec2 table = makeBrdfTable(jobs).lookUp(1, 1);
    const vec3 mirrored = interop::makeShadingPoint(vec3(0), 0, 1, {0, 0, 1}, {0, 0, 1}, table)
                              .specularAlbedo;
    const auto through = [&](const vec3& color) { return color * (vec3(1) - mirrored) * kShare; };
    addPane(0.1f, kRed);
    expectColor(centre(), light * through(kRed));
    addPane(0.3f, kGreen);
    expectColor(centre(), light * through(kRed) * through(kGreen));
    MaterialDesc blended;  // under the panes, half covered by what is black in the dark
    blended.baseColor = vec4(0, 0, 0, 0.5f);
    addBox({0, 0.03f, 0}, {0.5f, 0.01f, 0.5f}, *renderer->createMaterial([&] {
        blended.alphaMode = AlphaMode::blend;
        return blended;
    }()));
    expectColor(centre(), light * 0.5f * through(kRed) * through(kGreen));
}

// What goes through a pane is not scattered by it: of the diffuse light of an opaque surface of its
// colour, the share that it does not transmit is left, and what it mirrors.
TEST_F(GlassGl, WhatIsTransmittedIsNotScatteredToo) {
    instances[0].material = glowing(vec3(0));
    sun.direction = glm::normalize(vec3(0.5f, -1, 0.2f));
    shine();
    PunctualLight above;
    above.position = {0.5f, 2, 0.5f};
    above.intensity = vec3(5);
    input.lighting.punctual = {&above, 1};
    input.lighting.ambientSky = vec3(0.3f);
    addPane(0.1f, kRed);
    instances.back().flags = 0;
    const auto sent = [&](const vec3& color, float transmitted) {
        MaterialDesc desc = glassDesc(color);
        desc.transmission = transmitted;
        instances.back().material = *renderer->createMaterial(desc);
        return centre();
    };
    const vec3 mirrored = sent(vec3(0), 0), whole = sent(kRed, 0) - mirrored;
    EXPECT_GT(whole.x, 0.5f);
    for (const float transmitted : {0.25f, 0.5f, 1.0f})
        expectColor(sent(kRed, transmitted), mirrored + whole * (1 - transmitted),
                    "of what is left");
}

TEST_F(GlassGl, OverATransparentBackgroundAPaneCoversWhatItKeeps) {
    instances.clear();
    input.lighting.background = Background::transparent;
    addPane(0.1f, vec3(0.5f));
    const CapturedImage image = render();
    const float alpha = image.rgba32f[(size_t(kSide / 2) * kSide + kSide / 2) * 4 + 3];
    EXPECT_NEAR(alpha, 1 - 0.5f * kShare, 0.04f);
}

TEST_F(GlassGl, ColouredAirIsSeen) {
    shine();
    instances[0].material = glowing(vec3(0));
    input.lighting.fog.density = 0.3f;
    addPane(1.2f, vec3(1, 0.1f, 0.1f), 1.5f);
    const vec3 air = at(render(), 0, 0);
    EXPECT_GT(air.x, 0.005f);
    EXPECT_NEAR(air.y / air.x, 0.1f, 0.02f);
    instances.pop_back();
    const vec3 open = at(render(), 0, 0);
    EXPECT_NEAR(open.y / open.x, 1, 0.01f);
}

TEST_F(GlassGl, MapsAreDrawnWhenSomethingChangedAndNotOtherwise) {
    shine();
    addBox({-1.5f, 2, 0}, {0.1f, 0.1f, 0.1f}, white);
    const size_t pane = addPane(1, kRed, 0.3f);
    const auto drawn = [&] {
        render();
        return renderer->report().shadowViewsDrawn;
    };
    EXPECT_GT(drawn(), 0u);
    const uint32_t views = renderer->report().shadowViewsDrawn;
    EXPECT_TRUE(hasPass("shadow.glass.0"));
    EXPECT_EQ(drawn(), 0u);
    EXPECT_EQ(renderer->report().shadowViewsCached, views);
    EXPECT_FALSE(hasPass("shadow."));
    instances[pane].worldFromLocal[3].x += 0.2f;
    EXPECT_GT(drawn(), 0u);
    EXPECT_FALSE(hasPass("shadow.0")) << "opaque casters stand";
    expectColor(share(), kRed * kShare, "moved");
    render();
    instances[pane].material = glass(kGreen);
    EXPECT_GT(drawn(), 0u);
    expectColor(share(), kGreen * kShare, "another colour");
    // An opaque caster that moves changes what the panes' map may hold.
    instances[1].worldFromLocal[3] = {0.2f, 2, 0};
    expectColor(share(0.2f, 0), vec3(0), "hidden");
    instances.erase(instances.begin() + std::ptrdiff_t(pane));
    render();
    EXPECT_FALSE(hasPass("shadow.glass"));
    addPane(1, kRed, 0.3f);
    instances[1].worldFromLocal[3] = {-1.5f, 2, 0};
    expectColor(share(), kRed * kShare, "back again");
}

TEST_F(GlassGl, LampsKeepTheirMapsToo) {
    shine(PunctualLight{});
    addBox({-1, 1, 0}, {0.1f, 0.1f, 0.1f}, white);
    const size_t pane = addPane(1, kRed, 0.3f);
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 6u);
    EXPECT_TRUE(hasPass("shadow.atlas.glass"));
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 0u);
    EXPECT_EQ(renderer->report().shadowViewsCached, 6u);
    EXPECT_FALSE(hasPass("shadow."));
    instances[pane].worldFromLocal[3].x += 0.1f;
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 1u) << "the face below";
    EXPECT_EQ(renderer->report().shadowViewsCached, 5u);
    expectColor(share(), kRed * kShare, "moved");
    instances.erase(instances.begin() + std::ptrdiff_t(pane));
    render();
    EXPECT_FALSE(hasPass("shadow.atlas.glass"));
    EXPECT_FLOAT_EQ(share().x, 1);
    addPane(1, kGreen, 0.3f);
    expectColor(share(), kGreen * kShare, "another");
}

}  // namespace
}  // namespace rushlight
