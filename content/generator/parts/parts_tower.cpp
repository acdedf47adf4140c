// The bell tower, and the town wall with its gate.

#include "content/generator/parts/parts.h"
#include "content/generator/parts/wall_panel.h"

namespace rushlight::content {
namespace {

constexpr float kTowerHalf = 2.75f;
constexpr float kBelfryHeight = 5.0f;

/// A wall facing +z with an arched hole: `half` wide on both sides, the hole `radius` wide, its arc
/// at `spring`.
void archedPanel(MeshBuilder& b, float half, float top, float radius, float bottom, float spring,
                 float z, float depth) {
    constexpr int kSteps = 14;
    const auto arc = [&](int i) {
        const double t = 0.5 * double(i) / kSteps;
        return vec2(-radius * float(cosTurns(t)), spring + radius * float(sinTurns(t)));
    };
    b.quad({-half, 0, z}, {-radius, 0, z}, {-radius, top, z}, {-half, top, z});
    b.quad({radius, 0, z}, {half, 0, z}, {half, top, z}, {radius, top, z});
    if (bottom > 0)
        b.quad({-radius, 0, z}, {radius, 0, z}, {radius, bottom, z}, {-radius, bottom, z});
    for (int i = 0; i < kSteps; ++i) {
        const vec2 p = arc(i), q = arc(i + 1);
        b.quad(vec3(p, z), vec3(q, z), {q.x, top, z}, {p.x, top, z});
    }
    if (depth <= 0) return;
    const float back = z - depth;
    b.quad({-radius, bottom, z}, {-radius, bottom, back}, {-radius, spring, back},
           {-radius, spring, z});
    b.quad({radius, bottom, back}, {radius, bottom, z}, {radius, spring, z},
           {radius, spring, back});
    if (bottom > 0)
        b.quad({-radius, bottom, z}, {radius, bottom, z}, {radius, bottom, back},
               {-radius, bottom, back});
    const float tile = b.tile();
    b.grid(1, kSteps, [&](int i, int j) {
        const vec2 p = arc(j);
        const vec3 inward(-p.x / radius, (spring - p.y) / radius, 0);
        return Vertex{{p.x, p.y, i ? back : z},
                      inward,
                      {0, 0, -1},
                      vec2(i ? depth : 0, -radius * kPi * float(j) / kSteps) / tile};
    });
}

void merlons(MeshBuilder& b, float x0, float x1, float y, float z0, float z1) {
    const int count = int((x1 - x0) / 1.3f + 0.5f);
    const float pitch = (x1 - x0) / float(count);
    for (int i = 0; i < count; ++i) {
        const float x = x0 + pitch * float(i) + 0.25f * pitch;
        b.use(Mat::ashlarDark).box({x, y - 0.05f, z0}, {x + 0.55f * pitch, y + 0.85f, z1}, 0.015f);
        b.use(Mat::stoneDark);
        const float l = x - 0.04f, r = x + 0.55f * pitch + 0.04f, m = 0.5f * (z0 + z1);
        b.hexahedron({vec3(l, y + 0.85f, z0 - 0.04f), vec3(r, y + 0.85f, z0 - 0.04f),
                      vec3(l, y + 1.0f, m - 0.08f), vec3(r, y + 1.0f, m - 0.08f),
                      vec3(l, y + 0.85f, z1 + 0.04f), vec3(r, y + 0.85f, z1 + 0.04f),
                      vec3(l, y + 1.0f, m + 0.08f), vec3(r, y + 1.0f, m + 0.08f)},
                     0.012f);
    }
}

void ringCourse(MeshBuilder& b, float half, float y, float reach) {
    b.box({-half - reach, y, -half - reach}, {half + reach, y + 0.22f, half + reach}, 0.03f);
    b.box({-half - reach * 0.5f, y - 0.14f, -half - reach * 0.5f},
          {half + reach * 0.5f, y, half + reach * 0.5f}, 0.02f);
}

}  // namespace

MeshBuilder towerShaftPart() {
    MeshBuilder b;
    const float h = kTowerHalf;
    b.use(Mat::stone).box({-h - 0.15f, -0.1f, -h - 0.15f}, {h + 0.15f, 0.9f, h + 0.15f}, 0.04f);
    b.use(Mat::ashlar);
    for (int side = 0; side < 4; ++side) {
        b.place({0, 0, 0}, 0.25 * side);
        wallPanel(b, {-h, h, 0.9f, kTowerShaft, h},
                  {{-0.3f, 0.3f, 7.0f, 8.6f}, {-0.3f, 0.3f, 11.0f, 12.6f}}, 0.5f);
        b.use(Mat::windowDark);
        for (const float y : {7.0f, 11.0f})
            b.card({-0.3f, y, h - 0.48f}, {0.3f, y, h - 0.48f}, {0.3f, y + 1.6f, h - 0.48f},
                   {-0.3f, y + 1.6f, h - 0.48f});
        b.use(Mat::ashlar);
    }
    b.reset();
    b.use(Mat::stone);
    for (int i = 0; i < 33; ++i)  // quoins
        for (int corner = 0; corner < 4; ++corner) {
            const bool along = (i + corner) % 2 == 0;
            const float sx = corner & 1 ? 1.0f : -1.0f, sz = corner & 2 ? 1.0f : -1.0f;
            const float lx = along ? 0.62f : 0.38f, lz = along ? 0.38f : 0.62f;
            const float y = 0.9f + 0.426f * float(i), out = h + 0.04f;
            b.box({sx > 0 ? out - lx : -out, y + 0.006f, sz > 0 ? out - lz : -out},
                  {sx > 0 ? out : -out + lx, y + 0.42f, sz > 0 ? out : -out + lz}, 0.012f);
        }
    ringCourse(b, h, 5.6f, 0.14f);
    ringCourse(b, h, kTowerShaft - 0.2f, 0.30f);
    return b;
}

MeshBuilder belfryPart() {
    MeshBuilder b;
    const float h = kTowerHalf - 0.12f, top = kBelfryHeight;
    for (int side = 0; side < 4; ++side) {
        b.place({0, 0, 0}, 0.25 * side);
        b.use(Mat::ashlar);
        archedPanel(b, h, top, 1.15f, 0.9f, 2.7f, h, 0.55f);
        // The inner face of the wall, seen through the opposite arch.
        b.place({0, 0, 0}, 0.25 * side + 0.5);
        archedPanel(b, h - 0.55f, top, 1.15f, 0.9f, 2.7f, -h + 0.55f, 0);
        b.place({0, 0, 0}, 0.25 * side);
        b.use(Mat::stone);
        b.box({-1.35f, 0.78f, h - 0.1f}, {1.35f, 0.92f, h + 0.12f}, 0.02f);
        for (const float x : {-h, h - 0.45f})
            b.box({x, 0.02f, h - 0.1f}, {x + 0.45f, top - 0.25f, h + 0.06f}, 0.02f);
    }
    b.reset();
    b.use(Mat::wood).grain({1, 0, 0}).box({-h + 0.1f, -0.05f, -h + 0.1f},
                                          {h - 0.1f, 0.05f, h - 0.1f});
    b.use(Mat::woodDark)
        .grain({1, 0, 0})
        .box({-h + 0.3f, 4.0f, -0.14f}, {h - 0.3f, 4.28f, 0.14f}, 0.02f);
    b.use(Mat::stone);
    ringCourse(b, h, top, 0.34f);
    return b;
}

MeshBuilder towerRoofPart() {
    MeshBuilder b;
    b.use(Mat::roof);
    const float e = kTowerHalf + 0.45f, low = 0.9f, mid = kTowerHalf - 0.5f, top = 5.6f;
    for (int side = 0; side < 4; ++side) {  // a broken pyramid
        b.place({0, 0, 0}, 0.25 * side);
        b.quad({-e, 0, e}, {e, 0, e}, {mid, low, mid}, {-mid, low, mid});
        b.triangle({-mid, low, mid}, {mid, low, mid}, {0, top, 0});
        const vec3 hip[3] = {{e, 0.02f, e}, {mid, low + 0.03f, mid}, {0, top + 0.02f, 0}};
        b.tube(hip, 0.10f, 8);
    }
    b.reset();
    b.quad({-e, 0, -e}, {e, 0, -e}, {e, 0, e}, {-e, 0, e});
    b.use(Mat::bronze).place({0, top - 0.1f, 0});
    b.lathe({{0.16f, 0},
             {0.10f, 0.25f},
             {0.05f, 0.40f},
             {0.05f, 0.55f},
             {0.17f, 0.66f},
             {0.21f, 0.80f},
             {0.17f, 0.94f},
             {0.05f, 1.05f},
             {0.03f, 1.2f},
             {0.02f, 2.0f},
             {0, 2.02f}},
            16);
    return b;
}

MeshBuilder bellPart() {
    MeshBuilder b;  // hangs from its origin
    b.use(Mat::bronze);
    b.lathe({{0.62f, -1.25f},
             {0.66f, -1.20f},
             {0.60f, -1.08f},
             {0.50f, -0.85f},
             {0.44f, -0.60f},
             {0.41f, -0.40f},
             {0.35f, -0.24f},
             {0.20f, -0.16f},
             {0.07f, -0.14f},
             {0.07f, 0.0f},
             {0, 0}},
            28);
    b.lathe({{0, -0.24f},
             {0.30f, -0.30f},
             {0.37f, -0.42f},
             {0.40f, -0.62f},
             {0.46f, -0.86f},
             {0.56f, -1.10f},
             {0.62f, -1.25f}},
            28);
    return b;
}

MeshBuilder townWallPart() {
    MeshBuilder b;
    const float h = kWallSegment / 2;
    b.use(Mat::ashlarDark);
    b.quad({-h, 0, 0}, {h, 0, 0}, {h, kWallHeight, 0}, {-h, kWallHeight, 0});
    b.quad({h, 0, -1.2f}, {-h, 0, -1.2f}, {-h, kWallHeight, -1.2f}, {h, kWallHeight, -1.2f});
    b.quad({-h, 0, -1.2f}, {-h, 0, 0}, {-h, kWallHeight, 0}, {-h, kWallHeight, -1.2f});
    b.quad({h, 0, 0}, {h, 0, -1.2f}, {h, kWallHeight, -1.2f}, {h, kWallHeight, 0});
    b.quad({-h, kWallHeight, 0}, {h, kWallHeight, 0}, {h, kWallHeight, -1.2f},
           {-h, kWallHeight, -1.2f});
    b.use(Mat::stoneDark);
    b.moulding({{0, 0}, {0.22f, 0}, {0.22f, 0.45f}, {0.06f, 0.62f}, {0, 0.62f}}, -h, h);
    b.moulding({{0, kWallHeight - 0.5f},
                {0.16f, kWallHeight - 0.28f},
                {0.20f, kWallHeight - 0.24f},
                {0.20f, kWallHeight - 0.08f},
                {0, kWallHeight - 0.02f}},
               -h, h);
    merlons(b, -h, h, kWallHeight, -1.15f, -0.72f);
    for (int i = 0; i < 4; ++i) {  // corbels under the walk
        const float x = -h + 0.5f + float(i);
        b.use(Mat::stoneDark)
            .box({x - 0.12f, kWallHeight - 0.72f, -0.05f}, {x + 0.12f, kWallHeight - 0.40f, 0.13f},
                 0.015f);
    }
    return b;
}

MeshBuilder gateTowerPart() {
    MeshBuilder b;
    const float half = 3.6f, top = 8.0f, depth = 3.2f, radius = 1.7f, spring = 2.6f;
    b.use(Mat::ashlarDark);
    archedPanel(b, half, top, radius, 0, spring, 0, depth);
    b.place({0, 0, -depth}, 0.5);
    archedPanel(b, half, top, radius, 0, spring, 0, 0);
    b.reset();
    b.quad({-half, 0, -depth}, {-half, 0, 0}, {-half, top, 0}, {-half, top, -depth});
    b.quad({half, 0, 0}, {half, 0, -depth}, {half, top, -depth}, {half, top, 0});
    b.quad({-half, top, 0}, {half, top, 0}, {half, top, -depth}, {-half, top, -depth});
    b.use(Mat::stone);
    constexpr int kStones = 13;
    for (int i = 0; i < kStones; ++i) {
        const auto arc = [&](float r, int k) {
            const double t = 0.5 * double(k) / kStones;
            return vec2(-r * float(cosTurns(t)), spring + r * float(sinTurns(t)));
        };
        const float out = radius + (i % 2 ? 0.42f : 0.52f), in = radius - 0.04f;
        const vec2 p = arc(in, i), q = arc(in, i + 1), r = arc(out, i), s = arc(out, i + 1);
        b.hexahedron({vec3(p, -0.45f), vec3(q, -0.45f), vec3(r, -0.45f), vec3(s, -0.45f),
                      vec3(p, 0.08f), vec3(q, 0.08f), vec3(r, 0.08f), vec3(s, 0.08f)},
                     0.018f);
    }
    for (int i = 0; i < 6; ++i)
        for (const float side : {-1.0f, 1.0f}) {
            const float wide = i % 2 ? 0.40f : 0.56f, y = 0.433f * float(i);
            const float x0 = side > 0 ? radius - 0.04f : -radius - wide,
                        x1 = side > 0 ? radius + wide : -radius + 0.04f;
            b.box({x0, y, -0.45f}, {x1, y + 0.428f, 0.08f}, 0.018f);
        }
    b.use(Mat::stoneDark);
    b.moulding({{0, top - 0.5f},
                {0.22f, top - 0.25f},
                {0.26f, top - 0.2f},
                {0.26f, top},
                {0, top + 0.04f}},
               -half, half);
    for (int i = 0; i < 7; ++i)
        b.box({-3.1f + float(i) * 1.03f - 0.14f, top - 0.85f, -0.05f},
              {-3.1f + float(i) * 1.03f + 0.14f, top - 0.42f, 0.16f}, 0.02f);
    merlons(b, -half, half, top, -0.45f, 0.0f);
    merlons(b, -half, half, top, -depth, -depth + 0.45f);
    // A carved shield over the arch.
    b.use(Mat::stone).box({-0.5f, 5.0f, -0.03f}, {0.5f, 6.3f, 0.07f}, 0.03f);
    b.use(Mat::bronze).placeRotated({0, 5.68f, 0.06f}, rotationTurns({1, 0, 0}, 0.25));
    b.lathe(
        {{0.36f, 0}, {0.36f, 0.03f}, {0.30f, 0.05f}, {0.14f, 0.06f}, {0.11f, 0.11f}, {0, 0.13f}},
        20);
    return b;
}

MeshBuilder gateLeafPart() {
    // Hinged at x = 0; the arc's half is cut straight to the springing.
    MeshBuilder b;
    b.use(Mat::wood).box({0, 0.03f, -0.05f}, {1.62f, 2.9f, 0.05f}, 0.01f);
    b.use(Mat::woodDark).grain({1, 0, 0});
    for (const float y : {0.3f, 1.4f, 2.5f})
        b.box({0.02f, y, 0.04f}, {1.60f, y + 0.18f, 0.10f}, 0.01f);
    b.use(Mat::iron);
    for (const float y : {0.36f, 1.46f, 2.56f}) {
        b.box({0, y, 0.10f}, {1.35f, y + 0.06f, 0.112f}, 0.004f);
        for (int i = 0; i < 6; ++i) {
            b.placeRotated({0.12f + 0.22f * float(i), y + 0.03f, 0.11f},
                           rotationTurns({1, 0, 0}, 0.25));
            b.lathe({{0.03f, 0}, {0.022f, 0.018f}, {0, 0.026f}}, 8);
            b.reset();
        }
    }
    return b;
}

}  // namespace rushlight::content
