#include "content/generator/parts/parts.h"

namespace rushlight::content {
namespace {

constexpr float kTop = -0.14f, kBottom = -0.52f;  // of the glass
constexpr float kWide = 0.135f, kNarrow = 0.095f;

vec3 cageCorner(int corner, bool top, float grow = 0) {
    const float r = (top ? kWide : kNarrow) + grow;
    return {corner == 0 || corner == 3 ? -r : r, top ? kTop : kBottom, corner < 2 ? r : -r};
}

}  // namespace

MeshBuilder lanternPart() {
    MeshBuilder b;
    b.use(Mat::iron);
    b.lathe({{0.012f, -0.03f}, {0.030f, -0.02f}, {0.030f, 0.0f}, {0.012f, 0.01f}}, 8);
    b.lathe({{0.19f, -0.14f},
             {0.20f, -0.125f},
             {0.13f, -0.09f},
             {0.075f, -0.07f},
             {0.07f, -0.05f},
             {0.03f, -0.03f},
             {0, -0.028f}},
            12);
    b.lathe({{0, -0.135f}, {0.19f, -0.14f}}, 12);
    for (int i = 0; i < 4; ++i) {
        const vec3 bar[2] = {cageCorner(i, false), cageCorner(i, true)};
        b.tube(bar, 0.009f, 4);
        const vec3 rim[2] = {cageCorner(i, false), cageCorner((i + 1) % 4, false)};
        b.tube(rim, 0.010f, 4);
    }
    b.use(Mat::glass);
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        const vec3 out = 0.002f * yawDirection(0.25 * i);
        b.quad(cageCorner(i, false) + out, cageCorner(j, false) + out, cageCorner(j, true) + out,
               cageCorner(i, true) + out);
    }
    return b;
}

MeshBuilder bulbPart() {
    MeshBuilder b;
    b.use(Mat::bulbWarm);
    b.lathe({{0, -0.36f},
             {0.030f, -0.35f},
             {0.050f, -0.325f},
             {0.055f, -0.29f},
             {0.045f, -0.25f},
             {0.026f, -0.21f},
             {0.022f, -0.14f}},
            12);
    return b;
}

MeshBuilder lampPostPart() {
    // Two arms along x; lanterns hang at (+-0.62, 3.50).
    MeshBuilder b;
    b.use(Mat::stone).box({-0.28f, -0.05f, -0.28f}, {0.28f, 0.22f, 0.28f}, 0.025f);
    b.use(Mat::iron);
    b.lathe({{0.20f, 0.22f},
             {0.21f, 0.27f},
             {0.16f, 0.34f},
             {0.13f, 0.50f},
             {0.12f, 0.80f},
             {0.14f, 0.86f},
             {0.10f, 0.93f},
             {0.075f, 1.05f},
             {0.060f, 2.4f},
             {0.085f, 2.46f},
             {0.085f, 2.52f},
             {0.055f, 2.58f},
             {0.045f, 3.55f},
             {0.075f, 3.60f},
             {0.075f, 3.66f},
             {0.04f, 3.72f},
             {0.055f, 3.84f},
             {0.035f, 3.95f},
             {0, 4.02f}},
            14);
    for (const double yaw : {0.0, 0.5}) {
        b.place(vec3(0), yaw);
        std::vector<vec3> arm, scroll;
        for (int i = 0; i <= 10; ++i) {
            const double t = 0.5 * i / 10;
            arm.push_back(
                {0.335f - 0.285f * float(cosTurns(t)), 3.56f + 0.20f * float(sinTurns(t)), 0});
        }
        arm.push_back({0.62f, 3.50f, 0});
        b.tube(arm, 0.020f, 8);
        for (int i = 0; i <= 12; ++i) {
            const double t = 0.9 * i / 12;
            const float r = 0.13f - 0.007f * float(i);
            scroll.push_back({0.19f - r * float(cosTurns(t)), 3.36f + r * float(sinTurns(t)), 0});
        }
        b.tube(scroll, 0.011f, 6);
    }
    return b;
}

MeshBuilder wallBracketPart() {
    // From the wall at z = 0; the lantern hangs at (0, 0, 0.5).
    MeshBuilder b;
    b.use(Mat::iron);
    b.box({-0.05f, -0.42f, -0.03f}, {0.05f, 0.12f, 0.018f}, 0.008f);
    const vec3 bar[2] = {{0, 0.03f, 0}, {0, 0.03f, 0.56f}};
    b.tube(bar, 0.016f, 8);
    const vec3 hook[2] = {{0, 0.03f, 0.5f}, {0, -0.01f, 0.5f}};
    b.tube(hook, 0.010f, 6);
    std::vector<vec3> brace;
    for (int i = 0; i <= 8; ++i) {
        const double t = 0.25 * i / 8;
        brace.push_back(
            {0, -0.36f + 0.37f * float(sinTurns(t)), 0.42f - 0.42f * float(cosTurns(t))});
    }
    b.tube(brace, 0.012f, 6);
    return b;
}

MeshBuilder chainPart(float length) {
    MeshBuilder b;  // hangs from its origin
    b.use(Mat::iron);
    const int links = int(length / 0.085f);
    for (int i = 0; i < links; ++i) {
        b.place({0, -length * (float(i) + 0.5f) / float(links), 0}, i % 2 ? 0.25 : 0.0);
        const float r = 0.55f * length / float(links);
        std::vector<vec3> ring;
        for (int k = 0; k <= 6; ++k)
            ring.push_back({0.5f * r * float(sinTurns(k / 6.0)), r * float(cosTurns(k / 6.0)), 0});
        b.tube(ring, 0.006f, 3);
    }
    b.place(vec3(0)).lathe({{0.035f, -0.03f}, {0.035f, 0.0f}}, 8);
    return b;
}

}  // namespace rushlight::content
