#include "content/generator/noise.h"
#include "content/generator/parts/parts.h"

namespace rushlight::content {

MeshBuilder fountainBasinPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    b.lathe({{3.55f, -0.1f}, {3.55f, 0.13f}, {3.52f, 0.16f}, {3.0f, 0.16f}}, 40);
    b.lathe({{3.1f, 0.10f}, {3.1f, 0.29f}, {3.07f, 0.32f}, {2.5f, 0.32f}}, 40);
    b.lathe({{2.55f, 0.30f},
             {2.55f, 0.42f},
             {2.50f, 0.46f},
             {2.38f, 0.50f},
             {2.34f, 0.58f},
             {2.36f, 0.74f},
             {2.44f, 0.80f},
             {2.52f, 0.84f},
             {2.55f, 0.90f},
             {2.52f, 0.96f},
             {2.44f, 0.98f},
             {2.20f, 0.98f},
             {2.14f, 0.95f},
             {2.12f, 0.90f},
             {2.10f, 0.40f}},
            40);
    b.use(Mat::stoneDark);
    b.lathe({{2.12f, 0.42f}, {0, 0.42f}}, 40);
    b.use(Mat::stone);
    for (int i = 0; i < 12; ++i) {  // pilasters on the outside of the basin
        b.place(vec3(0), double(i) / 12);
        b.box({-0.14f, 0.46f, 2.28f}, {0.14f, 0.82f, 2.46f}, 0.015f);
    }
    return b;
}

MeshBuilder fountainColumnPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    b.lathe({{0.62f, 0.40f}, {0.62f, 0.95f}, {0.56f, 1.02f}, {0.50f, 1.05f}, {0.34f, 1.10f},
             {0.28f, 1.20f}, {0.25f, 1.40f}, {0.30f, 1.65f}, {0.36f, 1.78f}, {0.30f, 1.90f},
             {0.24f, 1.96f}, {0.24f, 2.02f}, {0.45f, 2.08f}, {0.85f, 2.20f}, {1.10f, 2.36f},
             {1.18f, 2.46f}, {1.18f, 2.52f}, {1.12f, 2.54f}, {1.06f, 2.52f}, {0.96f, 2.42f},
             {0.70f, 2.34f}, {0.22f, 2.32f}},
            28);
    b.lathe({{0.22f, 2.30f},
             {0.24f, 2.36f},
             {0.19f, 2.46f},
             {0.15f, 2.60f},
             {0.14f, 3.00f},
             {0.17f, 3.10f},
             {0.24f, 3.16f},
             {0.44f, 3.26f},
             {0.52f, 3.36f},
             {0.52f, 3.40f},
             {0.47f, 3.41f},
             {0.40f, 3.34f},
             {0.10f, 3.32f}},
            24);
    b.use(Mat::bronze);
    b.lathe({{0.10f, 3.30f},
             {0.12f, 3.40f},
             {0.07f, 3.48f},
             {0.06f, 3.60f},
             {0.14f, 3.72f},
             {0.17f, 3.84f},
             {0.13f, 3.97f},
             {0.05f, 4.08f},
             {0.02f, 4.20f},
             {0, 4.22f}},
            16);
    for (int i = 0; i < 4; ++i) {  // spouts
        b.place({0, 1.72f, 0}, 0.25 * i + 0.125);
        const vec3 path[4] = {
            {0, 0, 0.30f}, {0, 0.05f, 0.46f}, {0, 0.04f, 0.58f}, {0, -0.04f, 0.66f}};
        b.tube(path, 0.035f, 8);
    }
    return b;
}

MeshBuilder waterPart(float radius, int rings) {
    MeshBuilder b;
    b.use(Mat::water);
    const int segments = 32;
    const auto height = [&](float x, float z) {
        const float u = 0.5f + x / (2.2f * radius), v = 0.5f + z / (2.2f * radius);
        return 0.030f * (fractalNoise(u, v, 9, 9, 2, 401) - 0.5f);
    };
    b.grid(segments, rings, [&](int i, int j) {
        // j runs inwards: the bitangent of an upward surface turned around y.
        const vec3 out = yawDirection(double(i) / segments);
        const float r = radius * (1 - float(j) / float(rings));
        const float x = out.x * r, z = out.z * r, e = 0.02f;
        const vec3 normal = normalize(
            vec3(height(x - e, z) - height(x + e, z), 2 * e, height(x, z - e) - height(x, z + e)));
        return Vertex{{x, height(x, z), z}, normal, {1, 0, 0}, vec2(x, z) / b.tile()};
    });
    return b;
}

}  // namespace rushlight::content
