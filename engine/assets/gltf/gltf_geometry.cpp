#include "engine/assets/geometry_tools.h"
#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/input_error.h"
#include "engine/assets/tangents.h"
#include "engine/core/hash.h"

#include <algorithm>

namespace rushlight::assets {
namespace {

using Attributes = std::map<std::string, int>;

int find(const Attributes& attributes, const char* semantic) {
    const auto it = attributes.find(semantic);
    return it == attributes.end() ? -1 : it->second;
}

int primitiveMode(const tinygltf::Primitive& source) {
    return source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode;
}

const char* modeName(int mode) {
    static const char* const kNames[] = {"points", "lines", "line loop", "line strip"};
    return kNames[mode];
}

/// glTF 2.0, section 3.7.2.1: how strips and fans become triangles. Left-over vertices are ignored,
/// and so are triangles that use a vertex twice, which strips are stitched with.
std::vector<uint32_t> toTriangles(std::vector<uint32_t> list, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        list.resize(list.size() / 3 * 3);
        return list;
    }
    std::vector<uint32_t> out;
    for (size_t i = 0; i + 2 < list.size(); ++i) {
        uint32_t a = list[i], b = list[i + 1 + i % 2], c = list[i + 2 - i % 2];
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) a = list[i + 1], b = list[i + 2], c = list[0];
        if (a != b && b != c && c != a) out.insert(out.end(), {a, b, c});
    }
    return out;
}

std::vector<int> geometryKey(const tinygltf::Primitive& source, int tangentUv) {
    std::vector<int> key = {primitiveMode(source), source.indices, tangentUv};
    const auto add = [&](const Attributes& attributes) {
        for (const auto& [semantic, accessor] : attributes) {
            key.push_back(int(hashText(semantic) & 0x7fffffff));
            key.push_back(accessor);
        }
    };
    add(source.attributes);
    for (const Attributes& target : source.targets) {
        key.push_back(-1);
        add(target);
    }
    return key;
}

void normalizeWeights(std::vector<VertexSkin>& skin, const std::string& what) {
    for (VertexSkin& vertex : skin) {
        if (glm::any(glm::lessThan(vertex.weights, vec4(0))))
            refuse(what + ": WEIGHTS_0 has a negative weight.");
        const float sum = vertex.weights.x + vertex.weights.y + vertex.weights.z + vertex.weights.w;
        vertex.weights = sum > 0 ? vertex.weights / sum : vec4(1, 0, 0, 0);
    }
}

}  // namespace

/// The uv set to make tangents for, or -1: the primitive has its own, or nothing needs them.
int GltfBuilder::tangentUvSet(const tinygltf::Primitive& source) const {
    if (source.material < 0) return -1;
    const Material& material = model_.materials[size_t(source.material)];
    if (material.normalTexture.image < 0) return -1;
    const int uvSet = material.normalTexture.uvSet;
    const bool hasNormals = find(source.attributes, "NORMAL") >= 0;
    if (hasNormals && find(source.attributes, "TANGENT") >= 0) return -1;
    const bool hasUv = find(source.attributes, uvSet == 1 ? "TEXCOORD_1" : "TEXCOORD_0") >= 0;
    return hasUv ? uvSet : -1;
}

std::vector<uint32_t> GltfBuilder::readIndices(const tinygltf::Primitive& source) const {
    const size_t vertexCount = reader_.count(find(source.attributes, "POSITION"));
    std::vector<uint32_t> indices;
    if (source.indices < 0) {
        indices.resize(vertexCount);
        for (size_t i = 0; i < vertexCount; ++i) indices[i] = uint32_t(i);
    } else {
        indices = reader_.integers(source.indices);  // checkIndices has been over them
    }
    return toTriangles(std::move(indices), primitiveMode(source));
}

void GltfBuilder::readAttributes(Geometry& geometry, const tinygltf::Primitive& source,
                                 const std::string& what) {
    const Attributes& attributes = source.attributes;
    const auto accessor = [&](const char* semantic) { return find(attributes, semantic); };
    geometry.positions = reader_.vectors<vec3>(accessor("POSITION"));
    if (accessor("NORMAL") >= 0) geometry.normals = reader_.vectors<vec3>(accessor("NORMAL"));
    if (accessor("TANGENT") >= 0) geometry.tangents = reader_.vectors<vec4>(accessor("TANGENT"));
    if (accessor("TEXCOORD_0") >= 0) geometry.uv0 = reader_.vectors<vec2>(accessor("TEXCOORD_0"));
    if (accessor("TEXCOORD_1") >= 0) geometry.uv1 = reader_.vectors<vec2>(accessor("TEXCOORD_1"));
    if (const int colors = accessor("COLOR_0"); colors >= 0) {
        if (componentCount(reader_.get(colors)) == 4) {
            geometry.colors = reader_.vectors<vec4>(colors);
        } else {
            for (const vec3& color : reader_.vectors<vec3>(colors))
                geometry.colors.emplace_back(color, 1.0f);
        }
    }
    const int joints = accessor("JOINTS_0"), weights = accessor("WEIGHTS_0");
    if ((joints < 0) != (weights < 0))
        refuse(what + ": it has only one of JOINTS_0 and WEIGHTS_0.");
    if (joints < 0) return;
    const std::vector<uint32_t> flat = reader_.integers(joints);
    const std::vector<vec4> values = reader_.vectors<vec4>(weights);
    geometry.skin.resize(values.size());
    for (size_t i = 0; i < values.size(); ++i) {
        for (size_t c = 0; c < 4; ++c) geometry.skin[i].joints[c] = uint16_t(flat[i * 4 + c]);
        geometry.skin[i].weights = values[i];
    }
    normalizeWeights(geometry.skin, what);
}

void GltfBuilder::readMorphTargets(Geometry& geometry, const tinygltf::Primitive& source,
                                   const std::string& what) {
    for (const Attributes& attributes : source.targets) {
        MorphTarget target;
        for (const auto& [semantic, accessor] : attributes) {
            if (semantic == "POSITION")
                target.positions = reader_.vectors<vec3>(accessor);
            else if (semantic == "NORMAL")
                target.normals = reader_.vectors<vec3>(accessor);
            else if (semantic == "TANGENT")
                target.tangents = reader_.vectors<vec3>(accessor);
            else
                unsupported(what + ": morph target attribute " + semantic);
        }
        geometry.morphTargets.push_back(std::move(target));
    }
}

Geometry GltfBuilder::readGeometry(const tinygltf::Primitive& source, int tangentUv,
                                   const std::string& what) {
    Geometry geometry;
    readAttributes(geometry, source, what);
    readMorphTargets(geometry, source, what);
    geometry.indices = readIndices(source);
    if (geometry.normals.empty()) {
        makeFlatNormals(geometry);
        for (MorphTarget& target : geometry.morphTargets) {
            target.normals.clear();
            if (!target.positions.empty())
                approximated(what + ": flat normals do not follow morph targets");
        }
    } else {
        repairNormals(geometry);
    }
    if (tangentUv >= 0) makeTangents(geometry, tangentUv);
    for (vec4& tangent : geometry.tangents) {
        const float length = glm::length(vec3(tangent));
        tangent = vec4(length > 0 ? vec3(tangent) / length : vec3(1, 0, 0),
                       tangent.w < 0 ? -1.0f : 1.0f);
    }
    computeBounds(geometry);
    return geometry;
}

int GltfBuilder::geometryFor(const tinygltf::Primitive& source, const std::string& what) {
    const int tangentUv = tangentUvSet(source);
    const auto [it, isNew] = geometryOf_.try_emplace(geometryKey(source, tangentUv),
                                                     int(model_.geometries.size()));
    if (!isNew) return it->second;
    const uint64_t corners = source.indices >= 0 ? reader_.count(source.indices) : 0;
    elements_ += corners + reader_.count(find(source.attributes, "POSITION"));
    if (elements_ > options_.maxElements)
        refuse(what + ": with it the file has " + std::to_string(elements_) +
               " vertices and indices; the limit is " + std::to_string(options_.maxElements) + ".");
    Geometry geometry = readGeometry(source, tangentUv, what);
    if (geometry.indices.empty()) return it->second = -1;  // nothing to draw
    geometry.name = what;
    model_.geometries.push_back(std::move(geometry));
    return it->second;
}

void GltfBuilder::buildPrimitive(Mesh& mesh, const tinygltf::Primitive& source,
                                 const std::string& what) {
    const int position = find(source.attributes, "POSITION");
    if (position < 0) {
        unsupported(what + ": no POSITION (left out)");
        return;
    }
    for (const auto& [semantic, accessor] : source.attributes)
        checkAttribute(semantic, accessor, reader_.count(position), false, what);
    for (const Attributes& target : source.targets)
        for (const auto& [semantic, accessor] : target)
            checkAttribute(semantic, accessor, reader_.count(position), true, what);
    checkIndices(source, what);
    const int mode = primitiveMode(source);
    if (mode < TINYGLTF_MODE_TRIANGLES) {
        unsupported(what + ": primitive mode " + modeName(mode) + " (left out)");
        return;
    }
    noteAttributes(source, what);
    const int geometry = geometryFor(source, what);
    if (geometry >= 0) mesh.primitives.push_back({geometry, source.material});
}

void GltfBuilder::buildMeshes() {
    for (const tinygltf::Mesh& source : gltf_.meshes) {
        const std::string name = numbered("mesh", model_.meshes.size(), source.name);
        Mesh mesh;
        mesh.name = source.name;
        mesh.weights.assign(source.weights.begin(), source.weights.end());
        for (size_t i = 0; i < source.primitives.size(); ++i) {
            const size_t targets = source.primitives[i].targets.size();
            const std::string what = name + " " + numbered("primitive", i);
            if (targets != source.primitives[0].targets.size())
                refuse(what + ": it has " + std::to_string(targets) +
                       " morph targets but primitive 0 has " +
                       std::to_string(source.primitives[0].targets.size()) + ".");
            if (!mesh.weights.empty() && mesh.weights.size() != targets)
                refuse(what + ": it has " + std::to_string(targets) +
                       " morph targets but the mesh has " + std::to_string(mesh.weights.size()) +
                       " weights.");
            buildPrimitive(mesh, source.primitives[i], what);
        }
        model_.meshes.push_back(std::move(mesh));
    }
}

}  // namespace rushlight::assets
