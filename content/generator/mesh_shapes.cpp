// The solid shapes of MeshBuilder.

#include "content/generator/mesh_builder.h"

#include "engine/core/check.h"

namespace rushlight::content {
namespace {

/// The corners of a hexahedron's face, counter-clockwise from outside. Faces: -x, +x, -y, +y, -z,
/// +z.
std::array<int, 4> faceLoop(int face) {
    const int axis = face / 2;
    const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
    const int base = face % 2 ? 1 << axis : 0;
    if (face % 2) return {base, base | u, base | u | v, base | v};
    return {base, base | v, base | u | v, base | u};
}

bool onFace(int corner, int face) { return ((corner >> (face / 2)) & 1) == face % 2; }

}  // namespace

void MeshBuilder::box(const vec3& low, const vec3& high, float bevel) {
    std::array<vec3, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[size_t(i)] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                              i & 4 ? high.z : low.z};
    hexahedron(corners, bevel);
}

void MeshBuilder::hexahedron(const std::array<vec3, 8>& corners, float bevel) {
    std::array<std::array<vec3, 8>, 6> inset{};
    std::array<vec3, 6> normals;
    for (int face = 0; face < 6; ++face) {
        const std::array<int, 4> loop = faceLoop(face);
        const auto at = [&](int k) { return corners[size_t(loop[size_t(k & 3)])]; };
        normals[size_t(face)] = normalize(cross(at(2) - at(0), at(3) - at(1)));
        for (int k = 0; k < 4; ++k)
            inset[size_t(face)][size_t(loop[size_t(k)])] = at(k) +
                                                           bevel * (normalize(at(k + 1) - at(k)) +
                                                                    normalize(at(k + 3) - at(k)));
        const auto& in = inset[size_t(face)];
        const UvFrame frame = frameFor(normals[size_t(face)]);
        const auto first = uint32_t(current().vertices.size());
        for (const int c : loop) add(mapped(in[size_t(c)], normals[size_t(face)], frame));
        addTriangle(first, first + 1, first + 2);
        addTriangle(first, first + 2, first + 3);
    }
    if (bevel <= 0) return;
    for (int a = 0; a < 6; ++a) {
        const std::array<int, 4> loop = faceLoop(a);
        for (int k = 0; k < 4; ++k) {
            const int from = loop[size_t(k)], to = loop[size_t((k + 1) & 3)];
            for (int b = a + 1; b < 6; ++b)
                if (onFace(from, b) && onFace(to, b))
                    hexahedronEdge(inset, normals, a, b, from, to);
        }
    }
    for (int c = 0; c < 8; ++c) {
        const int x = c & 1, y = 2 + ((c >> 1) & 1), z = 4 + ((c >> 2) & 1);
        const bool even = ((c & 1) + ((c >> 1) & 1) + ((c >> 2) & 1)) % 2 == 1;
        const std::array<int, 3> faces = {x, even ? y : z, even ? z : y};
        const UvFrame frame = frameFor(normals[size_t(x)]);
        const auto first = uint32_t(current().vertices.size());
        for (const int f : faces)
            add(mapped(inset[size_t(f)][size_t(c)], normals[size_t(f)], frame));
        addTriangle(first, first + 1, first + 2);
    }
}

void MeshBuilder::hexahedronEdge(const std::array<std::array<vec3, 8>, 6>& inset,
                                 const std::array<vec3, 6>& normals, int faceA, int faceB, int from,
                                 int to) {
    const size_t a = size_t(faceA), b = size_t(faceB);
    const UvFrame frame = frameFor(normals[a]);
    const auto first = uint32_t(current().vertices.size());
    add(mapped(inset[a][size_t(to)], normals[a], frame));
    add(mapped(inset[a][size_t(from)], normals[a], frame));
    add(mapped(inset[b][size_t(from)], normals[b], frame));
    add(mapped(inset[b][size_t(to)], normals[b], frame));
    addTriangle(first, first + 1, first + 2);
    addTriangle(first, first + 2, first + 3);
}

void MeshBuilder::lathe(const Profile& profile, int segments, float radiusScaleX) {
    RL_CHECK(profile.size() >= 2, "a profile has at least two points");
    const auto direction = [&](size_t i) { return normalize(profile[i + 1] - profile[i]); };
    const auto outward = [&](size_t i) { return vec2(direction(i).y, -direction(i).x); };
    float widest = 0;
    for (const vec2& p : profile) widest = std::fmax(widest, p.x);
    const float repeats = std::fmax(1.0f, std::floor(2 * kPi * widest / tile() + 0.5f));
    const auto joined = [&](size_t segment, size_t neighbour) {
        const vec2 n = outward(segment), m = outward(neighbour);
        return dot(n, m) > 0.766f ? normalize(n + m) : n;
    };
    float length = 0;
    for (size_t s = 0; s + 1 < profile.size(); ++s) {
        const vec2 low = profile[s], high = profile[s + 1];
        const vec2 lowNormal = s > 0 ? joined(s, s - 1) : outward(s);
        const vec2 highNormal = s + 2 < profile.size() ? joined(s, s + 1) : outward(s);
        const vec2 span = high - low;
        const float step = std::sqrt(dot(span, span));
        const float from = length;
        grid(segments, 1, [&](int i, int j) {
            const vec3 out = yawDirection(double(i) / segments);
            const vec2 p = j ? high : low, n = j ? highNormal : lowNormal;
            const vec3 position(out.x * p.x * radiusScaleX, p.y, out.z * p.x);
            const vec3 normal(out.x * n.x / radiusScaleX, n.y, out.z * n.x);
            const vec3 tangent(out.z * radiusScaleX, 0, -out.x);
            return Vertex{
                position,
                normal,
                tangent,
                {repeats * float(i) / float(segments), -(from + (j ? step : 0)) / tile()}};
        });
        length += step;
    }
}

void MeshBuilder::tube(std::span<const vec3> path, float radius, int sides) {
    const size_t last = path.size() - 1;
    vec3 axis = normalize(path[1] - path[0]);
    vec3 side = normalize(cross(axis, std::fabs(axis.y) < 0.9f ? vec3(0, 1, 0) : vec3(0, 0, 1)));
    std::vector<vec3> sidesAt, axes;
    float length = 0;
    std::vector<float> lengths;
    for (size_t i = 0; i <= last; ++i) {
        const vec3 before = i > 0 ? normalize(path[i] - path[i - 1]) : axis;
        const vec3 after = i < last ? normalize(path[i + 1] - path[i]) : before;
        axis = normalize(before + after);
        side = normalize(side - axis * dot(side, axis));
        sidesAt.push_back(side);
        axes.push_back(axis);
        if (i > 0) length += std::sqrt(dot(path[i] - path[i - 1], path[i] - path[i - 1]));
        lengths.push_back(length);
    }
    const auto radial = [&](size_t i, double turns) {
        return float(cosTurns(turns)) * sidesAt[i] +
               float(sinTurns(turns)) * cross(axes[i], sidesAt[i]);
    };
    const float around = std::fmax(1.0f, std::floor(2 * kPi * radius / tile() + 0.5f));
    grid(sides, int(last), [&](int i, int j) {
        const double turns = double(i) / sides;
        const size_t k = size_t(j);
        const vec3 out = radial(k, turns);
        return Vertex{path[k] + radius * out,
                      out,
                      cross(axes[k], out),
                      {around * float(i) / float(sides), -lengths[k] / tile()}};
    });
    for (const size_t end : {size_t(0), last})
        for (int i = 0; i < sides; ++i) {
            const vec3 p = path[end] + radius * radial(end, double(i) / sides);
            const vec3 q = path[end] + radius * radial(end, double(i + 1) / sides);
            end == 0 ? triangle(path[end], q, p) : triangle(path[end], p, q);
        }
}

void MeshBuilder::moulding(const Profile& profile, float x0, float x1) {
    for (size_t i = 0; i + 1 < profile.size(); ++i) {
        const vec2 a = profile[i], b = profile[i + 1];
        quad({x0, a.y, a.x}, {x1, a.y, a.x}, {x1, b.y, b.x}, {x0, b.y, b.x});
        if (b.y - a.y < 1e-4f) continue;
        quad({x0, a.y, 0}, {x0, a.y, a.x}, {x0, b.y, b.x}, {x0, b.y, 0});
        quad({x1, a.y, a.x}, {x1, a.y, 0}, {x1, b.y, 0}, {x1, b.y, b.x});
    }
}

}  // namespace rushlight::content
