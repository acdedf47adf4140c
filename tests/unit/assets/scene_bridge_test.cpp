// What becomes of a file's nodes in a frame; on the null backend.

#include "renderer/scene_bridge/scene_bridge.h"
#include "renderer/scene_bridge/scene_lights.h"
#include "tests/unit/assets/small_gltf.h"

namespace rushlight::test {
namespace {

struct Bridged {
    assets::Model model;
    std::unique_ptr<Renderer> renderer = std::move(Renderer::create({}).value());
    std::unique_ptr<SceneBridge> bridge;

    explicit Bridged(SmallGltf& gltf) {
        const TempFolder folder;
        model = assets::loadModel(gltf.save(folder)).value();
        bridge = std::move(SceneBridge::create(*renderer, model).value());
    }
    FrameInput frame() const {
        FrameInput input;
        bridge->fill(input);
        return input;
    }
};

/// Two nodes with the same mesh, which a morph target moves along z by each node's own weight.
SmallGltf twins() {
    SmallGltf gltf;
    gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    gltf.add<float>({0, 1}, 5126, "SCALAR", 1);
    gltf.add<float>({0, 0, 0, 4, 0, 0}, 5126, "VEC3", 3);
    gltf.json.update(Json::parse(R"({
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]}],
        "nodes":[{"mesh":0,"weights":[0]},{"mesh":0,"weights":[3]}],
        "animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
                       "samplers":[{"input":2,"output":3}]}],
        "scenes":[{"nodes":[0,1]}],"scene":0})"));
    return gltf;
}

TEST(SceneBridge, NodesThatDeformOneMeshEachHaveTheirOwn) {
    SmallGltf gltf = twins();
    const Bridged scene(gltf);
    const FrameInput input = scene.frame();
    ASSERT_EQ(input.instances.size(), 2u);
    EXPECT_NE(input.instances[0].mesh, input.instances[1].mesh);
    ASSERT_TRUE(scene.renderer->render(input, {0, 16, 16}));
    const auto facts = scene.renderer->describeInstances();
    ASSERT_EQ(facts.size(), 2u);
    EXPECT_EQ(facts[0].bounds.high.z, 0);
    EXPECT_EQ(facts[1].bounds.high.z, 3);
}

TEST(SceneBridge, MorphWeightsMayBeNegative) {
    SmallGltf gltf = twins();
    gltf.json["nodes"][1]["weights"] = {-2};
    const Bridged scene(gltf);
    ASSERT_TRUE(scene.renderer->render(scene.frame(), {0, 16, 16}));
    EXPECT_EQ(scene.renderer->describeInstances().at(1).bounds.low.z, -2);
}

TEST(SceneBridge, WhatMovesIsToldFromWhatStands) {
    SmallGltf gltf = twins();
    const Bridged scene(gltf);
    const auto moving = [&](size_t i) {
        return bool(scene.frame().instances[i].flags & kInstanceMoving);
    };
    EXPECT_FALSE(moving(0));
    EXPECT_FALSE(moving(1));
    ASSERT_TRUE(scene.bridge->pose(0, 0.5f));
    EXPECT_TRUE(moving(0));
    EXPECT_FALSE(moving(1));
    EXPECT_EQ(scene.frame().instances[0].worldFromLocal[3], vec3(2, 0, 0));
    EXPECT_EQ(scene.frame().previousTransforms[scene.frame().instances[0].previousTransform][3],
              vec3(0));
    ASSERT_TRUE(scene.bridge->pose(0, 0.5f));
    EXPECT_FALSE(moving(0)) << "it has come to rest";
}

// A file says how wide its camera sees; the picture decides, and the vertical field is kept.
TEST(SceneBridge, NoPictureIsStretchedToACamerasAspectRatio) {
    assets::Camera camera;
    camera.verticalFov = 0.6f;
    camera.aspect = 2;
    const View view = viewOf(camera, mat4(1));
    EXPECT_EQ(view.verticalFov, 0.6f);
    EXPECT_EQ(view.aspect, 0);
    camera.perspective = false;
    camera.orthoHalfWidth = 8;
    camera.orthoHalfHeight = 2;
    EXPECT_EQ(viewOf(camera, mat4(1)).orthoHalfHeight, 2);
    EXPECT_EQ(viewOf(camera, mat4(1)).aspect, 0);
}

}  // namespace
}  // namespace rushlight::test
