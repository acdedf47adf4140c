#pragma once

#include "content/generator/mesh_builder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace rushlight::content {

/// Other materials for a part's materials, in pairs (from, to).
using Repaint = std::vector<std::pair<Mat, Mat>>;

struct Placement {
    vec3 position{0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1};
};
inline Placement at(const vec3& position, double yawTurns = 0, float scale = 1) {
    return {position, rotationTurns({0, 1, 0}, yawTurns), vec3(scale)};
}

/// A punctual light, shining along its node's -z. `coneTurns` > 0 makes it a spot of that half
/// angle.
struct LightSpec {
    enum class Kind { sun, point, spot } kind = Kind::point;
    vec3 color{1};
    float intensity = 1;
    float range = 0;
    float coneTurns = 0;
};

/// A glTF 2.0 document under construction; `save` writes NAME.gltf and NAME.bin beside the
/// pictures.
class Document {
public:
    explicit Document(std::string name) : name_(std::move(name)) {}

    /// Uploads a part's geometry once; meshes of it share the accessors.
    int addPart(const std::string& name, const MeshBuilder& mesh);
    /// A mesh of a part, the same one for the same repaint.
    int mesh(int part, const Repaint& repaint = {});
    /// `parent` -1 makes a root. Returns the node.
    int addNode(const std::string& name, int parent, const Placement& placement, int mesh = -1);
    void addLight(int node, const LightSpec& light);
    void addCamera(const std::string& name, const vec3& eye, const vec3& target, float fovDegrees);
    /// A material outside the table, for test pictures.
    int addPlainMaterial(const nlohmann::ordered_json& material);
    int addMeshWith(int part, int material, const std::string& name);

    void save(const std::filesystem::path& folder) const;

    /// The index of a texture of the picture NAME.png, added when it is new.
    int texture(const std::string& picture);
    std::string nodeName(int node) const { return nodes_[size_t(node)]["name"]; }
    size_t nodeCount() const { return nodes_.size(); }
    size_t drawnTriangles() const { return drawnTriangles_; }
    /// Stems of the pictures that the materials used so far refer to.
    const std::vector<std::string>& pictures() const { return pictureNames_; }

private:
    struct Primitive {
        Mat material;
        nlohmann::ordered_json json;
        size_t triangles = 0;
    };
    struct Part {
        std::string name;
        std::vector<Primitive> primitives;
    };

    int material(Mat id);
    int addAccessor(int view, int componentType, size_t count, const char* type, size_t offset);
    nlohmann::ordered_json addPrimitive(const Submesh& submesh);

    std::string name_;
    std::vector<Part> parts_;
    std::map<std::string, int> meshOfKey_;
    std::map<Mat, int> materialOfId_;
    std::vector<std::string> pictureNames_;
    std::vector<size_t> meshTriangles_;
    size_t drawnTriangles_ = 0;
    /// Positions, normals, tangents, texture coordinates; indices are apart.
    std::array<std::vector<float>, 4> attributes_;
    std::vector<uint16_t> indices_;
    nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json meshes_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json materials_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json nodes_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json roots_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json lights_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json cameras_ = nlohmann::ordered_json::array();
    bool usesEmissiveStrength_ = false;
};

}  // namespace rushlight::content
