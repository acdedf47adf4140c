// Shadows against rays: how many pixels are falsely lit or falsely shadowed.

#include "tests/support/scenes/shadow_truth.h"

#include "engine/assets/gltf.h"
#include "renderer/scene_bridge/ray_bridge.h"
#include "renderer/visibility/shadow_cascades.h"
#include "shaders/interop/frame_uniforms.h"
#include "tests/support/gl/offscreen_renderer.h"
#include "tests/support/scenes/torture_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace rushlight {
namespace {

class ShadowTruthGl : public OffscreenRenderer {
protected:
    void load(const std::string& path) {
        model = assets::loadModel(path).value();
        bridge = SceneBridge::create(*renderer, model).value();
        rays = makeRayScene(*bridge, *jobs).value();
    }
    // Rays pass through blended surfaces: pictures are without them.
    FrameInput opaqueFrame() {
        struct Blended final : ResourceSink {
            std::vector<MaterialHandle> found;
            Result<void> image(ImageHandle, const ImageDesc&) override { return {}; }
            Result<void> mesh(MeshHandle, const MeshDesc&) override { return {}; }
            Result<void> material(MaterialHandle handle, const MaterialDesc& desc) override {
                if (desc.alphaMode == AlphaMode::blend) found.push_back(handle);
                return {};
            }
        } blended;
        EXPECT_TRUE(bridge->describe(blended));
        FrameInput input;
        bridge->fill(input);
        opaque.clear();
        for (const Instance& instance : input.instances)
            if (std::ranges::find(blended.found, instance.material) == blended.found.end())
                opaque.push_back(instance);
        input.instances = opaque;
        input.settings = settings();
        return input;
    }
    static FrameSettings settings() {
        FrameSettings s;
        s.lightShadows = true;
        return s;
    }
    // As the renderer makes them.
    static std::function<float(const vec3&)> sunTexels(const FrameInput& input, float aspect,
                                                       const Aabb& bounds) {
        ShadowCascadeDesc desc;
        desc.lightDirection = input.lighting.directional[0].direction;
        desc.sceneBounds = bounds;
        const ShadowCascades cascades = makeShadowCascades(makeCamera(input.view, aspect).value(),
                                                           desc);
        return [cascades](const vec3& p) {
            for (const ShadowCascade& c : cascades.cascades) {
                const vec2 at = vec2(glm::dot(cascades.rows[0], vec4(p, 1)),
                                     glm::dot(cascades.rows[1], vec4(p, 1))) *
                                    c.uvPerMetre +
                                c.uvOffset - 0.5f;
                if (std::max(std::abs(at.x), std::abs(at.y)) < 0.49f) return c.metresPerTexel;
            }
            return cascades.cascades[cascades.count - 1].metresPerTexel;
        };
    }
    // Of a cube's face of that many texels.
    static std::function<float(const vec3&)> lightTexels(const vec3& light, float texels) {
        return [=](const vec3& p) { return 2 * glm::length(p - light) / texels; };
    }
    /// The most that may be wrong, in percent. The aim is 0.5 each; what is farther from it says
    /// where.
    struct Limits {
        double shadowed = 0.5, lit = 0.5, clearShadowed = 0.4, clearLit = 0.4;
    };
    void expectFew(const char* scene, const ShadowFigures& figures, const Limits& limits) {
        std::cout << scene << ": " << figures << std::endl;
        EXPECT_GT(figures.pixels, 5000u) << scene << " shows too little";
        EXPECT_LT(figures.shadowedShare() * 100, limits.shadowed) << scene;
        EXPECT_LT(figures.litShare() * 100, limits.lit) << scene;
        EXPECT_LT(figures.clearShadowedShare() * 100, limits.clearShadowed) << scene;
        EXPECT_LT(figures.clearLitShare() * 100, limits.clearLit) << scene;
    }
    std::string pictureOf(const std::string& name) const {
        const char* folder = std::getenv("RUSHLIGHT_TEST_PICTURES");
        return folder ? std::string(folder) + "/" + name + ".png" : std::string();
    }
    ShadowFigures sun(const FrameInput& input, const std::string& name) {
        ShadowTruth truth(*renderer, *rays);
        truth.texelMetres = sunTexels(input, float(truth.width) / float(truth.height),
                                      rays->bounds());
        truth.picture = pictureOf(name);
        return truth.compare(input, {true, 0});
    }
    ShadowFigures lamp(const FrameInput& input, uint32_t light, float texels,
                       const std::string& name) {
        ShadowTruth truth(*renderer, *rays);
        truth.texelMetres = lightTexels(input.lighting.punctual[light].position, texels);
        truth.picture = pictureOf(name);
        return truth.compare(input, {false, light});
    }

    assets::Model model;
    std::unique_ptr<SceneBridge> bridge;
    std::unique_ptr<RayScene> rays;
    std::vector<Instance> opaque;
};

TEST_F(ShadowTruthGl, TheTortureScene) {
    rays = RayScene::create(*jobs).value();
    TortureScene scene(*renderer, *rays);
    ASSERT_TRUE(rays->build(scene.instances));
    ShadowFigures high, grazing, lamps;
    const vec3 eyes[] = {{-7, 3, 7}, {6, 2.5f, 6}, {1, 1.5f, 9}};
    for (int i = 0; i < 3; ++i) {
        FrameInput input = scene.frame(eyes[i], {0, 0.5f, 0});
        input.settings = settings();
        const std::string number = std::to_string(i);
        high.add(sun(input, "torture-sun-" + number));
        lamps.add(lamp(input, 0, 1024, "torture-point-" + number));
        lamps.add(lamp(input, 1, 1024, "torture-spot-" + number));
        scene.suns[0].direction = glm::normalize(vec3(-0.9f, -0.12f, -0.35f));
        grazing.add(sun(input, "torture-grazing-" + number));
        scene.suns[0].direction = glm::normalize(vec3(-0.6f, -1, -0.35f));
    }
    expectFew("torture, sun", high, {});
    expectFew("torture, grazing sun", grazing, {});
    expectFew("torture, lamps", lamps, {});
}

TEST_F(ShadowTruthGl, TheSquareAtNight) {
    load(RUSHLIGHT_CONTENT "/square/square.gltf");
    FrameInput input = opaqueFrame();
    input.settings.shadowAtlasSize = 8192;  // as --quality ultra
    std::vector<PunctualLight> lights(input.lighting.punctual.begin(),
                                      input.lighting.punctual.end());
    for (PunctualLight& light : lights) light.castsShadow = true;
    input.lighting.punctual = lights;
    input.lighting.directional = {};
    input.view.viewFromWorld = glm::lookAt(vec3(-3, 1.7f, 9), vec3(1, 2.2f, -4), vec3(0, 1, 0));
    ShadowFigures all;
    for (uint32_t i = 0; i < lights.size(); ++i)
        all.add(lamp(input, i, 512, "square-lamp-" + std::to_string(i)));
    // Half of what is falsely lit lies on bevels and leaves narrower than a pixel, whose triangles
    // face away from the lamp: the G-buffer holds their shading normals alone.
    expectFew("the square's lamps", all, {0.5, 0.78, 0.22, 0.5});
}

TEST_F(ShadowTruthGl, Sponza) {
    const char* assets = std::getenv("RUSHLIGHT_ASSETS");
    if (!assets) GTEST_SKIP() << "RUSHLIGHT_ASSETS is not set";
    load(std::string(assets) + "/scenes/Sponza/Sponza.gltf");
    FrameInput input = opaqueFrame();
    const DirectionalLight sunlight{glm::normalize(vec3(-0.35f, -1, -0.25f)), vec3(1)};
    input.lighting.directional = {&sunlight, 1};
    input.lighting.punctual = {};
    ShadowFigures all;
    const vec3 views[][2] = {
        {{-8, 2, -0.5f}, {5, 4, 0}}, {{5, 6, 2.5f}, {-6, 1, -2}}, {{-2, 1.5f, 2}, {8, 2, -1}}};
    int number = 0;
    for (const auto& view : views) {
        input.view.viewFromWorld = glm::lookAt(view[0], view[1], vec3(0, 1, 0));
        all.add(sun(input, "sponza-" + std::to_string(number++)));
    }
    expectFew("Sponza", all, {});
}

}  // namespace
}  // namespace rushlight
