#include "renderer/visibility/occlusion/occlusion_buffer.h"

#include "renderer/visibility/occlusion/occlusion_pick.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <limits>

namespace rushlight {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A view in which x and y are pixels, y up, and z is the depth itself: 1 nearest, 0 farthest.
mat4 pixelView(uint32_t width, uint32_t height) {
    mat4 m(1.0f);
    m[0][0] = 2 / float(width);
    m[1][1] = 2 / float(height);
    m[3] = {-1, -1, 0, 1};
    return m;
}

/// Counter-clockwise rectangles, each two triangles.
struct Quads {
    std::vector<vec3> positions;
    std::vector<uint32_t> indices;

    Quads& add(float left, float bottom, float right, float top, float depth) {
        const uint32_t first = uint32_t(positions.size());
        for (vec2 p : {vec2(left, bottom), vec2(right, bottom), vec2(right, top), vec2(left, top)})
            positions.push_back({p, depth});
        for (uint32_t i : {0, 1, 2, 0, 2, 3}) indices.push_back(first + i);
        return *this;
    }
    OccluderMesh mesh() const { return makeOccluderMesh(positions, indices); }
};

class Occlusion : public testing::Test {
protected:
    void fill(uint32_t width, uint32_t height, const OccluderMesh& mesh) {
        fill(width, height, pixelView(width, height), {&mesh, mat4x3(1), false});
    }
    void fill(uint32_t width, uint32_t height, const mat4& clip, const Occluder& occluder) {
        buffer.begin(width, height, clip);
        buffer.addOccluder(occluder);
        buffer.rasterize(jobs);
    }
    /// A flat box over pixels of pixelView, from the middle of the first to the middle of the last.
    bool sees(float left, float bottom, float right, float top, float depth) const {
        return buffer.isVisible({(left + right) / 2, (bottom + top) / 2, depth},
                                {(right - left) / 2, (top - bottom) / 2, 0});
    }
    uint32_t filledPixels(uint32_t width, uint32_t height) const {
        uint32_t count = 0;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) count += buffer.depthAt(x, y) > 0;
        return count;
    }
    OcclusionBuffer buffer;
    SerialJobs jobs;
};

TEST_F(Occlusion, AFullScreenQuadHidesWhatIsBehindIt) {
    for (const uvec2 size : {uvec2(1, 1), uvec2(7, 3), uvec2(64, 64), uvec2(65, 67),
                             uvec2(333, 129), uvec2(1280, 720)}) {
        const float w = float(size.x), h = float(size.y);
        fill(size.x, size.y, Quads().add(-1, -1, w + 1, h + 1, 0.5f).mesh());
        EXPECT_FALSE(sees(0, 0, w, h, 0.49f)) << size.x << "x" << size.y;
        EXPECT_TRUE(sees(0, 0, w, h, 0.51f)) << size.x << "x" << size.y;
        EXPECT_TRUE(sees(0, 0, w, h, 0.5f)) << "what touches the wall is not behind it";
        EXPECT_EQ(filledPixels(size.x, size.y), size.x * size.y) << "the diagonal is not closed";
    }
}

// The rectangle of a box grows by a pixel on each side: it has to end two pixels from the wall's
// end, whose outermost samples lie on the outline.
TEST_F(Occlusion, ABoxThatSticksOutByAPixelIsVisible) {
    fill(100, 80, Quads().add(10, 10, 50, 40, 0.5f).mesh());
    EXPECT_EQ(filledPixels(100, 80), 40u * 30);
    EXPECT_FALSE(sees(11.5f, 11.5f, 48.5f, 38.5f, 0.4f));
    EXPECT_TRUE(sees(11.5f, 11.5f, 50.6f, 38.5f, 0.4f));
    EXPECT_TRUE(sees(9.4f, 11.5f, 48.5f, 38.5f, 0.4f));
    EXPECT_TRUE(sees(11.5f, 11.5f, 48.5f, 40.6f, 0.4f));
    EXPECT_TRUE(sees(11.5f, 9.4f, 48.5f, 38.5f, 0.4f));
}

TEST_F(Occlusion, AHoleOfAPixelShowsWhatIsBehindIt) {
    for (const uvec2 hole :
         {uvec2(0, 0), uvec2(33, 21), uvec2(40, 20), uvec2(63, 47), uvec2(7, 31)}) {
        const float x = float(hole.x), y = float(hole.y);
        fill(64, 48,
             Quads()
                 .add(-9, -9, 99, y, 0.5f)
                 .add(-9, y + 1, 99, 99, 0.5f)
                 .add(-9, y, x, y + 1, 0.5f)
                 .add(x + 1, y, 99, y + 1, 0.5f)
                 .mesh());
        EXPECT_EQ(filledPixels(64, 48), 64u * 48 - 1) << "hole at " << x << ", " << y;
        EXPECT_TRUE(sees(0, 0, 64, 48, 0.1f)) << "hole at " << x << ", " << y;
        EXPECT_TRUE(sees(x + 0.4f, y + 0.4f, x + 0.6f, y + 0.6f, 0.1f));
    }
}

// A crack of less than the grid of a GPU, right through the samples of a column and of a row.
TEST_F(Occlusion, ACrackOnTheSamplesIsOpen) {
    fill(64, 48, Quads().add(-9, -9, 20.5f, 99, 0.5f).add(20.501f, -9, 99, 99, 0.5f).mesh());
    EXPECT_EQ(filledPixels(64, 48), 63u * 48);
    EXPECT_TRUE(sees(18, 10, 23, 12, 0.1f));
    fill(64, 48, Quads().add(-9, -9, 99, 20.5f, 0.5f).add(-9, 20.501f, 99, 99, 0.5f).mesh());
    EXPECT_EQ(filledPixels(64, 48), 64u * 47);
}

TEST_F(Occlusion, AnOutlineDoesNotCutOtherOccluders) {
    const OccluderMesh cracked =
        Quads().add(-9, -9, 20.5f, 99, 0.5f).add(20.501f, -9, 99, 99, 0.5f).mesh();
    const OccluderMesh behind = Quads().add(-9, -9, 40.5f, 99, 0.4f).mesh();  // has an outline of
                                                                              // its own
    buffer.begin(64, 48, pixelView(64, 48));
    buffer.addOccluder({&cracked, mat4x3(1), false});
    buffer.addOccluder({&behind, mat4x3(1), false});
    buffer.rasterize(jobs);
    EXPECT_EQ(filledPixels(64, 48), 64u * 48);
    EXPECT_NEAR(buffer.depthAt(20, 9), 0.4f, 0.001f);
    EXPECT_NEAR(buffer.depthAt(21, 9), 0.5f, 0.001f);
}

TEST_F(Occlusion, EdgesThatAreSharedAreClosed) {
    Quads joined;
    joined.add(-9, -9, 20.5f, 99, 0.5f).add(20.5f, -9, 99, 99, 0.5f);
    fill(64, 48, joined.mesh());
    EXPECT_EQ(filledPixels(64, 48), 64u * 48);
}

TEST_F(Occlusion, FacesCountFromTheSideThatIsDrawn) {
    const OccluderMesh quad = Quads().add(-1, -1, 65, 49, 0.5f).mesh();
    mat4x3 flipped(1);
    flipped[0].x = -1;
    flipped[3].x = 64;
    const mat4 view = pixelView(64, 48);
    const mat4 fromBehind = view * mat4(vec4(-1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0),
                                        vec4(64, 0, 0, 1));
    fill(64, 48, view, {&quad, mat4x3(1), false});
    EXPECT_FALSE(sees(0, 0, 64, 48, 0.1f));
    fill(64, 48, fromBehind, {&quad, mat4x3(1), false});
    EXPECT_TRUE(sees(0, 0, 64, 48, 0.1f)) << "a back face hides nothing";
    fill(64, 48, fromBehind, {&quad, mat4x3(1), true});
    EXPECT_FALSE(sees(0, 0, 64, 48, 0.1f)) << "unless it is drawn";
    fill(64, 48, view, {&quad, flipped, false});
    EXPECT_FALSE(sees(0, 0, 64, 48, 0.1f)) << "a mirrored object's front is drawn clockwise";
    fill(64, 48, fromBehind, {&quad, flipped, false});
    EXPECT_TRUE(sees(0, 0, 64, 48, 0.1f));
}

TEST_F(Occlusion, DepthIsThatOfTheFarthestSampleOfATile) {
    const std::vector<vec3> slope = {{0, 0, 0.2f}, {64, 0, 0.84f}, {64, 48, 0.84f}, {0, 48, 0.2f}};
    fill(64, 48, makeOccluderMesh(slope, std::array<uint32_t, 6>{0, 1, 2, 0, 2, 3}));
    for (uint32_t x = 0; x < 64; ++x) {
        const float there = 0.2f + 0.01f * (float(x) + 0.5f);
        EXPECT_LT(buffer.depthAt(x, 20), there);
        EXPECT_GT(buffer.depthAt(x, 20), there - 0.01f * 8.5f);
    }
}

mat4 eyeAtOrigin(uint32_t width, uint32_t height, float nearPlane) {
    mat4 m(0.0f);
    m[0][0] = float(height) / float(width);
    m[1][1] = 1;
    m[2][3] = -1;
    m[3][2] = nearPlane;
    return m;
}

TEST_F(Occlusion, WhatReachesInFrontOfTheNearPlaneIsVisible) {
    const OccluderMesh wall = Quads().add(-99, -99, 99, 99, -2).mesh();
    fill(64, 48, eyeAtOrigin(64, 48, 0.1f), {&wall, mat4x3(1), false});
    EXPECT_FALSE(buffer.isVisible({0, 0, -5}, {1, 1, 1}));
    EXPECT_TRUE(buffer.isVisible({0, 0, -5}, {1, 1, 4.95f}));
    EXPECT_TRUE(buffer.isVisible({0, 0, 0}, {9, 9, 9})) << "the eye is inside";
    EXPECT_TRUE(buffer.isVisible({0, 0, 5}, {1, 1, 1}))
        << "behind the eye is for the frustum to tell";
    EXPECT_TRUE(buffer.isVisible({0, 0, -1}, {0.1f, 0.1f, 0.1f}));
}

TEST_F(Occlusion, AnOccluderIsClippedAtTheNearPlane) {
    const vec3 corners[] = {{-50, -1, 20}, {50, -1, 20}, {50, -1, -200}, {-50, -1, -200}};
    const OccluderMesh floor = makeOccluderMesh(corners, std::array<uint32_t, 6>{0, 1, 2, 0, 2, 3});
    fill(320, 240, eyeAtOrigin(320, 240, 0.1f), {&floor, mat4x3(1), false});
    EXPECT_FALSE(buffer.isVisible({0, -3, -5}, {1, 1, 1})) << "under the floor";
    EXPECT_FALSE(buffer.isVisible({2, -6, -30}, {2, 2, 2})) << "under the floor, farther away";
    EXPECT_TRUE(buffer.isVisible({0, -0.5f, -5}, {0.4f, 0.4f, 0.4f})) << "on the floor";
    EXPECT_TRUE(buffer.isVisible({0, 0, -300}, {2, 2, 2})) << "at the horizon";
}

TEST_F(Occlusion, WildNumbersHideNothing) {
    const float huge = std::numeric_limits<float>::max(),
                infinite = std::numeric_limits<float>::infinity();
    std::vector<vec3> positions = {{kNaN, 0, 0.5f}, {64, infinite, 0.5f}, {0, 48, 0.5f},
                                   {-1, -1, 0.5f},  {huge, 5, 0.5f},      {huge, huge, -huge},
                                   {5, 5, 0.5f},    {9, 9, 0.5f}};
    const std::vector<uint32_t> indices = {0, 1, 2, 3, 4, 5, 4, 5,  6, 6, 6,
                                           7, 3, 6, 7, 1, 2, 3, 99, 3, 6};
    const OccluderMesh wild = makeOccluderMesh(positions, indices);
    EXPECT_EQ(wild.triangleCount(), 3u);
    fill(64, 48, wild);
    EXPECT_EQ(filledPixels(64, 48), 0u);

    const OccluderMesh quad = Quads().add(-1, -1, 65, 49, 0.5f).mesh();
    for (const float bad : {kNaN, infinite, huge}) {
        mat4x3 transform(1);
        transform[1].y = bad;
        fill(64, 48, pixelView(64, 48), {&quad, transform, true});
        EXPECT_TRUE(sees(0, 0, 64, 48, 0.1f));
    }
    fill(64, 48, quad);
    EXPECT_FALSE(sees(1, 1, 63, 47, 0.1f));
    for (const float bad : {kNaN, infinite, -infinite})
        for (int axis = 0; axis < 3; ++axis) {
            vec3 center(30, 20, 0.1f), half(1, 1, 0);
            center[axis] = bad;
            EXPECT_TRUE(buffer.isVisible(center, half)) << bad << " in axis " << axis;
            center[axis] = 0.1f;
            half[axis] = bad;
            EXPECT_TRUE(buffer.isVisible(center, half)) << bad << " in axis " << axis;
        }
}

TEST_F(Occlusion, NothingIsHiddenWithoutOccludersOrInATargetThatIsTooLarge) {
    const OccluderMesh quad = Quads().add(-1, -1, 99999, 99999, 0.5f).mesh();
    buffer.begin(64, 48, pixelView(64, 48));
    EXPECT_TRUE(sees(1, 1, 63, 47, 0.1f));
    buffer.rasterize(jobs);
    EXPECT_TRUE(sees(1, 1, 63, 47, 0.1f));
    for (const uvec2 size : {uvec2(0, 9), uvec2(16385, 9), uvec2(16384, 16384)}) {
        fill(size.x, size.y, quad);
        EXPECT_TRUE(sees(3, 3, 5, 5, 0.1f)) << size.x;
    }
    fill(16384, 4096, Quads().add(-1, -1, 16500, 4200, 0.5f).mesh());
    EXPECT_FALSE(sees(3, 3, 16380, 4090, 0.1f));
}

TEST_F(Occlusion, ABoxBesideTheTargetIsNotVisible) {
    fill(64, 48, Quads().add(10, 10, 20, 20, 0.5f).mesh());
    EXPECT_FALSE(sees(70, 10, 80, 20, 0.9f));
    EXPECT_FALSE(sees(10, -30, 20, -10, 0.9f));
    EXPECT_TRUE(sees(64.5f, 10, 80, 20, 0.9f)) << "a pixel's margin";
}

struct Town {
    std::vector<OccluderMesh> meshes;
    std::vector<Occluder> occluders;
    std::vector<OcclusionBox> boxes;
    mat4 view;

    Town() : view(eyeAtOrigin(601, 403, 0.1f)) {
        Random random(3);
        for (const Shape& shape : {makeCube(), makeSphere(12, 16), makeCube(4)})
            meshes.push_back(makeOccluderMesh(shape.positions, shape.indices));
        for (uint32_t i = 0; i < 70; ++i) {
            mat4x3 m(random.uniform(0.3f, 2));
            m[3] = random.vector(-6, 6) - vec3(0, 0, 7);
            occluders.push_back({&meshes[random.below(3)], m, random.below(2) == 0});
        }
        for (uint32_t i = 0; i < 1000; ++i)
            boxes.push_back({random.vector(-15, 15) - vec3(0, 0, 16), random.vector(0.05f, 1)});
    }
    uint64_t fill(OcclusionBuffer& buffer, JobSystem& jobs) const {
        buffer.begin(601, 403, view);
        for (const Occluder& occluder : occluders) buffer.addOccluder(occluder);
        buffer.rasterize(jobs);
        return buffer.hash();
    }
    std::vector<uint8_t> test(const OcclusionBuffer& buffer) const {
        std::vector<uint8_t> visible(boxes.size());
        buffer.test(boxes, visible.data());
        return visible;
    }
};

TEST_F(Occlusion, AnyNumberOfThreadsGivesTheSameBits) {
    const Town town;
    const uint64_t serial = town.fill(buffer, jobs);
    const std::vector<uint8_t> visible = town.test(buffer);
    EXPECT_GT(std::ranges::count(visible, 0), 200);
    EXPECT_GT(std::ranges::count(visible, 1), 200);
    for (const uint32_t threads : {2u, 8u}) {
        ThreadJobs parallel(threads);
        OcclusionBuffer other;
        EXPECT_EQ(town.fill(other, parallel), serial) << threads << " threads";
        EXPECT_EQ(town.fill(other, parallel), serial) << threads << " threads, memory used before";
        EXPECT_EQ(town.test(other), visible);
    }
}

TEST_F(Occlusion, AnyInstructionSetGivesTheSameBits) {
    const Town town;
    const uint64_t expected = town.fill(buffer, jobs);
    const std::vector<uint8_t> visible = town.test(buffer);
    uint32_t tried = 0;
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        EXPECT_EQ(town.fill(buffer, jobs), expected) << hwy::TargetName(target);
        EXPECT_EQ(town.test(buffer), visible) << hwy::TargetName(target);
        ++tried;
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    EXPECT_GE(tried, 1u);
}

TEST_F(Occlusion, BoxesAloneAndTogetherGetTheSameAnswer) {
    const Town town;
    town.fill(buffer, jobs);
    const std::vector<uint8_t> visible = town.test(buffer);
    for (size_t i = 0; i < town.boxes.size(); ++i)
        EXPECT_EQ(buffer.isVisible(town.boxes[i].center, town.boxes[i].halfExtent), visible[i] != 0)
            << i;
}

TEST(OccluderMesh, CornersInOnePlaceAreOneVertexAndEdgesArePaired) {
    const Shape cube = makeCube();
    const OccluderMesh mesh = makeOccluderMesh(cube.positions, cube.indices);
    EXPECT_EQ(mesh.vertexCount, 8u);
    EXPECT_EQ(mesh.triangleCount(), 12u);
    EXPECT_EQ(mesh.reach, vec3(1));
    for (uint32_t c = 0; c < mesh.corners.size(); ++c) {
        const uint32_t other = mesh.neighbours[c];
        ASSERT_LT(other, 12u);
        const uint32_t a = mesh.corners[c], b = mesh.corners[c % 3 == 2 ? c - 2 : c + 1];
        bool reversed = false;
        for (uint32_t k = 0; k < 3; ++k)
            reversed |= mesh.corners[3 * other + k] == b &&
                        mesh.corners[3 * other + (k + 1) % 3] == a &&
                        mesh.neighbours[3 * other + k] == c / 3;
        EXPECT_TRUE(reversed) << "corner " << c;
    }
}

TEST(OccluderMesh, AnEdgeOfThreeTrianglesIsPairedOnce) {
    const std::vector<vec3> positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
    const OccluderMesh mesh = makeOccluderMesh(positions,
                                               std::array<uint32_t, 9>{0, 1, 2, 1, 0, 3, 1, 0, 4});
    EXPECT_EQ(std::ranges::count(mesh.neighbours, OccluderMesh::kNone), 7);
}

TEST(PickOccluders, TakesTheMostAreaForATriangleThatTheBudgetAllows) {
    const std::vector<OccluderCandidate> candidates = {{1000, 100}, {1000, 10}, {50, 1},
                                                       {100, 1},    {0, 5},     {900, 0},
                                                       {kNaN, 4},   {1000, 10}, {1e9f, 500}};
    std::vector<uint32_t> picked;
    pickOccluders(candidates, 100, picked);
    EXPECT_EQ(picked, (std::vector<uint32_t>{1, 3, 7, 2}));
    pickOccluders(candidates, 122, picked);
    EXPECT_EQ(picked, (std::vector<uint32_t>{1, 3, 7, 2, 0}));
    pickOccluders(candidates, 11, picked);
    EXPECT_EQ(picked, (std::vector<uint32_t>{1, 3}));
    pickOccluders(candidates, 0, picked);
    EXPECT_TRUE(picked.empty());
}

}  // namespace
}  // namespace rushlight
