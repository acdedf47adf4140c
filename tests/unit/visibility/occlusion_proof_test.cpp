// The proof by many scenes: nothing that shows a pixel is ever called hidden, and most of what
// shows none is.
#include "renderer/geometry/view_math.h"
#include "renderer/visibility/occlusion/occlusion_buffer.h"
#include "tests/support/random.h"
#include "tests/support/reference_raster.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace rushlight {
namespace {

struct Object {
    uint32_t shape = 0;
    mat4x3 worldFromLocal{1};
    bool twoSided = false, occludes = false;
};

/// A flat grid in the xy plane from -1 to 1, with as many cells left out as `holes` says.
Shape makeGrid(uint32_t cells, uint32_t holes, Random& random) {
    Shape grid;
    for (uint32_t y = 0; y <= cells; ++y)
        for (uint32_t x = 0; x <= cells; ++x)
            grid.positions.push_back(
                {2 * float(x) / float(cells) - 1, 2 * float(y) / float(cells) - 1, 0});
    std::vector<bool> open(size_t(cells) * cells);
    for (uint32_t i = 0; i < holes; ++i) open[random.below(cells * cells)] = true;
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
            if (!open[size_t(y) * cells + x])
                for (uint32_t i : {a, a + 1, b + 1, a, b + 1, b}) grid.indices.push_back(i);
        }
    return grid;
}

Shape makeSoup(uint32_t triangles, Random& random) {
    Shape soup;
    for (uint32_t i = 0; i < 3 * triangles; ++i) {
        soup.positions.push_back(random.vector(-1, 1));
        soup.indices.push_back(i);
    }
    return soup;
}

mat4x3 placed(const vec3& position, const vec3& scale, const mat3& turn) {
    return {turn[0] * scale.x, turn[1] * scale.y, turn[2] * scale.z, position};
}

mat3 randomTurn(Random& random) {
    if (random.below(3) == 0) return mat3(1);
    const vec3 x = random.direction();
    const vec3 y = glm::normalize(glm::cross(x, random.direction() + vec3(0.01f, 0.02f, 0.03f)));
    return {x, y, glm::cross(x, y)};
}

struct Scene {
    std::vector<Shape> shapes;
    std::vector<OccluderMesh> meshes;
    std::vector<Aabb> bounds;
    std::vector<Object> objects;
    mat4 clipFromWorld{1};
    uint32_t width = 0, height = 0;

    explicit Scene(Random& random) {
        shapes = {makeCube(), makeCube(1 + random.below(5)), makeSphere(5 + random.below(6), 8),
                  makeGrid(1 + random.below(6), random.below(4), random), makeSoup(6, random)};
        for (const Shape& shape : shapes) {
            meshes.push_back(makeOccluderMesh(shape.positions, shape.indices));
            Aabb box;
            for (const vec3& p : shape.positions) box.grow(p);
            bounds.push_back(box);
        }
        width = 1 + random.below(200);
        height = 1 + random.below(150);
    }
    void lookFrom(const vec3& eye, const vec3& target, uint32_t kind, Random& random) {
        const float nearPlane = random.uniform(0.02f, 0.5f);
        const float aspect = float(width) / float(height);
        const mat4 clip = kind == 0   ? reversedPerspective(0.6f * aspect, 0.6f, nearPlane, 0)
                          : kind == 1 ? reversedPerspective(0.6f * aspect, 0.6f, nearPlane, 60)
                                      : reversedOrthographic(9 * aspect, 9, -5, 60);
        clipFromWorld = clip * glm::lookAt(eye, target, vec3(0, 1, 0));
    }
    OcclusionBox boxOf(const Object& object) const {
        const Aabb box = transformAabb(object.worldFromLocal, bounds[object.shape]);
        return {box.center(), box.halfExtent()};
    }
    void fill(OcclusionBuffer& buffer) const {
        buffer.begin(width, height, clipFromWorld);
        for (const Object& object : objects)
            if (object.occludes)
                buffer.addOccluder({&meshes[object.shape], object.worldFromLocal, object.twoSided});
        SerialJobs jobs;
        buffer.rasterize(jobs);
    }
    std::vector<uint8_t> culled() const {
        OcclusionBuffer buffer;
        fill(buffer);
        std::vector<OcclusionBox> boxes;
        for (const Object& object : objects) boxes.push_back(boxOf(object));
        std::vector<uint8_t> visible(objects.size());
        buffer.test(boxes, visible.data());
        return visible;
    }
    void draw(ReferenceRaster& raster, size_t i) const {
        const Object& o = objects[i];
        const Shape& shape = shapes[o.shape];
        raster.draw({shape.positions, shape.indices, o.worldFromLocal, o.twoSided}, int(i));
    }
    bool isInTarget(size_t i) const;
    std::vector<uint32_t> pixels(VertexGrid grid) const {
        ReferenceRaster raster(width, height, clipFromWorld, grid);
        for (size_t i = 0; i < objects.size(); ++i) draw(raster, i);
        std::vector<uint32_t> counts(objects.size());
        for (int id : raster.ids)
            if (id >= 0) ++counts[size_t(id)];
        return counts;
    }
};

bool Scene::isInTarget(size_t i) const {
    ReferenceRaster raster(width, height, clipFromWorld, VertexGrid::nearest);
    draw(raster, i);
    return std::ranges::any_of(raster.ids, [](int id) { return id >= 0; });
}

/// Anything anywhere: mirrored, flat, needle-shaped, far from the origin, around the camera.
Scene wildScene(uint64_t seed) {
    Random random(seed);
    Scene scene(random);
    const float distance = std::array{0.0f, 0.0f, 0.0f, 2000.0f, 50000.0f}[random.below(5)];
    const vec3 origin = random.vector(-distance, distance);
    const float spread = random.uniform(3, 12);
    const uint32_t large = 1 + random.below(12), small = 40;
    for (uint32_t i = 0; i < large + small; ++i) {
        Object object;
        object.shape = random.below(uint32_t(scene.shapes.size()));
        object.twoSided = random.below(3) == 0;
        object.occludes = i < large || random.below(4) == 0;
        vec3 scale = i < large ? random.vector(0.5f, 6) : random.vector(0.02f, 0.8f);
        if (random.below(6) == 0) scale[int(random.below(3))] *= 0.001f;
        if (random.below(5) == 0) scale.x = -scale.x;
        object.worldFromLocal = placed(origin + random.vector(-spread, spread), scale,
                                       randomTurn(random));
        scene.objects.push_back(object);
    }
    const vec3 eye = origin + random.vector(-spread, spread);
    scene.lookFrom(eye, eye + random.direction(), random.below(3), random);
    return scene;
}

TEST(OcclusionProof, WhatShowsAPixelIsNeverHidden) {
    uint32_t hidden = 0, gone = 0;
    for (uint64_t seed = 0; seed < 600; ++seed) {
        const Scene scene = wildScene(seed);
        const std::vector<uint8_t> visible = scene.culled();
        for (VertexGrid grid : {VertexGrid::exact, VertexGrid::nearest, VertexGrid::down}) {
            const std::vector<uint32_t> pixels = scene.pixels(grid);
            for (size_t i = 0; i < pixels.size(); ++i) {
                ASSERT_TRUE(visible[i] || pixels[i] == 0)
                    << "seed " << seed << ", object " << i << " of shape " << scene.objects[i].shape
                    << " shows " << pixels[i] << " pixels of " << scene.width << "x"
                    << scene.height;
                gone += pixels[i] == 0;
                hidden += !visible[i];
            }
        }
    }
    EXPECT_GT(hidden * 4, gone) << hidden << " of " << gone;
}

/// Sharper than boxes: nothing is taken for hidden at a pixel that is not behind what an occluder
/// drew there.
TEST(OcclusionProof, NoSampleIsNearerOrWiderThanWhatIsDrawn) {
    uint64_t filled = 0, drawn = 0;
    for (uint64_t seed = 0; seed < 600; ++seed) {
        const Scene scene = wildScene(seed);
        OcclusionBuffer buffer;
        scene.fill(buffer);
        for (VertexGrid grid : {VertexGrid::exact, VertexGrid::nearest, VertexGrid::down}) {
            ReferenceRaster raster(scene.width, scene.height, scene.clipFromWorld, grid);
            for (size_t i = 0; i < scene.objects.size(); ++i)
                if (scene.objects[i].occludes) scene.draw(raster, i);
            for (uint32_t y = 0; y < scene.height; ++y)
                for (uint32_t x = 0; x < scene.width; ++x) {
                    const double there = raster.depths[size_t(y) * scene.width + x];
                    const double ours = double(buffer.depthAt(x, y));
                    ASSERT_LE(ours, there)
                        << "seed " << seed << ", pixel " << x << ", " << y << " of " << scene.width
                        << "x" << scene.height << ", grid " << int(grid);
                    filled += ours > 0;
                    drawn += there > 0;
                }
        }
    }
    EXPECT_GT(filled * 10, drawn * 6) << filled << " of " << drawn;
}

/// Rooms behind walls of 2 to 450 triangles, seen from a corridor.
Scene walledScene(uint64_t seed) {
    Random random(seed);
    Scene scene(random);
    scene.width = 160;
    scene.height = 90;
    scene.shapes[3] = makeGrid(1 + random.below(15), 0, random);
    scene.meshes[3] = makeOccluderMesh(scene.shapes[3].positions, scene.shapes[3].indices);
    for (uint32_t i = 0; i < 6; ++i) {
        const vec3 at(random.uniform(-8, 8), random.uniform(-1, 1), random.uniform(-12, -6));
        const vec3 size(random.uniform(3, 8), random.uniform(3, 8), 0.3f);
        const bool flat = random.below(2) == 0;
        scene.objects.push_back({flat ? 3u : 0u, placed(at, size, mat3(1)), flat, true});
    }
    for (uint32_t i = 0; i < 200; ++i) {
        const vec3 at(random.uniform(-16, 16), random.uniform(-6, 6), random.uniform(-40, -14));
        const vec3 size = random.vector(0.1f, 0.8f);
        scene.objects.push_back(
            {random.below(3), placed(at, size, randomTurn(random)), false, false});
    }
    scene.lookFrom(random.vector(-1, 1), random.vector(-1, 1) + vec3(0, 0, -20), 0, random);
    return scene;
}

TEST(OcclusionProof, MostOfWhatShowsNoPixelIsFound) {
    uint32_t hidden = 0, gone = 0;
    for (uint64_t seed = 0; seed < 40; ++seed) {
        const Scene scene = walledScene(seed);
        const std::vector<uint8_t> visible = scene.culled();
        const std::vector<uint32_t> pixels = scene.pixels(VertexGrid::nearest);
        for (size_t i = 0; i < pixels.size(); ++i) {
            ASSERT_TRUE(visible[i] || pixels[i] == 0) << "seed " << seed << ", object " << i;
            if (pixels[i] > 0 || !scene.isInTarget(i)) continue;
            ++gone;
            hidden += !visible[i];
        }
    }
    EXPECT_GT(gone, 40u * 40);
    EXPECT_GT(hidden * 100, gone * 90) << hidden << " of " << gone;
}

}  // namespace
}  // namespace rushlight
