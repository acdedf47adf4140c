#include "engine/scene/deform.h"
#include "engine/scene/pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight::scene {
namespace {

using assets::AnimationChannel;
using assets::AnimationPath;
using assets::Interpolation;

assets::Model chain() {
    assets::Model model;
    model.nodes.resize(2);
    model.nodes[0].children = {1};
    model.nodes[0].translation = {1, 0, 0};
    model.nodes[1].parent = 0;
    model.nodes[1].translation = {0, 2, 0};
    model.roots = {0};
    return model;
}

void animate(assets::Model& model, AnimationChannel channel) {
    assets::Animation animation;
    animation.channels.push_back(std::move(channel));
    model.animations = {animation};
}

vec3 translationAt(const assets::Model& model, float seconds) {
    return poseAt(model, 0, seconds).nodes[1].translation;
}

TEST(AssetsPose, WorldTransformsFollowParents) {
    assets::Model model = chain();
    model.nodes[0].rotation = glm::angleAxis(kPi / 2, vec3(0, 0, 1));
    model.nodes[0].scale = vec3(2);
    const Pose pose = restPose(model);
    const vec3 at = pose.worldFromNode[1][3];
    EXPECT_NEAR(at.x, 1 - 4, 1e-6f);
    EXPECT_NEAR(at.y, 0, 1e-6f);
}

TEST(AssetsPose, LinearAndStep) {
    assets::Model model = chain();
    AnimationChannel channel{
        1, AnimationPath::translation, Interpolation::linear, {1, 3}, {0, 0, 0, 4, 0, 2}};
    animate(model, channel);
    EXPECT_EQ(translationAt(model, 0), vec3(0));
    EXPECT_EQ(translationAt(model, 1.5f), vec3(1, 0, 0.5f));
    EXPECT_EQ(translationAt(model, 9), vec3(4, 0, 2));
    channel.interpolation = Interpolation::step;
    animate(model, channel);
    EXPECT_EQ(translationAt(model, 2.9f), vec3(0));
    EXPECT_EQ(translationAt(model, 3), vec3(4, 0, 2));
}

TEST(AssetsPose, CubicSplineScalesItsTangentsByTheInterval) {
    // p(t) of glTF appendix C.5 with v0 = 0, b0 = 1, v1 = 8, a1 = 3 over 2 seconds, at the middle:
    // 0.125 * 2 * 1 + 0.5 * 8 - 0.125 * 2 * 3 = 3.5
    assets::Model model = chain();
    animate(model, {1,
                    AnimationPath::translation,
                    Interpolation::cubicSpline,
                    {0, 2},
                    {0, 0, 0, 0, 4, 0, 1, 0, 0, 3, 0, 0, 8, 4, 0, 0, 0, 0}});
    EXPECT_NEAR(translationAt(model, 1).x, 3.5f, 1e-6f);
    EXPECT_NEAR(translationAt(model, 1).y, 4, 1e-6f) << "between equal values without tangents";
    EXPECT_EQ(translationAt(model, 0).x, 0);
    EXPECT_EQ(translationAt(model, 2).x, 8);
}

TEST(AssetsPose, RotationsTakeTheShortWay) {
    assets::Model model = chain();
    const float h = std::sqrt(0.5f);
    animate(
        model,
        {1, AnimationPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -h, -h}});
    const quat middle = poseAt(model, 0, 0.5f).nodes[1].rotation;
    const vec3 turned = middle * vec3(1, 0, 0);
    EXPECT_NEAR(turned.x, h, 1e-6f);
    EXPECT_NEAR(turned.y, h, 1e-6f);
}

assets::Geometry point(const vec3& position) {
    assets::Geometry geometry;
    geometry.positions = {position};
    geometry.normals = {{0, 1, 0}};
    geometry.tangents = {{1, 0, 0, 1}};
    return geometry;
}

TEST(AssetsPose, SkinIgnoresTheNodesOwnTransform) {
    assets::Model model = chain();
    model.skins.resize(1);
    model.skins[0].joints = {0, 1};
    model.skins[0].inverseBindMatrices = {mat4(1), glm::translate(mat4(1), vec3(0, -2, 0))};
    model.nodes.emplace_back().translation = {50, 0, 0};
    model.nodes[2].skin = 0;
    model.roots = {0, 2};
    assets::Geometry geometry = point({0, 1, 0});
    geometry.skin = {{{0, 1, 0, 0}, vec4(0.25f, 0.75f, 0, 0)}};
    Pose pose = restPose(model);
    pose.nodes[1].rotation = glm::angleAxis(kPi / 2, vec3(0, 0, 1));
    updateWorld(model, pose);
    DeformedVertices out;
    applySkinAndMorph(model, pose, 2, geometry, out);
    // joint 0 moves the point to (1, 1, 0); joint 1 turns its offset (0, -1, 0) to (1, 0, 0) about
    // (1, 2, 0)
    EXPECT_NEAR(out.positions[0].x, 0.25f * 1 + 0.75f * 2, 1e-6f);
    EXPECT_NEAR(out.positions[0].y, 0.25f * 1 + 0.75f * 2, 1e-6f);
    EXPECT_NEAR(glm::length(out.normals[0]), 1, 1e-6f);
    EXPECT_LT(out.normals[0].x, 0);
}

TEST(AssetsPose, AJointThatMirrorsKeepsNormalsOutside) {
    assets::Model model = chain();
    model.skins.resize(1);
    model.skins[0].joints = {0};
    model.skins[0].inverseBindMatrices = {mat4(1)};
    model.nodes.emplace_back().skin = 0;
    model.roots = {0, 2};
    assets::Geometry geometry = point({0, 1, 0});
    geometry.normals = {glm::normalize(vec3(1, 2, 0))};
    geometry.skin = {{{0, 0, 0, 0}, vec4(1, 0, 0, 0)}};
    Pose pose = restPose(model);
    pose.nodes[0].scale = {-1, 1, 1};
    updateWorld(model, pose);
    DeformedVertices out;
    applySkinAndMorph(model, pose, 2, geometry, out);
    EXPECT_LT(glm::length(out.normals[0] - glm::normalize(vec3(-1, 2, 0))), 1e-6f);
}

TEST(AssetsPose, MorphTargetsAddUp) {
    assets::Model model = chain();
    assets::Geometry geometry = point({0, 0, 0});
    geometry.morphTargets.resize(2);
    geometry.morphTargets[0].positions = {{1, 0, 0}};
    geometry.morphTargets[1].positions = {{0, 0, 4}};
    geometry.morphTargets[1].normals = {{0, -1, 1}};
    model.geometries = {geometry};
    model.meshes.resize(1);
    model.meshes[0].primitives = {{0, -1}};
    model.meshes[0].weights = {0.5f, 0};
    model.nodes[1].mesh = 0;
    animate(model, {1, AnimationPath::weights, Interpolation::linear, {0, 2}, {0.5f, 0, 0.5f, 2}});
    DeformedVertices out;
    applySkinAndMorph(model, restPose(model), 1, geometry, out);
    EXPECT_EQ(out.positions[0], vec3(0.5f, 0, 0));
    EXPECT_EQ(out.normals[0], vec3(0, 1, 0));
    applySkinAndMorph(model, poseAt(model, 0, 1), 1, geometry, out);
    EXPECT_EQ(out.positions[0], vec3(0.5f, 0, 4));
    EXPECT_EQ(out.normals[0], vec3(0, 0, 1));
}

TEST(AssetsPose, DrawablesOfReachableNodes) {
    assets::Model model = chain();
    model.geometries = {point({0, 0, 0})};
    model.meshes.resize(1);
    model.meshes[0].primitives = {{0, 3}, {0, 4}};
    model.nodes[1].mesh = 0;
    model.nodes.emplace_back().mesh = 0;  // in no scene
    const std::vector<Drawable> drawables = listDrawables(model, restPose(model));
    ASSERT_EQ(drawables.size(), 2u);
    EXPECT_EQ(drawables[1].node, 1);
    EXPECT_EQ(drawables[1].material, 4);
    EXPECT_FALSE(drawables[1].deforms);
    EXPECT_EQ(drawables[1].worldFromLocal[3], vec3(1, 2, 0));
}

}  // namespace
}  // namespace rushlight::scene
