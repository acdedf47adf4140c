// A drunkard walks through the level that the game ships with.

#include "engine/assets/gltf.h"
#include "engine/scene/pose.h"
#include "sandbox/viewer/camera_rig.h"
#include "sandbox/viewer/level.h"

#include <gtest/gtest.h>

#include <random>

namespace rushlight {
namespace {

vec3 spawnOf(const assets::Model& model) {
    const scene::Pose pose = scene::restPose(model);
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (model.nodes[i].name == "spawn") return vec3(pose.worldFromNode[i][3]);
    ADD_FAILURE() << "the square has no node 'spawn'";
    return vec3(0);
}

TEST(SquareWalkTest, NobodyFallsThroughTheWorldAtAnyFrameRate) {
    const auto model = assets::loadModel(RUSHLIGHT_CONTENT "/square/square.gltf");
    ASSERT_TRUE(model) << model.error().text();
    const TriangleGrid level(collisionTriangles(*model));
    const vec3 spawn = spawnOf(*model);
    ASSERT_TRUE(level.castDown(spawn + vec3(0, 1, 0), 2)) << "there is ground at the spawn";
    for (const int rate : {5, 60}) {
        WalkCamera camera;
        camera.spawnAt(spawn, {});
        std::mt19937 random(4);
        float farthest = 0;
        CameraIntent intent;
        for (int frame = 0; frame < 120 * rate; ++frame) {
            if (frame % rate == 0) {
                intent.forward = random() % 5 ? 1.0f : -1.0f;
                intent.right = float(int(random() % 3) - 1);
                intent.fast = random() % 2;
            }
            intent.turnYaw = (frame % rate == 0) ? float(int(random() % 200) - 100) / 60 : 0.0f;
            camera.update(intent, level, 1.0f / float(rate));
            const vec3 feet = camera.body().feet();
            ASSERT_GT(feet.y, level.bounds().low.y - 0.1f)
                << "frame " << frame << " at " << feet.x << ", " << feet.z;
            farthest = std::max(farthest, glm::distance(feet, spawn));
        }
        EXPECT_GT(farthest, 5) << "the walk goes somewhere";
    }
}

}  // namespace
}  // namespace rushlight
