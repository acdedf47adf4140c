#pragma once
// What shadow maps are bad at, built in code: walls as thin as paper, spheres that touch the
// ground, leaves that are cut from their cards, posts and slats, a room with a crack.

#include "renderer/raytrace/ray_scene.h"
#include "renderer/renderer.h"

#include <vector>

namespace rushlight {

struct TortureScene {
    std::vector<Instance> instances;
    std::vector<DirectionalLight> suns;
    std::vector<PunctualLight> lights;

    /// Puts the same into both.
    TortureScene(Renderer& renderer, RayScene& rays);
    FrameInput frame(const vec3& eye, const vec3& target) const;
};

}  // namespace rushlight
