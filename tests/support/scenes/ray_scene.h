#pragma once
// Boxes and spheres that can both be drawn and be hit by rays: what the screen-space passes are
// measured against.

#include "tests/support/scenes/shapes.h"

#include "renderer/renderer.h"

#include <cmath>
#include <optional>

namespace rushlight {

struct RayHit {
    float distance = 0;
    vec3 normal{0};
    uint32_t object = 0;
};

class RayScene {
public:
    explicit RayScene(Renderer& renderer) {
        const Shape cube = makeCube();
        cube_ = *renderer.createMesh(cube.desc("box"));
        const Shape ball = makeSphere(64, 128);
        MeshDesc desc = ball.desc("ball");
        desc.normals = ball.positions;
        desc.lods = false;
        ball_ = *renderer.createMesh(desc);
    }

    void addBox(vec3 low, vec3 high, MaterialHandle material = {}) {
        add(cube_, (low + high) * 0.5f, (high - low) * 0.5f, material, false);
    }
    void addBall(vec3 center, float radius, MaterialHandle material = {}) {
        add(ball_, center, vec3(radius), material, true);
    }
    std::span<const Instance> instances() const { return instances_; }

    /// The nearest hit beyond `least`; no rays start inside of an object.
    std::optional<RayHit> cast(vec3 origin, vec3 direction, float least = 1e-4f) const {
        std::optional<RayHit> nearest;
        for (uint32_t i = 0; i < objects_.size(); ++i) {
            const auto hit = objects_[i].round ? hitBall(objects_[i], origin, direction, least)
                                               : hitBox(objects_[i], origin, direction, least);
            if (hit && (!nearest || hit->distance < nearest->distance)) {
                nearest = hit;
                nearest->object = i;
            }
        }
        return nearest;
    }

private:
    struct Object {
        vec3 center, half;
        bool round;
    };
    void add(MeshHandle mesh, vec3 center, vec3 half, MaterialHandle material, bool round) {
        Instance instance;
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= half[c];
        instance.worldFromLocal[3] = center;
        instance.mesh = mesh;
        instance.material = material;
        instances_.push_back(instance);
        objects_.push_back({center, half, round});
    }
    static std::optional<RayHit> hitBox(const Object& box, vec3 origin, vec3 direction,
                                        float least) {
        float enter = -1e30f, leave = 1e30f;
        int side = 0;
        for (int c = 0; c < 3; ++c) {
            const float to = box.center[c] - origin[c];
            if (std::abs(direction[c]) < 1e-12f) {
                if (std::abs(to) >= box.half[c]) return {};
                continue;
            }
            const float middle = to / direction[c], reach = box.half[c] / std::abs(direction[c]);
            if (middle - reach > enter) enter = middle - reach, side = c;
            leave = std::min(leave, middle + reach);
        }
        if (enter >= leave || enter < least) return {};
        RayHit hit{enter, vec3(0), 0};
        hit.normal[side] = direction[side] > 0 ? -1.0f : 1.0f;
        return hit;
    }
    static std::optional<RayHit> hitBall(const Object& ball, vec3 origin, vec3 direction,
                                         float least) {
        const vec3 from = origin - ball.center;
        const float b = glm::dot(from, direction), r = ball.half.x;
        const float d = b * b - glm::dot(from, from) + r * r;
        if (d <= 0 || -b - std::sqrt(d) < least) return {};
        const float distance = -b - std::sqrt(d);
        return RayHit{distance, (from + direction * distance) / r, 0};
    }

    MeshHandle cube_, ball_;
    std::vector<Instance> instances_;
    std::vector<Object> objects_;
};

}  // namespace rushlight
