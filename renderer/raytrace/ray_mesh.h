#pragma once
// A mesh with the tree over its triangles.

#include "engine/core/bounds.h"
#include "engine/core/result.h"
#include "renderer/frame/resource_descs.h"

#include <embree3/rtcore.h>

#include <array>
#include <memory>
#include <vector>

namespace rushlight {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class T>
using EmbreeOwner = std::unique_ptr<std::remove_pointer_t<T>, EmbreeRelease>;

struct RayMesh {
    std::vector<vec3> positions;  ///< one more than there are: Embree reads 16 bytes of each
    std::vector<vec3> normals;    ///< empty: face normals
    std::vector<vec2> uv0, uv1;
    std::vector<std::array<uint8_t, 4>> colors;  ///< linear
    std::vector<uint32_t> indices;
    Aabb bounds;
    EmbreeOwner<RTCScene> scene;
    EmbreeOwner<RTCGeometry> geometry;
    bool dirty = true;      ///< the tree is to be built
    bool filtered = false;  ///< the alpha filter is set

    uint32_t vertexCount() const { return uint32_t(positions.size()) - 1; }
    /// The corners' values at barycentrics (b.x of the second, b.y of the third).
    template <class T>
    T interpolate(const std::vector<T>& values, uint32_t triangle, const vec2& b) const {
        const uint32_t* i = &indices[size_t(triangle) * 3];
        return values[i[0]] * (1 - b.x - b.y) + values[i[1]] * b.x + values[i[2]] * b.y;
    }
};

/// Copies and checks.
Result<RayMesh> makeRayMesh(const MeshDesc& desc);

/// Builds the tree. `filter`: asked at each hit; null for none.
void buildRayMesh(RayMesh& mesh, RTCDevice device, RTCFilterFunctionN filter);

}  // namespace rushlight
