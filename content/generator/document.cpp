#include "content/generator/document.h"

#include "content/generator/png_writer.h"
#include "engine/core/check.h"

#include <algorithm>
#include <cstring>

namespace rushlight::content {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kFloat = 5126, kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

/// A number with six decimals: short in the file, the same everywhere.
double tidy(double x) {
    const double rounded = std::floor(x * 1e6 + 0.5) / 1e6;
    return rounded == 0 ? 0.0 : rounded;
}

template <class V>
Json list(const V& v) {
    Json out = Json::array();
    for (int i = 0; i < V::length(); ++i) out.push_back(tidy(v[i]));
    return out;
}

Json listQuat(const quat& q) { return list(vec4(q.x, q.y, q.z, q.w)); }

/// The rotation that turns -z to `forward`, with y as upright as it can be.
quat lookRotation(const vec3& forward) {
    const vec3 back = -normalize(forward);
    const vec3 right = normalize(cross(vec3(0, 1, 0), back));
    return normalize(glm::quat_cast(mat3(right, cross(back, right), back)));
}

/// The submesh without vertices that no triangle uses, and with equal ones joined, in the order of
/// use.
Submesh welded(const Submesh& in) {
    Submesh out{in.material, {}, {}};
    std::map<std::array<float, 11>, uint32_t> known;
    for (const uint32_t i : in.indices) {
        const Vertex& v = in.vertices[i];
        const auto [found, isNew] = known.try_emplace(
            {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z,
             v.tangent.x, v.tangent.y, v.tangent.z, v.uv.x, v.uv.y},
            uint32_t(out.vertices.size()));
        if (isNew) out.vertices.push_back(v);
        out.indices.push_back(found->second);
    }
    return out;
}

}  // namespace

int Document::addAccessor(int view, int componentType, size_t count, const char* type,
                          size_t offset) {
    accessors_.push_back({{"bufferView", view},
                          {"byteOffset", offset},
                          {"componentType", componentType},
                          {"count", count},
                          {"type", type}});
    return int(accessors_.size() - 1);
}

Json Document::addPrimitive(const Submesh& source) {
    const Submesh submesh = welded(source);
    const std::vector<Vertex>& v = submesh.vertices;
    RL_CHECK(v.size() < 65535, "a submesh has at most 65,534 vertices");
    const size_t floats[4] = {3, 3, 4, 2};
    size_t offset[4];
    for (int k = 0; k < 4; ++k) offset[k] = attributes_[size_t(k)].size() * sizeof(float);
    vec3 low = v[0].position, high = low;
    for (const Vertex& p : v) {
        low = min(low, p.position);
        high = max(high, p.position);
        const float values[4][4] = {{p.position.x, p.position.y, p.position.z, 0},
                                    {p.normal.x, p.normal.y, p.normal.z, 0},
                                    {p.tangent.x, p.tangent.y, p.tangent.z, 1},
                                    {p.uv.x, p.uv.y, 0, 0}};
        for (size_t k = 0; k < 4; ++k)
            attributes_[k].insert(attributes_[k].end(), values[k], values[k] + floats[k]);
    }
    const int position = addAccessor(0, kFloat, v.size(), "VEC3", offset[0]);
    accessors_.back()["min"] = {low.x, low.y, low.z};
    accessors_.back()["max"] = {high.x, high.y, high.z};
    const int normal = addAccessor(1, kFloat, v.size(), "VEC3", offset[1]);
    const int tangent = addAccessor(2, kFloat, v.size(), "VEC4", offset[2]);
    const int uv = addAccessor(3, kFloat, v.size(), "VEC2", offset[3]);
    const int index = addAccessor(4, kUnsignedShort, submesh.indices.size(), "SCALAR",
                                  indices_.size() * sizeof(uint16_t));
    for (const uint32_t i : submesh.indices) indices_.push_back(uint16_t(i));
    return {
        {"attributes",
         {{"POSITION", position}, {"NORMAL", normal}, {"TANGENT", tangent}, {"TEXCOORD_0", uv}}},
        {"indices", index}};
}

int Document::addPart(const std::string& name, const MeshBuilder& mesh) {
    Part part{name, {}};
    for (const Submesh& s : mesh.submeshes())
        if (!s.indices.empty())
            part.primitives.push_back({s.material, addPrimitive(s), s.indices.size() / 3});
    parts_.push_back(std::move(part));
    return int(parts_.size() - 1);
}

int Document::mesh(int part, const Repaint& repaint) {
    const Part& source = parts_[size_t(part)];
    std::string key = std::to_string(part);
    std::string name = source.name;
    for (const auto& [from, to] : repaint) {
        key.append(":")
            .append(std::to_string(int(from)))
            .append(">")
            .append(std::to_string(int(to)));
        name.append("/").append(materialSpec(to).name);
    }
    const auto [found, isNew] = meshOfKey_.try_emplace(key, int(meshes_.size()));
    if (!isNew) return found->second;
    Json primitives = Json::array();
    size_t triangles = 0;
    for (const Primitive& p : source.primitives) {
        Mat id = p.material;
        for (const auto& [from, to] : repaint)
            if (p.material == from) id = to;
        Json json = p.json;
        json["material"] = material(id);
        primitives.push_back(std::move(json));
        triangles += p.triangles;
    }
    meshes_.push_back({{"name", name}, {"primitives", primitives}});
    meshTriangles_.push_back(triangles);
    return found->second;
}

int Document::addPlainMaterial(const Json& material) {
    if (material.contains("extensions")) usesEmissiveStrength_ = true;
    materials_.push_back(material);
    return int(materials_.size() - 1);
}

int Document::addMeshWith(int part, int material, const std::string& name) {
    Json primitives = Json::array();
    size_t triangles = 0;
    for (const Primitive& p : parts_[size_t(part)].primitives) {
        Json json = p.json;
        json["material"] = material;
        primitives.push_back(std::move(json));
        triangles += p.triangles;
    }
    meshes_.push_back({{"name", name}, {"primitives", primitives}});
    meshTriangles_.push_back(triangles);
    return int(meshes_.size() - 1);
}

int Document::addNode(const std::string& name, int parent, const Placement& placement, int mesh) {
    Json node = {{"name", name}};
    if (placement.position != vec3(0)) node["translation"] = list(placement.position);
    if (placement.rotation != quat(1, 0, 0, 0)) node["rotation"] = listQuat(placement.rotation);
    if (placement.scale != vec3(1)) node["scale"] = list(placement.scale);
    if (mesh >= 0) {
        node["mesh"] = mesh;
        drawnTriangles_ += meshTriangles_[size_t(mesh)];
    }
    const int index = int(nodes_.size());
    nodes_.push_back(std::move(node));
    if (parent < 0)
        roots_.push_back(index);
    else
        nodes_[size_t(parent)]["children"].push_back(index);
    return index;
}

void Document::addLight(int node, const LightSpec& light) {
    const char* kinds[] = {"directional", "point", "spot"};
    Json json = {{"name", nodes_[size_t(node)]["name"]},
                 {"type", kinds[int(light.kind)]},
                 {"color", list(light.color)},
                 {"intensity", tidy(light.intensity)}};
    if (light.range > 0) json["range"] = tidy(light.range);
    if (light.kind == LightSpec::Kind::spot)
        json["spot"] = {{"innerConeAngle", tidy(light.coneTurns * 0.6 * 6.283185307179586)},
                        {"outerConeAngle", tidy(light.coneTurns * 6.283185307179586)}};
    // Lamps of one kind share one light: the name is the first one's.
    int index = -1;
    for (size_t i = 0; i < lights_.size(); ++i) {
        Json other = lights_[i];
        other["name"] = json["name"];
        if (other == json) index = int(i);
    }
    if (index < 0) {
        index = int(lights_.size());
        lights_.push_back(std::move(json));
    }
    nodes_[size_t(node)]["extensions"]["KHR_lights_punctual"]["light"] = index;
}

void Document::addCamera(const std::string& name, const vec3& eye, const vec3& target,
                         float fovDegrees) {
    const int camera = int(cameras_.size());
    cameras_.push_back(
        {{"name", name},
         {"type", "perspective"},
         {"perspective", {{"yfov", tidy(fovDegrees * kPi / 180)}, {"znear", 0.05}}}});
    const int node = addNode(name, -1, {eye, lookRotation(target - eye), vec3(1)});
    nodes_[size_t(node)]["camera"] = camera;
}

int Document::texture(const std::string& picture) {
    const auto found = std::find(pictureNames_.begin(), pictureNames_.end(), picture);
    if (found == pictureNames_.end()) pictureNames_.push_back(picture);
    return int(std::find(pictureNames_.begin(), pictureNames_.end(), picture) -
               pictureNames_.begin());
}

int Document::material(Mat id) {
    const auto [found, isNew] = materialOfId_.try_emplace(id, int(materials_.size()));
    if (!isNew) return found->second;
    const MaterialSpec& spec = materialSpec(id);
    Json pbr = {{"baseColorFactor", list(spec.baseColor)},
                {"metallicFactor", tidy(spec.metallic)},
                {"roughnessFactor", tidy(spec.roughness)}};
    Json json = {{"name", spec.name}};
    const std::string detail = spec.detail ? spec.detail : "";
    if (spec.color) pbr["baseColorTexture"]["index"] = texture(std::string(spec.color) + "_color");
    if (!detail.empty() && spec.color) {
        const int packed = texture(detail + "_orm");
        pbr["metallicRoughnessTexture"]["index"] = packed;
        json["occlusionTexture"]["index"] = packed;
    }
    if (!detail.empty()) {
        json["normalTexture"]["index"] = texture(detail + "_normal");
        if (spec.normalScale != 1) json["normalTexture"]["scale"] = tidy(spec.normalScale);
    }
    json["pbrMetallicRoughness"] = pbr;
    if (spec.emissive != vec3(0)) {
        json["emissiveFactor"] = list(spec.emissive);
        if (spec.emissiveMap)
            json["emissiveTexture"]["index"] = texture(std::string(spec.emissiveMap) + "_color");
        if (spec.emissiveStrength != 1) {
            usesEmissiveStrength_ = true;
            json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = tidy(
                spec.emissiveStrength);
        }
    }
    if (spec.alpha == Alpha::mask) {
        json["alphaMode"] = "MASK";
        json["alphaCutoff"] = 0.5;
    }
    if (spec.alpha == Alpha::blend) json["alphaMode"] = "BLEND";
    if (spec.doubleSided) json["doubleSided"] = true;
    materials_.push_back(std::move(json));
    return found->second;
}

void Document::save(const std::filesystem::path& folder) const {
    std::vector<uint8_t> buffer;
    Json views = Json::array();
    const auto append = [&](const void* data, size_t size, int target, size_t stride) {
        Json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}};
        if (stride) view["byteStride"] = stride;
        view["target"] = target;
        views.push_back(std::move(view));
        buffer.resize(buffer.size() + size);
        std::memcpy(buffer.data() + buffer.size() - size, data, size);
        buffer.resize((buffer.size() + 3) & ~size_t(3));
    };
    const size_t strides[4] = {12, 12, 16, 8};
    for (size_t k = 0; k < 4; ++k)
        append(attributes_[k].data(), attributes_[k].size() * 4, kArrayBuffer, strides[k]);
    append(indices_.data(), indices_.size() * 2, kElementArrayBuffer, 0);

    Json json = {{"asset",
                  {{"version", "2.0"},
                   {"generator", "rushlight-content"},
                   {"copyright", "CC0 1.0, the Rushlight authors"}}},
                 {"extensionsUsed", Json::array({"KHR_lights_punctual"})}};
    if (usesEmissiveStrength_) json["extensionsUsed"].push_back("KHR_materials_emissive_strength");
    json["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
    json["scene"] = 0;
    json["scenes"] = Json::array({{{"name", name_}, {"nodes", roots_}}});
    json["nodes"] = nodes_;
    json["cameras"] = cameras_;
    json["meshes"] = meshes_;
    json["materials"] = materials_;
    if (!pictureNames_.empty()) {
        json["samplers"] = Json::array(
            {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}});
        for (size_t i = 0; i < pictureNames_.size(); ++i) {
            json["images"].push_back(
                {{"name", pictureNames_[i]}, {"uri", pictureNames_[i] + ".png"}});
            json["textures"].push_back({{"sampler", 0}, {"source", i}});
        }
    }
    json["accessors"] = accessors_;
    json["bufferViews"] = views;
    json["buffers"] = Json::array({{{"uri", name_ + ".bin"}, {"byteLength", buffer.size()}}});

    const std::string text = json.dump(1, '\t') + "\n";
    writeFile(folder / (name_ + ".gltf"),
              {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
    writeFile(folder / (name_ + ".bin"), buffer);
}

}  // namespace rushlight::content
