#include "content/generator/mesh_builder.h"

#include "engine/core/check.h"

namespace rushlight::content {

MeshBuilder& MeshBuilder::use(Mat material) {
    grain_ = vec3(0);
    for (currentIndex_ = 0; currentIndex_ < submeshes_.size(); ++currentIndex_)
        if (submeshes_[currentIndex_].material == material) return *this;
    submeshes_.push_back({material, {}, {}});
    return *this;
}

MeshBuilder& MeshBuilder::grain(const vec3& axis) {
    grain_ = axis;
    return *this;
}

MeshBuilder& MeshBuilder::place(const vec3& position, double yawTurns) {
    return placeRotated(position, rotationTurns({0, 1, 0}, yawTurns));
}

MeshBuilder& MeshBuilder::placeRotated(const vec3& position, const quat& rotation) {
    position_ = position;
    rotation_ = rotation;
    return *this;
}

float MeshBuilder::tile() const { return materialSpec(submeshes_[currentIndex_].material).metres; }

size_t MeshBuilder::triangleCount() const {
    size_t count = 0;
    for (const Submesh& s : submeshes_) count += s.indices.size() / 3;
    return count;
}

UvFrame MeshBuilder::frameFor(const vec3& normal) const {
    const vec3 wanted = dot(grain_, grain_) > 0 ? grain_ : vec3(0, 1, 0);
    vec3 up = wanted - normal * dot(wanted, normal);
    if (dot(up, up) < 0.05f) {
        const vec3 other = std::fabs(normal.z) < 0.7f ? vec3(0, 0, -1) : vec3(1, 0, 0);
        up = other - normal * dot(other, normal);
    }
    up = normalize(up);
    return {cross(up, normal), up};
}

Vertex MeshBuilder::mapped(const vec3& position, const vec3& normal, const UvFrame& frame) const {
    vec3 tangent = frame.right - normal * dot(frame.right, normal);
    tangent = dot(tangent, tangent) > 0.3f ? normalize(tangent)
                                           : normalize(cross(frame.up, normal));
    return {position, normal, tangent,
            vec2(dot(position, frame.right), -dot(position, frame.up)) / tile()};
}

uint32_t MeshBuilder::add(Vertex vertex) {
    RL_CHECK(!submeshes_.empty(), "a material is chosen before a shape is built");
    vertex.position = rotation_ * vertex.position + position_;
    vertex.normal = normalize(rotation_ * vertex.normal);
    const vec3 tangent = rotation_ * vertex.tangent;
    vertex.tangent = normalize(tangent - vertex.normal * dot(tangent, vertex.normal));
    current().vertices.push_back(vertex);
    return uint32_t(current().vertices.size() - 1);
}

void MeshBuilder::addTriangle(uint32_t a, uint32_t b, uint32_t c) {
    const auto& v = current().vertices;
    const vec3 area = cross(v[b].position - v[a].position, v[c].position - v[a].position);
    if (dot(area, area) < 1e-14f) return;
    current().indices.insert(current().indices.end(), {a, b, c});
}

void MeshBuilder::triangle(const vec3& a, const vec3& b, const vec3& c) {
    const vec3 normal = normalize(cross(b - a, c - a));
    const UvFrame frame = frameFor(normal);
    const uint32_t first = add(mapped(a, normal, frame));
    add(mapped(b, normal, frame));
    add(mapped(c, normal, frame));
    addTriangle(first, first + 1, first + 2);
}

void MeshBuilder::quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const vec3 normal = normalize(cross(c - a, d - b));
    const UvFrame frame = frameFor(normal);
    const uint32_t first = add(mapped(a, normal, frame));
    for (const vec3& p : {b, c, d}) add(mapped(p, normal, frame));
    addTriangle(first, first + 1, first + 2);
    addTriangle(first, first + 2, first + 3);
}

void MeshBuilder::card(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const vec3 normal = normalize(cross(c - a, d - b));
    const vec3 right = normalize(b - a);
    const uint32_t first = add({a, normal, right, {0, 1}});
    add({b, normal, right, {1, 1}});
    add({c, normal, right, {1, 0}});
    add({d, normal, right, {0, 0}});
    addTriangle(first, first + 1, first + 2);
    addTriangle(first, first + 2, first + 3);
}

void MeshBuilder::grid(int columns, int rows, const std::function<Vertex(int, int)>& at) {
    const auto first = uint32_t(current().vertices.size());
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) add(at(i, j));
    const auto index = [&](int i, int j) { return first + uint32_t(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            addTriangle(index(i, j), index(i + 1, j), index(i + 1, j + 1));
            addTriangle(index(i, j), index(i + 1, j + 1), index(i, j + 1));
        }
}

}  // namespace rushlight::content
