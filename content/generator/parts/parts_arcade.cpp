#include "content/generator/parts/parts.h"
#include "content/generator/parts/wall_panel.h"

namespace rushlight::content {
namespace {

constexpr float kRadius = 1.2f;
constexpr float kSpring = 2.5f;
constexpr float kHalfDepth = 0.25f;
constexpr float kHalfBay = kBay / 2;

vec2 onArch(float radius, double part) {
    return {-radius * float(cosTurns(part * 0.5)), kSpring + radius * float(sinTurns(part * 0.5))};
}

/// The wall over the arch, in front and behind.
void spandrel(MeshBuilder& b) {
    constexpr int kSteps = 16;
    for (const float side : {1.0f, -1.0f}) {
        const float z = side * kHalfDepth;
        // Seen from behind, left and right change places.
        const auto face = [&](const vec2& p, const vec2& q) {
            b.quad({side * p.x, p.y, z}, {side * q.x, q.y, z}, {side * q.x, kArcadeHeight, z},
                   {side * p.x, kArcadeHeight, z});
        };
        face({-kHalfBay, kSpring}, {-kRadius, kSpring});
        for (int i = 0; i < kSteps; ++i)
            face(onArch(kRadius, double(i) / kSteps), onArch(kRadius, double(i + 1) / kSteps));
        face({kRadius, kSpring}, {kHalfBay, kSpring});
    }
    const float h = kHalfBay, d = kHalfDepth, t = kArcadeHeight;
    b.quad({-h, kSpring, -d}, {-h, kSpring, d}, {-h, t, d}, {-h, t, -d});
    b.quad({h, kSpring, d}, {h, kSpring, -d}, {h, t, -d}, {h, t, d});
    b.quad({-h, t, d}, {h, t, d}, {h, t, -d}, {-h, t, -d});
    for (const float x : {-h, kRadius})
        b.quad({x, kSpring, -d}, {x + h - kRadius, kSpring, -d}, {x + h - kRadius, kSpring, d},
               {x, kSpring, d});
}

void voussoirs(MeshBuilder& b) {
    constexpr int kStones = 11;
    for (int i = 0; i < kStones; ++i) {
        const bool key = i == kStones / 2;
        const float reach = key ? 0.07f : 0.03f;
        const float inner = kRadius - (key ? 0.06f : 0.025f),
                    outer = kRadius + (key ? 0.40f : 0.33f);
        const vec2 a = onArch(inner, double(i) / kStones), c = onArch(outer, double(i) / kStones);
        const vec2 d = onArch(inner, double(i + 1) / kStones);
        const vec2 e = onArch(outer, double(i + 1) / kStones);
        const float low = -kHalfDepth - reach, high = kHalfDepth + reach;
        // x runs along the arch, y outwards from its centre.
        b.hexahedron({vec3(a, low), vec3(d, low), vec3(c, low), vec3(e, low), vec3(a, high),
                      vec3(d, high), vec3(c, high), vec3(e, high)},
                     0.012f);
    }
}

void ceiling(MeshBuilder& b) {
    b.use(Mat::woodDark).grain({1, 0, 0});
    b.box({-kHalfBay, 3.98f, -kArcadeDepth}, {kHalfBay, 4.08f, -kHalfDepth});
    b.grain({0, 0, 1});
    for (const float x : {-0.8f, 0.8f})
        b.box({x - 0.11f, 3.74f, -kArcadeDepth}, {x + 0.11f, 3.98f, -kHalfDepth}, 0.02f);
}

}  // namespace

/// The arch, and the ceiling behind it.
MeshBuilder archPart() {
    MeshBuilder b;
    b.use(Mat::ashlar);
    spandrel(b);
    b.use(Mat::stone);
    voussoirs(b);
    ceiling(b);
    return b;
}

MeshBuilder columnPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    b.box({-0.33f, 0, -0.33f}, {0.33f, 0.16f, 0.33f}, 0.015f);
    b.lathe({{0.31f, 0.16f},   {0.33f, 0.19f},   {0.33f, 0.22f},   {0.31f, 0.25f},  {0.27f, 0.265f},
             {0.255f, 0.29f},  {0.27f, 0.315f},  {0.285f, 0.33f},  {0.28f, 0.36f},  {0.25f, 0.375f},
             {0.235f, 0.40f},  {0.232f, 0.9f},   {0.222f, 1.4f},   {0.207f, 1.8f},  {0.195f, 2.02f},
             {0.215f, 2.035f}, {0.225f, 2.055f}, {0.215f, 2.075f}, {0.195f, 2.09f}, {0.20f, 2.14f},
             {0.235f, 2.21f},  {0.29f, 2.29f},   {0.335f, 2.34f},  {0.34f, 2.36f}},
            16);
    b.box({-0.37f, 2.36f, -0.37f}, {0.37f, 2.5f, 0.37f}, 0.018f);
    return b;
}

MeshBuilder pierPart() {
    MeshBuilder b;
    b.use(Mat::stone).box({-0.46f, 0, -0.46f}, {0.46f, 0.35f, 0.46f}, 0.025f);
    b.use(Mat::ashlar).box({-0.40f, 0.35f, -0.40f}, {0.40f, 2.34f, 0.40f}, 0.02f);
    b.use(Mat::stone).box({-0.45f, 2.34f, -0.45f}, {0.45f, 2.5f, 0.45f}, 0.02f);
    b.use(Mat::ashlar).box({-0.40f, 2.5f, -0.40f}, {0.40f, kArcadeHeight, 0.40f}, 0.02f);
    return b;
}

MeshBuilder arcadeFloorPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    for (int i = 0; i < 3; ++i) {  // kerb stones before the columns, flags behind them
        const float x = -kHalfBay + kBay * float(i) / 3;
        b.box({x, -0.1f, 0.45f}, {x + kBay / 3, kArcadeFloor, 0.75f}, 0.015f);
    }
    b.use(Mat::stoneDark);
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 3; ++i) {
            const float x = -kHalfBay + kBay * float(i) / 3, depth = (kArcadeDepth + 0.45f) / 4;
            const float z = 0.45f - depth * float(row + 1);
            const float lift = 0.006f * unit(uint32_t(i), uint32_t(row), 301);
            b.box({x, -0.1f, z}, {x + kBay / 3, kArcadeFloor - lift, z + depth}, 0.010f);
        }
    return b;
}

MeshBuilder arcadeBackPart(bool door) {
    MeshBuilder b;
    b.use(Mat::plasterInside);
    const WallPanel wall{-kHalfBay, kHalfBay, 0, kArcadeHeight, -kArcadeDepth};
    if (door)
        wallPanel(b, wall, {{-0.5f, 0.5f, 0, 2.2f}}, 0.22f);
    else
        wallPanel(b, wall, {{-0.5f, 0.5f, 1.0f, 2.5f}}, 0.22f);
    b.use(Mat::stoneDark);
    const auto plinth = [&](float x0, float x1) {
        b.box({x0, 0, -kArcadeDepth - 0.05f}, {x1, 0.5f, -kArcadeDepth + 0.06f}, 0.015f);
    };
    plinth(-kHalfBay, door ? -0.66f : 0.0f);
    plinth(door ? 0.66f : 0.0f, kHalfBay);
    return b;
}

}  // namespace rushlight::content
