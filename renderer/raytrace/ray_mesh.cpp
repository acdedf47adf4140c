#include "renderer/raytrace/ray_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

Result<void> check(const MeshDesc& desc) {
    const std::string object = "mesh '" + std::string(desc.label) + "'";
    const size_t count = desc.positions.size();
    if (count == 0 || count > 1u << 28)
        return fail(object, "it has " + std::to_string(count) +
                                " vertices; 1 to 268,435,456 are possible.");
    if (desc.indices.empty() || desc.indices.size() % 3 != 0)
        return fail(object, "it has " + std::to_string(desc.indices.size()) +
                                " indices; a positive multiple of three is needed.");
    for (uint32_t index : desc.indices)
        if (index >= count)
            return fail(object, "the index " + std::to_string(index) + " is not below the " +
                                    std::to_string(count) + " vertices.");
    for (const vec3& p : desc.positions)
        if (!std::isfinite(p.x + p.y + p.z)) return fail(object, "a position is not finite.");
    for (const size_t size :
         {desc.normals.size(), desc.uv0.size(), desc.uv1.size(), desc.colors.size()})
        if (size != 0 && size != count)
            return fail(object,
                        "an attribute has " + std::to_string(size) + " elements but there are " +
                            std::to_string(count) + " positions.",
                        ErrorKind::wrongUse);
    return {};
}

uint8_t toUnorm8(float x) {
    return std::isfinite(x) ? uint8_t(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)) : uint8_t(0);
}

}  // namespace

Result<RayMesh> makeRayMesh(const MeshDesc& desc) {
    if (auto ok = check(desc); !ok) return tl::unexpected(ok.error());
    RayMesh mesh;
    mesh.positions.reserve(desc.positions.size() + 1);
    mesh.positions.assign(desc.positions.begin(), desc.positions.end());
    mesh.positions.push_back(vec3(0));
    mesh.normals.assign(desc.normals.begin(), desc.normals.end());
    mesh.uv0.assign(desc.uv0.begin(), desc.uv0.end());
    mesh.uv1.assign(desc.uv1.begin(), desc.uv1.end());
    mesh.indices.assign(desc.indices.begin(), desc.indices.end());
    mesh.colors.reserve(desc.colors.size());
    for (const vec4& c : desc.colors)
        mesh.colors.push_back({toUnorm8(c.x), toUnorm8(c.y), toUnorm8(c.z), toUnorm8(c.w)});
    for (uint32_t index : mesh.indices) mesh.bounds.grow(mesh.positions[index]);
    return mesh;
}

void buildRayMesh(RayMesh& mesh, RTCDevice device, RTCFilterFunctionN filter) {
    mesh.scene.reset(rtcNewScene(device));
    mesh.geometry.reset(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    RTCGeometry geometry = mesh.geometry.get();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions.data(), 0, sizeof(vec3), mesh.vertexCount());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.indices.data(), 0, 12, mesh.indices.size() / 3);
    rtcSetGeometryUserData(geometry, &mesh);
    if (filter) {
        rtcSetGeometryIntersectFilterFunction(geometry, filter);
        rtcSetGeometryOccludedFilterFunction(geometry, filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(mesh.scene.get(), geometry);
    rtcSetSceneFlags(mesh.scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(mesh.scene.get());
    mesh.dirty = false;
    mesh.filtered = filter != nullptr;
}

}  // namespace rushlight
