#pragma once
// Cascaded shadow views of a directional light: one square region of light space each, around a
// sphere that holds the camera's slice, so that its size does not change as the camera turns, and
// moved by whole texels, so that shadows do not shimmer as it moves (Valient, "Stable Rendering of
// Cascaded Shadow Maps", ShaderX6, 2008).

#include "renderer/geometry/box_block.h"

namespace rushlight {

struct ShadowCascade {
    mat4 clipFromWorld;  ///< reversed z, 1 nearest to the light
    Frustum frustum;     ///< open towards the light: casters in front of the region count
    float uvPerMetre = 0;
    vec2 uvOffset{0};
    float metresPerTexel = 0;
    bool followsCamera = true;  ///< false: it covers the whole scene, wherever the camera is
};

struct ShadowCascades {
    uint32_t count = 0;
    uint32_t resolution = 0;
    float rim = 0;  ///< texels of the filter (RL_SHADOW_RIM)
    /// World to light space: xy in metres, z in [0, 1].
    vec4 rows[3];
    std::array<ShadowCascade, 4> cascades;

    /// Whether a box lies so far inside of a finer cascade that all receivers which it could shade
    /// use that instead. All cascades look down the same axis, so that is exact.
    bool isFinerElsewhere(uint32_t cascade, const vec3& boxCenter, const vec3& boxHalfExtent) const;

    /// Adds the planes between which casters of a cascade lie: its own, and, if it follows the
    /// camera, those of what can shade anything that the camera sees. One that covers the scene
    /// keeps its casters, and so its map, as the camera turns.
    void addVolume(uint32_t cascade, const Frustum& camera, CullVolume& volume) const;
};

struct ShadowCascadeDesc {
    vec3 lightDirection;  ///< unit, the way the light travels
    uint32_t count = 4;
    uint32_t resolution = 2048;
    float distance = 0;  ///< metres from the camera; 0: all of the scene
    Aabb sceneBounds;    ///< of everything that casts or receives; not empty
    uint32_t rim = 3;    ///< texels of the filter (RL_SHADOW_RIM)
};

ShadowCascades makeShadowCascades(const CameraMatrices& camera, const ShadowCascadeDesc& desc);

}  // namespace rushlight
