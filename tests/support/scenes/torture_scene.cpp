#include "tests/support/scenes/torture_scene.h"

#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class Builder {
public:
    Builder(Renderer& renderer, RayScene& rays, std::vector<Instance>& instances)
        : renderer_(renderer), rays_(rays), instances_(instances) {
        cube_ = mesh(makeCube().desc("cube"));
        const Shape sphere = makeSphere(64, 128);
        MeshDesc round = sphere.desc("sphere");
        round.normals = sphere.positions;
        ball_ = mesh(round);
        card_ = leafCard();
        leaf_ = leafMaterial();
        MaterialDesc matte;
        matte.label = "matte";
        matte.metallic = 0;
        matte_ = renderer.createMaterial(matte).value();
        EXPECT_TRUE(rays.setMaterial(matte_, matte));
    }
    void box(const vec3& center, const vec3& half, float yaw = 0) {
        add(cube_, matte_, center, half, yaw);
    }
    void ball(const vec3& center, float radius) { add(ball_, matte_, center, vec3(radius), 0); }
    void leaf(const vec3& center, float size, float yaw) {
        add(card_, leaf_, center, vec3(size), yaw);
    }

private:
    MeshHandle mesh(const MeshDesc& desc) {
        const MeshHandle made = renderer_.createMesh(desc).value();
        EXPECT_TRUE(rays_.setMesh(made, desc));
        return made;
    }
    MeshHandle leafCard() {
        const vec3 positions[] = {{-1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {-1, 2, 0}};
        const vec2 uvs[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
        MeshDesc desc;
        desc.label = "leaf card";
        desc.positions = positions;
        desc.uv0 = uvs;
        desc.indices = indices;
        return mesh(desc);
    }
    MaterialHandle leafMaterial() {
        constexpr uint32_t kSide = 128;
        std::vector<uint8_t> pixels(kSide * kSide * 4, 200);
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x) {
                const vec2 p = vec2(float(x % 32) + 0.5f, float(y % 64) + 0.5f) / vec2(16, 32) -
                               1.0f;
                const bool inside = std::abs(p.x) < 0.7f * (1 - p.y * p.y);
                pixels[(y * kSide + x) * 4 + 3] = inside ? 255 : 0;
            }
        ImageDesc image;
        image.label = "leaves";
        image.width = image.height = kSide;
        image.pixels = pixels;
        const ImageHandle handle = renderer_.createImage(image).value();
        EXPECT_TRUE(rays_.setImage(handle, image));
        MaterialDesc material;
        material.label = "leaves";
        material.baseColorTexture.image = handle;
        material.metallic = 0;
        material.alphaMode = AlphaMode::mask;
        material.doubleSided = true;
        const MaterialHandle made = renderer_.createMaterial(material).value();
        EXPECT_TRUE(rays_.setMaterial(made, material));
        return made;
    }
    void add(MeshHandle mesh, MaterialHandle material, const vec3& at, const vec3& size,
             float yaw) {
        Instance instance;
        instance.mesh = mesh;
        instance.material = material;
        const mat3 turn(glm::rotate(mat4(1), yaw, vec3(0, 1, 0)));
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] = turn[c] * size[c];
        instance.worldFromLocal[3] = at;
        instances_.push_back(instance);
    }

    Renderer& renderer_;
    RayScene& rays_;
    std::vector<Instance>& instances_;
    MeshHandle cube_, ball_, card_;
    MaterialHandle leaf_, matte_;
};

}  // namespace

TortureScene::TortureScene(Renderer& renderer, RayScene& rays) {
    Builder build(renderer, rays, instances);
    build.box({0, -0.5f, 0}, {12, 0.5f, 12});
    // thin walls, two of them a room's corner
    build.box({-3, 1, -3}, {2, 1, 0.005f});
    build.box({-5, 1, -1}, {0.005f, 1, 2});
    build.box({2.5f, 1.2f, -2}, {0.01f, 1.2f, 1.5f}, 0.4f);
    // spheres on the plane, and one just above it
    for (int i = 0; i < 6; ++i) {
        const float r = 0.1f + 0.1f * float(i);
        build.ball({-4 + 1.5f * float(i), r, 1.5f}, r);
    }
    build.ball({0, 1.05f, -1}, 0.5f);
    // posts, slats and steps
    for (int i = 0; i < 12; ++i) build.box({-4 + 0.7f * float(i), 0.5f, 3}, {0.01f, 0.5f, 0.01f});
    for (int i = 0; i < 10; ++i)
        build.box({5, 0.2f + 0.15f * float(i), -1}, {0.6f, 0.01f, 0.08f}, 0.3f);
    for (int i = 0; i < 5; ++i)
        build.box({5, 0.1f * float(i) + 0.05f, 4 - 0.4f * float(i)}, {1, 0.05f, 0.2f});
    Random random(11);
    for (int i = 0; i < 60; ++i)
        build.leaf({random.uniform(-2, 2), random.uniform(0, 0.6f), random.uniform(4, 6)},
                   random.uniform(0.15f, 0.3f), random.uniform(0, 6));
    PunctualLight point;
    point.castsShadow = true;
    point.position = {0.5f, 3.2f, 0.7f};
    point.range = 14;
    lights.push_back(point);
    PunctualLight spot = point;
    spot.position = {-6, 3.5f, 5};
    spot.direction = glm::normalize(vec3(0.8f, -0.5f, -0.7f));
    spot.outerConeAngle = 0.6f;
    spot.innerConeAngle = 0.4f;
    lights.push_back(spot);
    suns.push_back({glm::normalize(vec3(-0.6f, -1, -0.35f)), vec3(1)});
}

FrameInput TortureScene::frame(const vec3& eye, const vec3& target) const {
    FrameInput input;
    input.instances = instances;
    input.lighting.directional = suns;
    input.lighting.punctual = lights;
    input.view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
    return input;
}

}  // namespace rushlight
