#pragma once
// Builds closed, counter-clockwise meshes with normals, texture coordinates in metres of the
// material's tile, and tangents that follow from the mapping. Every mapping has u to the right and
// v downwards seen from outside, so that the bitangent cross(normal, tangent) points up in the
// picture and w is always +1.

#include "content/generator/materials.h"
#include "content/generator/numeric.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace rushlight::content {

struct Vertex {
    vec3 position{0};
    vec3 normal{0, 1, 0};
    vec3 tangent{1, 0, 0};
    vec2 uv{0};  ///< in tiles
};

struct Submesh {
    Mat material;
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
};

/// A point of a profile that is turned or drawn: x is the radius or the reach, y the height.
using Profile = std::vector<vec2>;

/// Two unit directions of a plane's mapping; their cross product is the normal.
struct UvFrame {
    vec3 right{1, 0, 0};
    vec3 up{0, 1, 0};
};

class MeshBuilder {
public:
    /// Following shapes have this material; the grain of planks follows each shape's own rule.
    MeshBuilder& use(Mat material);
    /// Following flat shapes have their v axis along this direction where they can; zero: upwards.
    MeshBuilder& grain(const vec3& axis);
    /// Following shapes are turned by `yaw` turns and then moved.
    MeshBuilder& place(const vec3& position, double yawTurns = 0);
    MeshBuilder& placeRotated(const vec3& position, const quat& rotation);
    MeshBuilder& reset() { return place(vec3(0)); }

    /// A flat quadrilateral, counter-clockwise from outside; planar mapping in metres.
    void quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d);
    void triangle(const vec3& a, const vec3& b, const vec3& c);
    /// The same with the whole texture stretched over it once: a is the lower left corner.
    void card(const vec3& a, const vec3& b, const vec3& c, const vec3& d);
    /// A box; with a bevel its edges are rounded by smooth normals.
    void box(const vec3& low, const vec3& high, float bevel = 0);
    /// A bent box: corner i has the greater x for bit 0, y for bit 1, z for bit 2.
    void hexahedron(const std::array<vec3, 8>& corners, float bevel = 0);
    /// A profile from bottom to top turned around the y axis, the outside to its right. Corners of
    /// more than 40 degrees stay hard.
    void lathe(const Profile& profile, int segments, float radiusScaleX = 1);
    /// A tube of the radius along a path, closed by flat caps.
    void tube(std::span<const vec3> path, float radius, int sides);
    /// A moulding along x from x0 to x1: profile (reach towards +z, height), rising; closed at both
    /// ends.
    void moulding(const Profile& profile, float x0, float x1);
    /// (columns + 1) x (rows + 1) vertices made by `at(i, j)`, i along the tangent and j along the
    /// bitangent.
    void grid(int columns, int rows, const std::function<Vertex(int i, int j)>& at);

    float tile() const;
    std::span<const Submesh> submeshes() const { return submeshes_; }
    size_t triangleCount() const;

private:
    Submesh& current() { return submeshes_[currentIndex_]; }
    UvFrame frameFor(const vec3& normal) const;
    Vertex mapped(const vec3& position, const vec3& normal, const UvFrame& frame) const;
    uint32_t add(Vertex vertex);
    void addTriangle(uint32_t a, uint32_t b, uint32_t c);
    void hexahedronEdge(const std::array<std::array<vec3, 8>, 6>& inset,
                        const std::array<vec3, 6>& normals, int faceA, int faceB, int from, int to);

    std::vector<Submesh> submeshes_;
    size_t currentIndex_ = 0;
    vec3 grain_{0};
    vec3 position_{0};
    quat rotation_{1, 0, 0, 0};
};

}  // namespace rushlight::content
