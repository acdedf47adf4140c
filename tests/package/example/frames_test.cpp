#include "renderer/testing/matchers.h"

#include <gtest/gtest.h>

namespace {

using namespace rushlight::golden;

class Frames : public testing::Test {
protected:
    void SetUp() override {
        auto made = Offscreen::create();
        if (!made) GTEST_SKIP() << made.error().text();
        offscreen = std::move(*made);
    }
    std::unique_ptr<Offscreen> offscreen;
};

TEST_F(Frames, OfAFile) {
    rushlight::SceneView view;
    view.camera = "front";
    view.width = 160;
    view.height = 90;
    EXPECT_FRAME(offscreen->renderScene(EXAMPLE_SCENES "/wall.gltf", view),
                 near("goldens/wide.png", flip(0.02), psnr(35)));
}

TEST_F(Frames, OfAnInputOfOnesOwn) {
    const rushlight::vec3 corners[] = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    const rushlight::vec3 normals[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    const uint32_t indices[] = {0, 1, 2};
    rushlight::MeshDesc triangle;
    triangle.label = "triangle";
    triangle.positions = corners, triangle.normals = normals, triangle.indices = indices;
    const auto mesh = offscreen->renderer().createMesh(triangle);
    ASSERT_TRUE(mesh) << mesh.error().text();
    rushlight::MaterialDesc paint;
    paint.baseColor = {0.1f, 0.6f, 0.2f, 1};
    paint.metallic = 0;
    const auto material = offscreen->renderer().createMaterial(paint);
    ASSERT_TRUE(material) << material.error().text();
    rushlight::Instance instance;
    instance.mesh = *mesh;
    instance.material = *material;
    rushlight::FrameInput input;
    input.view.viewFromWorld[3] = {0, 0, -4, 1};
    input.instances = {&instance, 1};
    input.lighting.ambientSky = input.lighting.ambientGround = rushlight::vec3(0.7f);
    input.settings.dither = false;
    EXPECT_FRAME(offscreen->render(input, 64, 64),
                 near("goldens/triangle.png", ssim(0.99), maxError(0.02)));
}

}  // namespace
