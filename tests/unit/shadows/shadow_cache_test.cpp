// Shadow maps are drawn again when, and only when, what they show changed.

#include "engine/assets/gltf.h"
#include "renderer/scene_bridge/scene_bridge.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

constexpr FrameTarget kTarget{0, 1280, 720};

std::unique_ptr<Renderer> nullRenderer() {
    return std::move(Renderer::create({.validateCommands = true}).value());
}

class SmallShadows : public testing::Test {
protected:
    std::unique_ptr<Renderer> renderer = nullRenderer();
    WorldHandle world = renderer->createWorld();
    std::vector<InstanceHandle> handles;
    std::vector<Instance> instances;
    std::vector<PunctualLight> lights;
    FrameInput input;

    SmallShadows() {
        const MeshHandle cube = renderer->createMesh(makeCube().desc()).value();
        for (int i = 0; i < 40; ++i) {
            Instance instance;
            instance.mesh = cube;
            instance.worldFromLocal = mat4x3(0.3f);
            instance.worldFromLocal[3] = {float(i % 8) * 3 - 10, 0, float(i / 8) * -3 - 4};
            instances.push_back(instance);
        }
        handles.resize(instances.size());
        EXPECT_TRUE(renderer->addInstances(world, instances, handles));
        for (int i = 0; i < 4; ++i) {
            PunctualLight light;
            light.castsShadow = true;
            light.position = {float(i) * 6 - 9, 2, -9};
            light.range = 3;
            light.outerConeAngle = 0.9f;
            lights.push_back(light);
        }
        input.world = world;
        input.lighting.punctual = lights;
        input.settings.lightShadows = true;
    }
    void render() {
        const auto rendered = renderer->render(input, kTarget);
        EXPECT_TRUE(rendered) << rendered.error().text();
    }
    uint32_t drawn() {
        render();
        return renderer->report().shadowViewsDrawn;
    }
    /// Shadow draws of the last frame.
    std::pair<uint32_t, uint32_t> atlasAndLayer() const {
        std::pair<uint32_t, uint32_t> draws;
        for (const PassReport& pass : renderer->report().passes) {
            if (std::string_view(pass.name) == "shadow.atlas") draws.first = pass.draws;
            if (std::string_view(pass.name) == "shadow.still") draws.second = pass.draws;
        }
        return draws;
    }
    void move(size_t i, const vec3& by) {
        instances[i].worldFromLocal[3] += by;
        EXPECT_TRUE(renderer->updateInstances(world, std::span(&handles[i], 1),
                                              std::span(&instances[i], 1)));
    }
};

TEST_F(SmallShadows, AreKeptUntilSomethingInTheirReachChanges) {
    EXPECT_EQ(drawn(), 4u);
    EXPECT_EQ(renderer->report().shadowLights, 4u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(drawn(), 0u);
    EXPECT_EQ(renderer->report().shadowViewsCached, 4u);

    size_t under = 0;  // what the first light sees
    for (size_t i = 0; i < instances.size(); ++i)
        if (glm::length(instances[i].worldFromLocal[3] - vec3(lights[0].position.x, 0, -9)) <
            glm::length(instances[under].worldFromLocal[3] - vec3(lights[0].position.x, 0, -9)))
            under = i;
    move(under, {0, 0.1f, 0});
    EXPECT_EQ(drawn(), 1u);
    move(39, {5, 0, -40});  // out of every light's reach
    EXPECT_EQ(drawn(), 0u) << "what moved before has come to rest where it was drawn";
    move(39, {1, 0, 0});
    EXPECT_EQ(drawn(), 0u);

    lights[2].intensity *= 0.5f;
    EXPECT_EQ(drawn(), 0u) << "how bright a light is changes no shadow";
    lights[2].position.y += 0.1f;
    EXPECT_EQ(drawn(), 1u);
    input.settings.shadowCaching = false;
    EXPECT_EQ(drawn(), 4u);
}

// A figure whose vertices change at each step, as a skinned one: only views that see it are drawn.
TEST_F(SmallShadows, OfViewsThatDoNotSeeAChangedMeshAreKept) {
    const Shape figure = makeCube();
    const MeshHandle mesh = renderer->createMesh(figure.desc()).value();
    const MeshHandle unseen = renderer->createMesh(figure.desc()).value();
    Instance instance = instances[0];
    instance.mesh = mesh;
    instance.worldFromLocal[3] = vec3(lights[1].position.x, 0, -9);
    InstanceHandle handle;
    ASSERT_TRUE(renderer->addInstances(world, {&instance, 1}, {&handle, 1}));
    const DirectionalLight sun{glm::normalize(vec3(-1, -2, -1))};
    input.lighting.directional = {&sun, 1};
    input.settings.shadowCascades = 1;
    for (int i = 0; i < 3; ++i) render();
    EXPECT_EQ(drawn(), 0u);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(renderer->updateMesh(mesh, figure.desc()));
        EXPECT_EQ(drawn(), 2u) << "of the lamp over it and the sun";
        EXPECT_EQ(drawn(), 0u);
        ASSERT_TRUE(renderer->updateMesh(unseen, figure.desc()));
        EXPECT_EQ(drawn(), 0u);
    }
    renderer->destroy(unseen);
    EXPECT_EQ(drawn(), 0u);
    renderer->destroy(mesh);
    EXPECT_EQ(drawn(), 2u) << "it is gone from both";
}

TEST_F(SmallShadows, WhatStandsStillIsKeptInALayerWhereSomethingMoves) {
    render();
    const uint32_t everything = atlasAndLayer().first;
    EXPECT_EQ(atlasAndLayer().second, 0u);
    size_t under = 0;
    for (size_t i = 0; i < instances.size(); ++i)
        if (glm::length(instances[i].worldFromLocal[3] - vec3(lights[0].position.x, 0, -9)) < 2.5f)
            under = i;
    for (int i = 0; i < 5; ++i) {
        move(under, {0, 0.01f, 0});
        EXPECT_EQ(drawn(), 1u);
        const auto [atlas, layer] = atlasAndLayer();
        EXPECT_EQ(atlas, 2u) << "a copy of the layer and what moves, of " << everything;
        EXPECT_EQ(layer > 0, i == 0) << "the layer is drawn once";
    }
}

TEST_F(SmallShadows, WrongSettingsAreErrors) {
    input.settings.shadowAtlasSize = 100;
    EXPECT_FALSE(renderer->render(input, kTarget));
    input.settings.shadowAtlasSize = 1024;
    input.settings.shadowTileSize = 2048;
    EXPECT_FALSE(renderer->render(input, kTarget));
    input.settings.shadowTileSize = 512;
    lights[0].radius = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(renderer->render(input, kTarget));
}

// The level that the game ships with, at night, with all its lamps lit.
class SquareAtNight : public testing::Test {
protected:
    std::unique_ptr<Renderer> renderer = nullRenderer();
    assets::Model model = assets::loadModel(RUSHLIGHT_CONTENT "/square/square.gltf").value();
    std::unique_ptr<SceneBridge> bridge = SceneBridge::create(*renderer, model).value();
    FrameInput input;
    std::vector<PunctualLight> lights;

    SquareAtNight() {
        bridge->fill(input);
        lights.assign(input.lighting.punctual.begin(), input.lighting.punctual.end());
        for (PunctualLight& light : lights) light.castsShadow = true;
        lights.resize(30);
        input.lighting.punctual = lights;
        input.lighting.directional = {};
        input.settings.lightShadows = true;
    }
    uint32_t drawnFrom(const vec3& eye, const vec3& direction) {
        input.view.viewFromWorld = glm::lookAt(eye, eye + direction, vec3(0, 1, 0));
        const auto rendered = renderer->render(input, kTarget);
        EXPECT_TRUE(rendered) << rendered.error().text();
        EXPECT_EQ(renderer->report().shadowLightsWithout, 0u);
        return renderer->report().shadowViewsDrawn;
    }
    /// Around the square, looking about: by frame, what was drawn.
    std::vector<uint32_t> lap(int frames) {
        std::vector<uint32_t> drawn;
        for (int i = 0; i < frames; ++i) {
            const float a = 2 * kPi * float(i) / float(frames);
            drawn.push_back(drawnFrom({7 * std::cos(a), 1.7f, 6 * std::sin(a)},
                                      {std::cos(4 * a), 0.2f * std::sin(3 * a), std::sin(4 * a)}));
        }
        return drawn;
    }
};

TEST_F(SquareAtNight, ACameraThatMovesDrawsNoShadowAgain) {
    ASSERT_EQ(lights.size(), 30u);
    const auto first = lap(150);
    uint32_t sum = 0;
    for (uint32_t drawn : first) sum += drawn;
    EXPECT_GE(sum, 30u * 5) << "each light is drawn when it is first seen";
    for (uint32_t drawn : lap(150)) EXPECT_EQ(drawn, 0u);
    EXPECT_GT(renderer->report().shadowViewsCached, 50u);
}

TEST_F(SquareAtNight, ALampThatSwingsDrawsItsOwnFacesAlone) {
    lap(150);
    size_t swinging = 0;
    const vec3 eye(0, 1.7f, 6), forward(0, 0, -1);
    for (size_t i = 0; i < lights.size(); ++i)  // one before the camera
        if (lights[i].outerConeAngle < 0 && lights[i].position.z < lights[swinging].position.z &&
            std::abs(lights[i].position.x) < 6)
            swinging = i;
    drawnFrom(eye, forward);
    const vec3 rest = lights[swinging].position;
    for (int i = 1; i < 20; ++i) {
        lights[swinging].position = rest + vec3(0.2f * std::sin(float(i)), 0, 0);
        EXPECT_EQ(drawnFrom(eye, forward), 6u);
    }
}

}  // namespace
}  // namespace rushlight
