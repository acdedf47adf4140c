#include "content/generator/parts/parts.h"

namespace rushlight::content {

MeshBuilder groundPart(float x0, float x1, float z0, float z1) {
    MeshBuilder b;
    b.use(Mat::cobble);
    const int columns = int((x1 - x0) / 2 + 0.99f), rows = int((z1 - z0) / 2 + 0.99f);
    b.grid(columns, rows, [&](int i, int j) {
        const float x = mixf(x0, x1, float(i) / float(columns));
        const float z = mixf(z1, z0, float(j) / float(rows));
        return Vertex{{x, 0, z}, {0, 1, 0}, {1, 0, 0}, vec2(x, z) / b.tile()};
    });
    return b;
}

MeshBuilder drainPart(float length) {
    // A channel of hollowed slabs along z, 0.5 wide, its edges at the height of the ground.
    MeshBuilder b;
    b.use(Mat::stoneDark);
    const int slabs = int(length / 0.8f + 0.5f);
    const float step = length / float(slabs);
    for (int i = 0; i < slabs; ++i) {
        const float z0 = -length / 2 + step * float(i) + 0.006f, z1 = z0 + step - 0.012f;
        constexpr int kCuts = 8;
        b.grid(kCuts, 1, [&](int k, int j) {
            const float t = 2 * float(k) / kCuts - 1, s = 0.24f * t;
            const float dip = -0.05f * (1 - t * t);
            const vec3 normal = normalize(vec3(-2 * 0.05f * t / 0.24f, 1, 0));
            const float z = j ? z0 : z1;
            return Vertex{{s, dip, z}, normal, {1, 0, 0}, vec2(s, z) / b.tile()};
        });
    }
    b.use(Mat::soil).quad({-0.25f, -0.06f, length / 2}, {0.25f, -0.06f, length / 2},
                          {0.25f, -0.06f, -length / 2}, {-0.25f, -0.06f, -length / 2});
    b.use(Mat::stoneDark);
    for (const float side : {-1.0f, 1.0f}) {  // the risers between channel and setts
        const float x = 0.25f * side, z = length / 2 * side;
        b.quad({x, -0.06f, -z}, {x, -0.06f, z}, {x, 0, z}, {x, 0, -z});
    }
    return b;
}

MeshBuilder pavementPart(float length, float width) {
    // Along x from the wall at z = 0 to the kerb.
    MeshBuilder b;
    const int slabs = int(length / 1.2f + 0.5f);
    const float step = length / float(slabs);
    for (int i = 0; i < slabs; ++i) {
        const float x0 = -length / 2 + step * float(i), x1 = x0 + step;
        b.use(Mat::stone).box({x0, -0.1f, width - 0.28f}, {x1, 0.12f, width}, 0.015f);
        b.use(Mat::stoneDark);
        const float mid = (width - 0.28f) * (0.42f + 0.2f * unit(uint32_t(i), 601));
        const float lift = 0.006f * unit(uint32_t(i), 602);
        b.box({x0, -0.1f, 0}, {x1, 0.118f - lift, mid}, 0.010f);
        b.box({x0, -0.1f, mid}, {x1, 0.112f + lift, width - 0.28f}, 0.010f);
    }
    return b;
}

}  // namespace rushlight::content
