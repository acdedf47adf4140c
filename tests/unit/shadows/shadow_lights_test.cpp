#include "renderer/shadows/shadow_lights.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <set>

namespace rushlight {
namespace {

class ShadowLightsTest : public testing::Test {
protected:
    ShadowLights shadows;
    FrameSettings settings;
    std::vector<PunctualLight> lights;
    ShadowAtlasHistory history;

    PunctualLight& add(const vec3& at, float range = 8, float outerCone = -1) {
        PunctualLight light;
        light.position = at;
        light.range = range;
        light.outerConeAngle = outerCone;
        light.castsShadow = true;
        lights.push_back(light);
        return lights.back();
    }
    ShadowLights::Counts select(const vec3& eye, const vec3& target) {
        View view;
        view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
        const CameraMatrices camera = makeCamera(view, 16.0f / 9).value();
        return shadows.select({&camera, 720, lights, &settings}, history);
    }
    /// What has to be drawn now, as if it was drawn.
    uint32_t drawnFaces() {
        uint32_t drawn = 0;
        for (ShadowFace* face : shadows.faces()) {
            drawn += face->drawn != face->viewKey;
            face->drawn = face->viewKey;
        }
        return drawn;
    }
};

TEST_F(ShadowLightsTest, APointIsSixFacesAndASpotOne) {
    add({0, 0, -10});
    add({3, 0, -10}, 8, 0.5f);
    add({-3, 0, -10}, 8, 1.5f);
    const auto counts = select({0, 0, 0}, {0, 0, -1});
    EXPECT_EQ(counts.lights, 3u);
    EXPECT_EQ(shadows.faces().size(), 13u) << "a cone of nearly half of space is a cube's too";
    ASSERT_EQ(shadows.records().size(), 3u);
    EXPECT_EQ(shadows.records()[0], 1);
    EXPECT_EQ(shadows.records()[1], 12);
    EXPECT_EQ(shadows.records()[2], 15);
}

TEST_F(ShadowLightsTest, OnlyThoseThatCastAndReachIntoViewHaveSquares) {
    add({0, 0, 100});
    add({0, 0, -10}).castsShadow = false;
    EXPECT_EQ(select({0, 0, 0}, {0, 0, -1}).lights, 0u);
    EXPECT_TRUE(shadows.records().empty());
}

TEST_F(ShadowLightsTest, ALightReachesAsFarAsABallNotAsABox) {
    View view;
    view.viewFromWorld = mat4(1);
    const Plane side = makeCamera(view, 16.0f / 9).value().frustum.planes[0];
    const vec3 ahead(0, 0, -20),
        beside = ahead - side.normal * (glm::dot(side.normal, ahead) + side.offset);
    ASSERT_GT(glm::dot(glm::abs(side.normal), vec3(8)), 9.5f) << "its box would reach into view";
    add(beside - side.normal * 9.0f);
    EXPECT_EQ(select({0, 0, 0}, {0, 0, -1}).lights, 0u);
    lights.clear();
    add(beside - side.normal * 7.5f);
    EXPECT_EQ(select({0, 0, 0}, {0, 0, -1}).lights, 1u);
}

TEST_F(ShadowLightsTest, AreaLightsHaveACubeOrTheHalfThatTheyShineTo) {
    add({0, 0, -10});
    AreaLight area[4];
    for (AreaLight& light : area)
        light.position = {1, 0, -8}, light.range = 6, light.castsShadow = true;
    area[1].castsShadow = false;
    area[2].shape = AreaShape::sphere;
    area[3].twoSided = true;
    View view;
    view.viewFromWorld = mat4(1);
    const CameraMatrices camera = makeCamera(view, 16.0f / 9).value();
    const auto counts = shadows.select({&camera, 720, lights, &settings, area}, history);
    EXPECT_EQ(counts.lights, 4u);
    ASSERT_EQ(shadows.areaRecords().size(), 4u);
    EXPECT_EQ(shadows.areaRecords()[0], 6);
    EXPECT_EQ(shadows.areaRecords()[1], -1);
    EXPECT_EQ(shadows.areaRecords()[2], 11);
    EXPECT_EQ(shadows.areaRecords()[3], 17);
    EXPECT_EQ(shadows.faces().size(), 23u);
    // A rectangle's cube is turned: its fifth face looks the way that it shines, and the sphere
    // begins at its surface.
    EXPECT_NEAR(glm::dot(shadows.gpuFaces()[10].forward, vec3(0, 0, 1)), 1, 1e-6f);
    EXPECT_NEAR(shadows.gpuFaces()[11].nearPlane, area[2].radius + area[2].shadowNear, 1e-6f);
    drawnFaces();
    area[0].luminance *= 2.0f;
    shadows.select({&camera, 720, lights, &settings, area}, history);
    EXPECT_EQ(drawnFaces(), 0u);
    area[0].halfX = {0, 0, 0.5f};  // shines along -x
    shadows.select({&camera, 720, lights, &settings, area}, history);
    EXPECT_EQ(drawnFaces(), 5u);
}

// Every direction is in exactly the face that the shader picks, within its square and off the
// border.
TEST_F(ShadowLightsTest, TheFacesOfACubeSeeEverything) {
    add({1, 2, -10});
    select({0, 0, 0}, {0, 0, -1});
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = random.direction() * random.uniform(0.3f, 8);
        const vec3 a = glm::abs(p);
        const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
        const size_t f = size_t(2 * axis + (p[axis] < 0));
        const GpuShadowFace& face = shadows.gpuFaces()[f];
        const ShadowTile& tile = shadows.faces()[f]->tile;
        const float w = glm::dot(face.forward, p);
        ASSERT_GT(w, 0);
        const vec2 uv = vec2(glm::dot(face.right, p), glm::dot(face.up, p)) / w +
                        vec2(face.centerU, face.centerV);
        const vec2 texel = uv * float(shadows.atlasSize()) - vec2(tile.x, tile.y);
        const float border = float(shadowBorder(tile.size)) - 0.01f;
        EXPECT_GE(std::min(texel.x, texel.y), border);
        EXPECT_LE(std::max(texel.x, texel.y), float(tile.size) - border);
        // The look-up and the drawing agree.
        const vec4 clip = shadows.faces()[f]->view.clipFromWorld * vec4(lights[0].position + p, 1);
        const vec2 drawn = (vec2(clip) / clip.w * 0.5f + 0.5f) * float(tile.size);
        EXPECT_NEAR(drawn.x, texel.x, 0.01f);
        EXPECT_NEAR(drawn.y, texel.y, 0.01f);
        EXPECT_NEAR(clip.z / clip.w, face.nearPlane / w, 1e-6f);
    }
}

TEST_F(ShadowLightsTest, ViewsAreOfTheLightAlone) {
    Random random(3);
    for (int i = 0; i < 30; ++i) add(random.vector(-10, 10), 9, i % 3 ? -1 : 0.6f);
    const auto lap = [&](int frames) {
        uint32_t drawn = 0;
        for (int i = 0; i < frames; ++i) {
            const float a = 2 * kPi * float(i) / float(frames);
            const vec3 eye = 3.0f * vec3(std::cos(a), 0.2f, std::sin(a));
            const auto counts = select(eye, eye + vec3(std::cos(3 * a), 0, std::sin(3 * a)));
            EXPECT_EQ(counts.without, 0u);
            drawn += drawnFaces();
        }
        return drawn;
    };
    EXPECT_GT(lap(200), 100u) << "seen for the first time";
    EXPECT_EQ(lap(200), 0u);
}

TEST_F(ShadowLightsTest, OneThatMovesLeavesTheOthersAlone) {
    for (int i = 0; i < 10; ++i) add({float(i) - 5, 0, -10});
    select({0, 0, 0}, {0, 0, -1});
    drawnFaces();
    for (int i = 0; i < 20; ++i) {
        lights[4].position.y = std::sin(float(i + 1));
        select({0, 0, 0}, {0, 0, -1});
        EXPECT_EQ(drawnFaces(), 6u);
    }
    lights.erase(lights.begin());
    select({0, 0, 0}, {0, 0, -1});
    EXPECT_EQ(drawnFaces(), 0u) << "the others are known by where they are, not by their number";
}

TEST_F(ShadowLightsTest, NearLightsHaveMoreTexelsThanFarOnes) {
    add({0, 0, -4}, 3);
    add({0, 0, -60}, 3);
    select({0, 0, 0}, {0, 0, -1});
    EXPECT_GT(shadows.faces()[0]->tile.size, 2 * shadows.faces()[6]->tile.size);
}

TEST_F(ShadowLightsTest, AFullAtlasMakesAllCoarserThenLeavesOutTheLeast) {
    settings.shadowAtlasSize = 1024;
    for (int i = 0; i < 12; ++i) add({float(i % 4) - 1.5f, float(i / 4) - 1, -6});
    const auto some = select({0, 0, 0}, {0, 0, -1});
    EXPECT_EQ(some.lights, 12u);
    EXPECT_EQ(some.reduced, 12u);
    EXPECT_EQ(some.without, 0u);
    for (int i = 0; i < 60; ++i) add({float(i % 8) * 0.4f - 1.5f, float(i / 8) * 0.4f - 1, -7});
    for (int frame = 0; frame < 3; ++frame) {
        const auto many = select({0, 0, 0}, {0, 0, -1});
        EXPECT_EQ(many.lights, 1024u * 1024 / (6 * 64 * 64)) << "as many as fit";
        EXPECT_EQ(many.lights + many.without, 72u);
        std::set<std::pair<int, int>> places;
        for (const ShadowFace* face : shadows.faces()) places.insert({face->tile.x, face->tile.y});
        EXPECT_EQ(places.size(), shadows.faces().size());
        if (frame)
            EXPECT_EQ(drawnFaces(), 0u) << "the same lights as in the frame before";
        else
            drawnFaces();
    }
    lights.resize(1);
    select({0, 0, 0}, {0, 0, -1});
    EXPECT_GT(shadows.faces()[0]->tile.size, 0);
}

TEST_F(ShadowLightsTest, AfterACutItIsAsIfNothingHadBeen) {
    Random random(5);
    for (int i = 0; i < 24; ++i) add(random.vector(-12, 12), random.uniform(2, 9));
    settings.shadowAtlasSize = 2048;
    for (int i = 0; i < 40; ++i) {
        lights[size_t(i) % 24].position = random.vector(-12, 12);
        select(random.vector(-20, 20), random.vector(-3, 3));
    }
    settings.cut = true;
    const auto tilesFrom = [&](ShadowAtlasHistory& of) {
        std::swap(of, history);
        select({15, 4, 9}, {0, 0, 0});
        std::vector<ShadowTile> tiles;
        for (const ShadowFace* face : shadows.faces()) tiles.push_back(face->tile);
        std::swap(of, history);
        return tiles;
    };
    ShadowAtlasHistory fresh, used = std::exchange(history, {});
    const auto tiles = tilesFrom(used);
    EXPECT_GT(tiles.size(), 20u);
    EXPECT_EQ(tiles, tilesFrom(fresh));
    // What stands still stays as it was drawn, from cut to cut.
    history = std::move(used);
    select({15, 4, 9}, {0, 0, 0});
    EXPECT_GT(drawnFaces(), 0u);
    select({15, 4, 9}, {0, 0, 0});
    EXPECT_EQ(drawnFaces(), 0u);
    lights[3].position.y += 0.1f;
    const auto before = shadows.faces().size();
    select({15, 4, 9}, {0, 0, 0});
    EXPECT_EQ(shadows.faces().size(), before);
    EXPECT_EQ(drawnFaces(), 6u);
}

TEST_F(ShadowLightsTest, TheSizeFollowsTheCameraReluctantly) {
    add({0, 0, 0}, 2);
    uint32_t changes = 0, last = 0;
    for (int i = 0; i < 400; ++i) {
        const float distance = 12 * (1 + 0.25f * std::sin(float(i) * 0.7f));
        select({0, 0, distance}, {0, 0, 0});
        changes += shadows.faces()[0]->tile.size != last;
        last = shadows.faces()[0]->tile.size;
    }
    EXPECT_LE(changes, 2u);
}

// Right, up and the way a spot shines: at right angles, of length 1, and turned as the eye's are.
TEST(ShadowViews, ASpotsAxesAreAtRightAngles) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const vec3 n = i < 2 ? vec3(0, 0, i ? -1 : 1) : random.direction();
        vec3 right, up;
        spotBasis(n, right, up);
        EXPECT_NEAR(glm::dot(up, n), 0, 1e-5f);
        EXPECT_NEAR(glm::dot(right, n), 0, 1e-5f);
        EXPECT_NEAR(glm::length(up), 1, 1e-5f);
        EXPECT_LT(glm::length(glm::cross(n, up) - right), 1e-5f);
    }
}

}  // namespace
}  // namespace rushlight
