// Everything at once, in every combination that shares a shader: it compiles, links, and draws
// finite light.

#include "renderer/lighting/irradiance_volume.h"
#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

namespace rushlight {
namespace {

class AllFeaturesGl : public LitFrame {
protected:
    AllFeaturesGl() : LitFrame(96, 64) {}

    void SetUp() override {
        LitFrame::SetUp();
        addBoxes();
        addLights();
        input.view.viewFromWorld = glm::lookAt(vec3(4, 3, 6), vec3(0), vec3(0, 1, 0));
        input.settings.lightShadows = true;
        input.settings.shadowResolution = 256;
        input.settings.shadowAtlasSize = 512;
        input.settings.shadowTileSize = 128;
    }

    void addBoxes() {
        MaterialDesc glass;
        glass.baseColor = {0.5f, 0.7f, 1, 0.4f};
        glass.alphaMode = AlphaMode::blend;
        const MaterialHandle blended = *renderer->createMaterial(glass);
        addBox({0, -2, 0}, {8, 1, 8});
        addBox({-1, 0, 0}, vec3(0.8f));
        addBox({1.5f, 0, 1}, vec3(0.5f), blended);
        decal.material = *renderer->createDecalMaterial({.label = "paint"});
        decal.worldFromDecal = mat4x3(vec3(2, 0, 0), vec3(0, 0, -2), vec3(0, 2, 0), vec3(0, -1, 0));
        decal.baseColor = {1, 0.2f, 0.1f, 0.8f};
    }
    void addLights() {
        sun.direction = glm::normalize(vec3(-1, -2, -0.5f));
        sun.angularRadius = 0.01f;
        lamp.position = {2, 2, 2};
        lamp.intensity = vec3(20);
        lamp.radius = 0.05f;
        lamp.castsShadow = true;
        torch = lamp;
        torch.position = {-3, 2, 3};
        torch.castsShadow = false;
        area.position = {0, 3, -2};
        area.luminance = vec3(4);
        area.halfX = {1, 0, 0};
        area.halfY = {0, 0, 1};
        area.castsShadow = true;
        std::vector<vec3> sky(8 * 4, vec3(0.4f, 0.5f, 0.7f));
        const float vertical[] = {0, 60, 120}, horizontal[] = {0}, candela[] = {3, 2, 1};
        lamp.profile = torch.profile = *renderer->createLightProfile(
            {"web", vertical, horizontal, candela});
        const std::vector<uint8_t> tint{255, 200, 100, 255};
        lamp.cookie = *renderer->createLightCookie({"tint", {"tint", 1, 1, true, tint}});
        environment = *renderer->createEnvironment({"sky", 8, 4, sky});
    }
    /// Without and with what colours light.
    void expectFinite(const char* what) {
        expectFiniteLight(what);
        MaterialDesc desc;
        desc.metallic = 0;
        desc.transmission = 0.8f;
        desc.baseColor = {1, 0.6f, 0.2f, 1};
        if (!pane) pane = *renderer->createMaterial(desc);
        addBox({1, 1.5f, 1}, {0.6f, 0.02f, 0.6f}, pane);
        expectFiniteLight(what);
        instances.pop_back();
    }
    void expectFiniteLight(const char* what) {
        const CapturedImage image = render();
        float sum = 0;
        for (const float value : image.rgba32f) {
            ASSERT_TRUE(std::isfinite(value)) << what;
            sum += value;
        }
        EXPECT_GT(sum, 100) << what;
    }

    MaterialHandle pane;
    Decal decal;
    DirectionalLight sun;
    PunctualLight lamp, torch;
    AreaLight area;
    EnvironmentHandle environment;
};

/// A filter of shadows, and whether there is a sky: apart, as each compiles for seconds.
class AllFeaturesTogetherGl : public AllFeaturesGl,
                              public testing::WithParamInterface<std::tuple<ShadowFilter, bool>> {};

TEST_P(AllFeaturesTogetherGl, DrawFiniteLight) {
    const auto [filter, sky] = GetParam();
    const PunctualLight lamps[] = {lamp, torch};
    std::vector<DirectionalLight> suns(kMaxDirectionalLights, sun);
    for (size_t i = 0; i < suns.size(); ++i) suns[i].direction.x += float(i);
    input.settings.shadowFilter = filter;
    input.lighting.directional = suns;
    input.lighting.punctual = lamps;
    input.lighting.area = {&area, 1};
    input.lighting.environment = sky ? environment : EnvironmentHandle{};
    input.lighting.background = sky ? Background::environment : Background::color;
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(sky ? 0 : 0.3f);
    expectFinite("lights and shadows");
    input.settings.contactShadows = ContactShadows::lights;
    expectFinite("contact shadows");
    input.settings.contactShadows = ContactShadows::sun;  // half as long to compile
    input.settings.ambientOcclusion = AmbientOcclusion::high;
    expectFinite("ambient occlusion");
    input.settings.reflections = true;
    expectFinite("reflections");
    input.lighting.fog.density = 0.05f;
    expectFinite("fog");
    input.decals = {&decal, 1};
    expectFinite("decals");
}

std::string nameOf(const testing::TestParamInfo<std::tuple<ShadowFilter, bool>>& which) {
    constexpr const char* kFilters[] = {"Hard", "Pcf", "Soft"};
    return kFilters[size_t(std::get<0>(which.param))] +
           std::string(std::get<1>(which.param) ? "Sky" : "");
}

INSTANTIATE_TEST_SUITE_P(FiltersAndSkies, AllFeaturesTogetherGl,
                         testing::Combine(testing::Values(ShadowFilter::hard, ShadowFilter::pcf,
                                                          ShadowFilter::soft),
                                          testing::Bool()),
                         nameOf);

TEST_F(AllFeaturesGl, GoTogetherInTheLightOfProbes) {
    IrradianceVolume volume = makeIrradianceVolume({vec3(-4, -2, -4), vec3(4), glm::uvec3(3)});
    for (uint32_t i = 0; i < volume.grid.count(); ++i) {
        IrradianceProbe probe;
        probe.mean = {0.4f, 0.5f, 0.6f};
        volume.setProbe(i, probe);
        for (uint32_t k = 0; k < kProbeDistances; ++k) volume.setDistance(i, k, {10, 1});
    }
    const auto handle = renderer->createIrradianceVolume(volume);
    ASSERT_TRUE(handle) << handle.error().text();
    const PunctualLight lamps[] = {lamp, torch};
    for (const bool sky : {false, true}) {
        SCOPED_TRACE(testing::Message() << "sky " << sky);
        input.lighting.irradianceVolume = *handle;
        input.lighting.environment = sky ? environment : EnvironmentHandle{};
        input.settings.shadowFilter = ShadowFilter::soft;
        input.settings.ambientOcclusion = AmbientOcclusion::medium;
        input.lighting.directional = {&sun, 1};
        input.lighting.punctual = lamps;
        input.lighting.area = {&area, 1};
        input.settings.reflections = false;
        input.lighting.fog = {};
        expectFinite("lights and shadows");
        input.settings.reflections = true;
        expectFinite("reflections");
        input.lighting.fog.density = 0.05f;
        expectFinite("fog");
    }
}

}  // namespace
}  // namespace rushlight
