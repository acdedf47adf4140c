#include "content/generator/parts/parts.h"

// Every random number is drawn into a variable of its own: the order in which a compiler evaluates
// the arguments of a call is free, and the files must not depend on it.

namespace rushlight::content {
namespace {

/// A leaf card around a point: `facing` is its normal, turned by `roll` turns in its plane. The
/// shading normal leans to `shade`, so that a crown of cards is lit like a round thing.
void leafCard(MeshBuilder& b, const vec3& center, const vec3& facing, double roll, float size,
              const vec3& shade) {
    const vec3 side = normalize(
        cross(std::fabs(facing.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0), facing));
    const vec3 over = cross(facing, side);
    const float c = float(cosTurns(roll)), s = float(sinTurns(roll)), h = size / 2;
    const vec3 right = side * c + over * s, up = over * c - side * s;
    const vec3 normal = normalize(shade + 0.35f * facing);
    b.grid(1, 1, [&](int i, int j) {
        const vec3 p = center + right * (i ? h : -h) + up * (j ? h : -h);
        return Vertex{p, normal, right, {float(i), float(1 - j)}};
    });
}

vec3 randomDirection(Random& random) {
    const float y = random.range(-1, 1);
    const vec3 around = yawDirection(double(random.next()));
    const float r = std::sqrt(1 - y * y);
    return {around.x * r, y, around.z * r};
}

void crown(MeshBuilder& b, Random& random, const vec3& center, const vec3& radii, int cards,
           float size) {
    for (int i = 0; i < cards; ++i) {
        const vec3 out = randomDirection(random);
        const float reach = random.range(0.62f, 1.0f);
        const vec3 facing = normalize(out + 0.6f * randomDirection(random));
        const float roll = random.next();
        const float cardSize = size * random.range(0.8f, 1.2f);
        leafCard(b, center + out * radii * reach, facing, double(roll), cardSize,
                 normalize(out + vec3(0, 0.25f, 0)));
    }
}

}  // namespace

MeshBuilder potPart() {
    MeshBuilder b;
    b.use(Mat::terracotta);
    b.lathe({{0.24f, 0},
             {0.26f, 0.02f},
             {0.30f, 0.22f},
             {0.345f, 0.44f},
             {0.38f, 0.46f},
             {0.39f, 0.50f},
             {0.38f, 0.55f},
             {0.34f, 0.56f},
             {0.32f, 0.54f},
             {0.31f, 0.46f}},
            20);
    b.use(Mat::soil);
    b.lathe({{0.33f, 0.48f}, {0.15f, 0.50f}, {0, 0.51f}}, 20);
    return b;
}

MeshBuilder bushPart(uint32_t seed) {
    MeshBuilder b;
    Random random(seed);
    b.use(Mat::leaf);
    crown(b, random, {0, 0.42f, 0}, {0.42f, 0.42f, 0.42f}, 34, 0.55f);
    crown(b, random, {0, 0.36f, 0}, {0.22f, 0.25f, 0.22f}, 8, 0.5f);
    return b;
}

MeshBuilder treeTrunkPart() {
    MeshBuilder b;
    b.use(Mat::woodDark);
    b.lathe({{0.17f, -0.1f},
             {0.13f, 0.15f},
             {0.105f, 0.6f},
             {0.095f, 1.3f},
             {0.085f, 1.9f},
             {0.05f, 2.4f},
             {0, 2.9f}},
            10);
    for (int i = 0; i < 6; ++i) {
        const vec3 out = yawDirection(i / 6.0 + 0.05 * unit(uint32_t(i), 501));
        const float y = 1.55f + 0.14f * float(i);
        const vec3 path[3] = {vec3(0, y, 0), vec3(0, y + 0.28f, 0) + 0.35f * out,
                              vec3(0, y + 0.75f, 0) + 0.72f * out};
        b.tube(path, 0.032f, 6);
    }
    return b;
}

MeshBuilder treeCrownPart(uint32_t seed) {
    MeshBuilder b;
    Random random(seed);
    b.use(Mat::leaf);
    crown(b, random, {0, 2.85f, 0}, {1.15f, 0.95f, 1.15f}, 95, 0.85f);
    crown(b, random, {0.1f, 2.75f, 0}, {0.6f, 0.6f, 0.6f}, 26, 0.8f);
    return b;
}

MeshBuilder ivyPart(float width, float height, uint32_t seed) {
    // Climbs a wall at z = 0: dense below, thinning to ragged tips.
    MeshBuilder b;
    Random random(seed);
    b.use(Mat::ivy);
    const int cards = int(width * height * 7);
    for (int i = 0; i < cards; ++i) {
        const float far = random.next();
        const float t = far * random.next();
        const float reach = width / 2 * (1 - 0.65f * t) *
                            (0.75f + 0.25f * float(sinTurns(double(t) * 3 + 0.1)));
        const float across = random.range(-reach, reach);
        const float off = random.range(0.05f, 0.16f);
        const vec3 center(across + 0.15f * float(sinTurns(double(t) * 1.3)), 0.15f + height * t,
                          off);
        const float turn = random.range(-0.4f, 0.4f);
        const float tilt = random.range(-0.1f, 0.5f);
        const vec3 facing = normalize(vec3(turn, tilt, 1));
        const float roll = random.next();
        const float cardSize = random.range(0.35f, 0.55f);
        leafCard(b, center, facing, double(roll), cardSize,
                 normalize(vec3(0.5f * facing.x, 0.2f, 1)));
    }
    return b;
}

}  // namespace rushlight::content
