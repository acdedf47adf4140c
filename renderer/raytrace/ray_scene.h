#pragma once
// A scene to shoot rays through, of the same descriptions and under the same handles as the
// Renderer's: a host gives both what it has while it loads, then build() takes
// FrameInput::instances as they are. It holds its own copies (about 100 bytes a triangle; images at
// most 256 pixels a side plus alpha), so a renderer that traces nothing pays nothing. Blended
// surfaces let all light through and are left out; masked ones are tested at full resolution. Those
// of MaterialDesc::transmission are hit by nothing, and colour what goes through them. Used by one
// thread at a time, but intersect, occluded and surface by any number. Traced by Embree 3; the same
// processor gives the same results for any number of threads.

#include "engine/core/bounds.h"
#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/frame/frame_input.h"

#include <limits>
#include <memory>
#include <span>

namespace rushlight {

struct Ray {
    vec3 origin{0};
    vec3 direction{0, 0, 1};  ///< unit
    float nearest = 0;        ///< metres: hits before are ignored
    float farthest = std::numeric_limits<float>::infinity();
};

struct RayHit {
    float distance = 0;  ///< metres
    vec3 position{0};  ///< of the triangle's corners, more exact than origin + distance * direction
    vec3 geometricNormal{0, 1, 0};  ///< unit, of the front side
    vec3 shadingNormal{0, 1, 0};    ///< unit, interpolated, of the front side; no normal map
    bool front = true;              ///< the ray came from the front side
    uint32_t instance = 0;          ///< index in the span that build() got
    uint32_t triangle = 0;
    vec2 barycentrics{0};  ///< of the triangle's second and third corner
};

/// Textures and vertex colours included.
struct RaySurface {
    vec3 baseColor{1};
    float metallic = 0;
    float roughness = 1;
    vec3 emissive{0};
    bool doubleSided = false;
    bool unlit = false;
    vec3 through{0};  ///< the share of light, by colour, that goes on; holes included, what is
                      ///< mirrored not taken off
};

class RayScene {
public:
    /// `jobs` must outlive it. No thread is started; Embree's scheduler may keep one, idle, once a
    /// scene is destroyed.
    static Result<std::unique_ptr<RayScene>> create(JobSystem& jobs);
    ~RayScene();

    // What the instances name. Again under the same handle: it is replaced, seen after the next
    // build(). Bad descriptions are Errors as the Renderer's are; MeshDesc::lods is not looked at.
    Result<void> setMesh(MeshHandle, const MeshDesc&);
    Result<void> setImage(ImageHandle, const ImageDesc&);
    Result<void> setMaterial(MaterialHandle, const MaterialDesc&);

    /// Makes the scene hold these. Instances with an unknown mesh, or a transform that is not
    /// finite or squashes them flat, are left out and counted; an unknown material is the default
    /// one.
    Result<void> build(std::span<const Instance> instances);
    uint32_t rejected() const;
    /// Of what is in the scene, world space.
    Aabb bounds() const;
    uint64_t triangles() const;

    // After build(). A ray that is not finite hits nothing.

    bool intersect(const Ray& ray, RayHit& hit) const;
    /// Anything between `nearest` and `farthest` that casts shadows (kInstanceCastsShadow)?
    bool occluded(const Ray& ray) const;
    /// The share of light, by colour, that casters leave between `nearest` and `farthest`: 0 where
    /// it is occluded.
    vec3 transmittance(const Ray& ray) const;
    /// What is seen of the light at the ray's end, by colour; nothing opaque is looked for.
    vec3 colorBetween(const Ray& ray) const;
    RaySurface surface(const RayHit& hit) const;

private:
    struct State;
    explicit RayScene(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

/// `position` moved off its surface along `normal` by what keeps a ray from hitting where it
/// starts: a few units in the last place. Wächter and Binder 2019, "A Fast and Robust Method for
/// Avoiding Self-Intersection", Ray Tracing Gems 1, chapter 6.
vec3 offsetOrigin(const vec3& position, const vec3& normal);

}  // namespace rushlight
