#include "content/generator/parts/parts.h"

namespace rushlight::content {

MeshBuilder benchPart() {
    MeshBuilder b;
    b.use(Mat::iron);
    for (const float x : {-0.72f, 0.72f}) {
        for (const float z : {-0.18f, 0.20f})
            b.box({x - 0.03f, 0, z - 0.03f}, {x + 0.03f, 0.42f, z + 0.03f}, 0.006f);
        b.box({x - 0.03f, 0.38f, -0.20f}, {x + 0.03f, 0.42f, 0.22f}, 0.006f);
        b.placeRotated({x, 0.42f, -0.19f}, rotationTurns({1, 0, 0}, -0.03));
        b.box({-0.025f, -0.04f, -0.02f}, {0.025f, 0.48f, 0.02f}, 0.006f);
        b.reset();
    }
    b.use(Mat::wood).grain({1, 0, 0});
    for (int i = 0; i < 4; ++i) {
        const float z = -0.17f + 0.105f * float(i);
        b.box({-0.9f, 0.42f, z}, {0.9f, 0.46f, z + 0.09f}, 0.008f);
    }
    b.placeRotated({0, 0.42f, -0.165f}, rotationTurns({1, 0, 0}, -0.03));
    b.grain({1, 0, 0});
    for (const float y : {0.16f, 0.32f}) b.box({-0.9f, y, 0.0f}, {0.9f, y + 0.11f, 0.03f}, 0.008f);
    return b;
}

MeshBuilder barrelPart() {
    MeshBuilder b;
    b.use(Mat::wood);
    b.lathe({{0.27f, 0},
             {0.315f, 0.18f},
             {0.345f, 0.36f},
             {0.35f, 0.46f},
             {0.345f, 0.56f},
             {0.315f, 0.74f},
             {0.27f, 0.92f},
             {0.235f, 0.92f},
             {0.235f, 0.87f}},
            20);
    b.grain({1, 0, 0});
    b.lathe({{0.24f, 0.87f}, {0, 0.87f}}, 20);
    b.use(Mat::iron);
    for (const vec2& hoop :
         {vec2(0.275f, 0.04f), vec2(0.328f, 0.22f), vec2(0.328f, 0.66f), vec2(0.278f, 0.84f)}) {
        const float slope = hoop.y < 0.46f ? 0.010f : -0.010f;
        b.lathe({{hoop.x - 0.02f, hoop.y},
                 {hoop.x + 0.012f, hoop.y},
                 {hoop.x + 0.012f + slope, hoop.y + 0.05f},
                 {hoop.x - 0.02f, hoop.y + 0.05f}},
                20);
    }
    return b;
}

MeshBuilder cratePart() {
    MeshBuilder b;
    const float s = 0.36f, h = 0.62f;
    b.use(Mat::wood).grain({1, 0, 0}).box({-s + 0.02f, 0.02f, -s + 0.02f},
                                          {s - 0.02f, h - 0.02f, s - 0.02f});
    for (int side = 0; side < 4; ++side) {
        b.place(vec3(0), 0.25 * side);
        b.grain({1, 0, 0});
        for (const float y : {0.0f, h - 0.10f})
            b.box({-s, y, s - 0.03f}, {s, y + 0.10f, s + 0.01f}, 0.006f);
        b.use(Mat::wood);
        for (const float x : {-s, s - 0.10f})
            b.box({x + 0.011f, 0.10f, s - 0.03f}, {x + 0.09f, h - 0.10f, s + 0.006f});
    }
    return b;
}

MeshBuilder sackPart() {
    MeshBuilder b;
    b.use(Mat::clothBlue);
    b.lathe({{0.20f, 0},
             {0.27f, 0.04f},
             {0.31f, 0.16f},
             {0.30f, 0.34f},
             {0.24f, 0.50f},
             {0.12f, 0.58f},
             {0.07f, 0.61f},
             {0.10f, 0.66f},
             {0.14f, 0.72f},
             {0, 0.68f}},
            16, 0.85f);
    return b;
}

MeshBuilder stallFramePart() {
    MeshBuilder b;
    b.use(Mat::woodDark);
    for (const float x : {-1.35f, 1.35f}) {
        b.box({x - 0.045f, 0, -0.845f}, {x + 0.045f, 2.75f, -0.755f}, 0.008f);
        b.box({x - 0.045f, 0, 0.755f}, {x + 0.045f, 2.15f, 0.845f}, 0.008f);
    }
    b.grain({1, 0, 0});
    b.box({-1.5f, 2.66f, -0.755f}, {1.5f, 2.74f, -0.68f}, 0.008f);
    b.box({-1.5f, 2.06f, 0.68f}, {1.5f, 2.14f, 0.755f}, 0.008f);
    b.use(Mat::wood).grain({1, 0, 0});
    b.box({-1.55f, 0.86f, -0.35f}, {1.55f, 0.92f, 0.90f}, 0.01f);
    b.box({-1.45f, 0.30f, -0.30f}, {1.45f, 0.34f, 0.65f}, 0.008f);
    b.use(Mat::wood);
    b.box({-1.48f, 0.36f, 0.60f}, {1.48f, 0.85f, 0.64f}, 0.006f);
    for (const float x : {-1.42f, 1.33f})
        for (const float z : {-0.3f, 0.5f}) b.box({x, 0, z}, {x + 0.09f, 0.86f, z + 0.09f}, 0.006f);
    return b;
}

MeshBuilder awningPart() {
    // Hangs between the rails of the stall; single sheets, seen from both sides.
    MeshBuilder b;
    b.use(Mat::clothRed);
    const auto sheet = [&](float u, float v) {
        const float sag = -0.10f * 4 * v * (1 - v) - 0.02f * float(sinTurns(double(u) * 3)) * v;
        return vec3(-1.6f + 3.2f * u, 2.14f + 0.64f * (1 - v) + sag, -0.95f + 2.05f * v);
    };
    constexpr int kColumns = 20, kRows = 10;
    b.grid(kColumns, kRows, [&](int i, int j) {
        const float u = float(i) / kColumns, v = 1 - float(j) / kRows, e = 0.01f;
        const vec3 right = sheet(u + e, v) - sheet(u - e, v),
                   up = sheet(u, v - e) - sheet(u, v + e);
        return Vertex{
            sheet(u, v), normalize(cross(right, up)), normalize(right), {3.2f * u, 2.1f * v}};
    });
    // The valance, cut in scallops.
    constexpr int kScallops = 48;
    b.grid(kScallops, 1, [&](int i, int j) {
        const float u = float(i) / kScallops;
        const vec3 rail = sheet(u, 1);
        const float drop = 0.20f + 0.07f * std::fabs(float(sinTurns(double(u) * 6.4)));
        const float wave = 0.02f * float(sinTurns(double(u) * 9));
        return Vertex{rail + vec3(0, j ? 0 : -drop, j ? 0 : wave),
                      {0, 0, 1},
                      {1, 0, 0},
                      {3.2f * u, j ? 0.1f : 0.1f + drop}};
    });
    return b;
}

MeshBuilder producePart(uint32_t seed) {
    // Shallow trays of round fruit, for the counter of a stall.
    MeshBuilder b;
    Random random(seed);
    b.use(Mat::wood).grain({1, 0, 0});
    b.box({-0.42f, 0, -0.30f}, {0.42f, 0.03f, 0.30f});
    for (const float z : {-0.30f, 0.27f})
        b.box({-0.42f, 0.03f, z}, {0.42f, 0.14f, z + 0.03f}, 0.005f);
    for (const float x : {-0.42f, 0.39f})
        b.box({x, 0.03f, -0.27f}, {x + 0.03f, 0.14f, 0.27f}, 0.005f);
    b.use(Mat::terracotta);
    for (int i = 0; i < 24; ++i) {
        const float x = -0.32f + 0.128f * float(i % 6) + random.range(-0.012f, 0.012f);
        const float z = -0.19f + 0.127f * float(i / 6) + random.range(-0.012f, 0.012f);
        b.place({x, 0.05f + random.range(0, 0.03f), z});
        b.lathe({{0, 0}, {0.042f, 0.015f}, {0.060f, 0.055f}, {0.045f, 0.10f}, {0, 0.112f}}, 7);
    }
    return b;
}

MeshBuilder cartPart() {
    MeshBuilder b;
    b.use(Mat::wood).grain({0, 0, 1});
    b.box({-0.6f, 0.62f, -0.9f}, {0.6f, 0.68f, 0.9f}, 0.008f);
    for (const float x : {-0.62f, 0.57f})
        b.box({x, 0.68f, -0.9f}, {x + 0.05f, 0.98f, 0.9f}, 0.008f);
    b.use(Mat::wood).grain({1, 0, 0});
    b.box({-0.57f, 0.68f, -0.9f}, {0.57f, 0.98f, -0.85f}, 0.008f);
    b.use(Mat::woodDark).grain({0, 0, 1});
    for (const float x : {-0.42f, 0.36f}) b.box({x, 0.55f, -0.9f}, {x + 0.06f, 0.62f, 2.1f}, 0.01f);
    b.use(Mat::woodDark).box({-0.04f, 0.02f, 1.3f}, {0.04f, 0.56f, 1.38f}, 0.008f);
    const vec3 axle[2] = {{-0.78f, 0.5f, -0.1f}, {0.78f, 0.5f, -0.1f}};
    b.tube(axle, 0.035f, 8);
    for (const float x : {-0.72f, 0.72f})
        for (int i = 0; i < 10; ++i) {
            b.placeRotated({x, 0.5f, -0.1f}, rotationTurns({1, 0, 0}, i / 10.0));
            b.box({-0.02f, 0.05f, -0.018f}, {0.02f, 0.44f, 0.018f});
            // A piece of the rim, a tenth of the circle.
            const float s = float(sinTurns(0.05)), c = float(cosTurns(0.05));
            b.hexahedron({vec3(-0.035f, 0.43f * c, -0.43f * s), vec3(0.035f, 0.43f * c, -0.43f * s),
                          vec3(-0.035f, 0.5f * c, -0.5f * s), vec3(0.035f, 0.5f * c, -0.5f * s),
                          vec3(-0.035f, 0.43f * c, 0.43f * s), vec3(0.035f, 0.43f * c, 0.43f * s),
                          vec3(-0.035f, 0.5f * c, 0.5f * s), vec3(0.035f, 0.5f * c, 0.5f * s)},
                         0.004f);
        }
    return b;
}

}  // namespace rushlight::content
