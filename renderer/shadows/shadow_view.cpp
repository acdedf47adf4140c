#include "renderer/shadows/shadow_view.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

// A thirty-second of the tile: a soft filter reaches this far, and loses 6 % of the resolution.
uint32_t shadowBorder(uint32_t texels, uint32_t share) { return std::max(texels / share, 4u); }

void cubeFaceBasis(uint32_t face, vec3& right, vec3& up, vec3& forward) {
    const uint32_t axis = face / 2;
    forward = vec3(0);
    forward[int(axis)] = face % 2 ? -1.0f : 1.0f;
    up = vec3(0);
    up[int((axis + 1) % 3)] = 1;
    right = glm::cross(forward, up);
}

// Duff and others, "Building an Orthonormal Basis, Revisited", JCGT 2017.
void spotBasis(const vec3& n, vec3& right, vec3& up) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1 / (sign + n.z), b = n.x * n.y * a;
    up = {b, sign + n.y * n.y * a, -n.y};
    right = glm::cross(n, up);
}

float tileTangent(const ShadowFaceDesc& d) {
    return d.tanHalf * float(d.texels) / float(d.texels - 2 * shadowBorder(d.texels, d.border));
}

void makeShadowView(const ShadowFaceDesc& d, ShadowView& view) {
    const float tangent = tileTangent(d);
    // clip = (x / tangent, y / tangent, near, w), x, y and w along right, up and forward
    const vec4 rows[4] = {vec4(d.right / tangent, -glm::dot(d.right, d.position) / tangent),
                          vec4(d.up / tangent, -glm::dot(d.up, d.position) / tangent),
                          vec4(0, 0, 0, d.nearPlane),
                          vec4(d.forward, -glm::dot(d.forward, d.position))};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) view.clipFromWorld[column][row] = rows[row][column];

    view.volume = {};
    const float length = std::sqrt(1 + tangent * tangent);
    const auto add = [&](const vec3& normal, float margin) {
        view.volume.add(Plane{normal, margin - glm::dot(normal, d.position)});
    };
    add((d.forward * tangent + d.right) / length, 0);
    add((d.forward * tangent - d.right) / length, 0);
    add((d.forward * tangent + d.up) / length, 0);
    add((d.forward * tangent - d.up) / length, 0);
    add(d.forward, -d.nearPlane);
    add(-d.forward, d.range);

    view.range = d.range;
    view.scale.eye = d.position;
    view.scale.perspective = true;
    view.scale.nearest = d.nearPlane;
    view.scale.pixelsPerMetre = float(d.texels) / (2 * tangent);
}

GpuShadowFace makeGpuShadowFace(const ShadowFaceDesc& d, uint32_t tileX, uint32_t tileY,
                                uint32_t atlasSize, float radius) {
    const float tangent = tileTangent(d);
    const float texelUv = 1 / float(atlasSize);
    const float half = float(d.texels) / 2;
    GpuShadowFace face;
    face.uvPerTangent = half * texelUv / tangent;
    face.right = d.right * face.uvPerTangent;
    face.up = d.up * face.uvPerTangent;
    face.forward = d.forward;
    face.centerU = (float(tileX) + half) * texelUv;
    face.centerV = (float(tileY) + half) * texelUv;
    face.nearPlane = d.nearPlane;
    face.softLimit = float(shadowBorder(d.texels, d.border)) - 2;
    face.texelTangent = tangent / half;
    face.radius = radius;
    return face;
}

}  // namespace rushlight
