#include "content/generator/parts/parts.h"

namespace rushlight::content {

MeshBuilder windowPart() {
    MeshBuilder b;
    const float w = kWindowWidth / 2, h = kWindowHeight;
    b.use(Mat::stone);
    b.box({-w - 0.15f, -0.10f, -0.05f}, {w + 0.15f, 0.008f, 0.13f}, 0.012f);  // sill
    b.box({-w - 0.13f, 0.0f, -0.04f}, {-w + 0.008f, h, 0.045f}, 0.010f);
    b.box({w - 0.008f, 0.0f, -0.04f}, {w + 0.13f, h, 0.045f}, 0.010f);
    b.box({-w - 0.16f, h - 0.008f, -0.04f}, {w + 0.16f, h + 0.18f, 0.06f}, 0.012f);  // lintel
    b.box({-w - 0.20f, h + 0.18f, -0.04f}, {w + 0.20f, h + 0.24f, 0.11f}, 0.012f);
    b.use(Mat::woodDark);
    for (const float x : {-w, w - 0.06f}) b.box({x, 0, -0.20f}, {x + 0.06f, h, -0.13f});
    b.box({-0.035f, 0.06f, -0.195f}, {0.035f, h - 0.06f, -0.14f});
    b.grain({1, 0, 0});
    for (const float y : {0.0f, h - 0.06f})
        b.box({-w + 0.06f, y, -0.20f}, {w - 0.06f, y + 0.06f, -0.13f});
    for (const float y : {0.50f, 0.98f})
        for (const float x : {-w + 0.06f, 0.035f})
            b.box({x, y, -0.185f}, {x + w - 0.095f, y + 0.03f, -0.15f});
    b.use(Mat::windowLit);
    b.card({-w, 0, -0.175f}, {w, 0, -0.175f}, {w, h, -0.175f}, {-w, h, -0.175f});
    return b;
}

MeshBuilder shutterPart() {
    // Hinged at x = 0, closed over 0 .. 0.52.
    MeshBuilder b;
    b.use(Mat::paintGreen);
    const float w = 0.52f, h = kWindowHeight + 0.02f;
    b.box({0, 0, 0}, {0.06f, h, 0.04f}, 0.005f);
    b.box({w - 0.06f, 0, 0}, {w, h, 0.04f}, 0.005f);
    b.grain({1, 0, 0});
    for (const float y : {0.0f, 0.72f, h - 0.08f})
        b.box({0.06f, y, 0}, {w - 0.06f, y + 0.08f, 0.035f});
    for (int i = 0; i < 12; ++i) {  // slats
        const float y = (i < 6 ? 0.10f : 0.82f) + 0.100f * float(i % 6);
        b.hexahedron({vec3(0.06f, y, 0.008f), vec3(w - 0.06f, y, 0.008f),
                      vec3(0.06f, y + 0.08f, 0.002f), vec3(w - 0.06f, y + 0.08f, 0.002f),
                      vec3(0.06f, y, 0.036f), vec3(w - 0.06f, y, 0.036f),
                      vec3(0.06f, y + 0.012f, 0.036f), vec3(w - 0.06f, y + 0.012f, 0.036f)});
    }
    return b;
}

MeshBuilder doorPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    b.box({-0.66f, 0, -0.05f}, {-0.492f, 2.2f, 0.06f}, 0.012f);
    b.box({0.492f, 0, -0.05f}, {0.66f, 2.2f, 0.06f}, 0.012f);
    b.box({-0.72f, 2.192f, -0.05f}, {0.72f, 2.42f, 0.09f}, 0.015f);
    b.box({-0.78f, 2.42f, -0.05f}, {0.78f, 2.50f, 0.18f}, 0.015f);
    b.use(Mat::paintGreen);
    b.box({-0.5f, 0, -0.20f}, {0.5f, 2.2f, -0.15f});
    for (const float x : {-0.5f, -0.05f, 0.40f})
        b.box({x, 0, -0.155f}, {x + 0.10f, 2.2f, -0.11f}, 0.008f);
    b.grain({1, 0, 0});
    for (const float y : {0.0f, 0.95f, 2.08f})
        for (const float x : {-0.40f, 0.05f})
            b.box({x, y, -0.155f}, {x + 0.35f, y + 0.12f, -0.115f}, 0.008f);
    b.use(Mat::bronze);
    b.placeRotated({-0.32f, 1.04f, -0.115f}, rotationTurns({1, 0, 0}, 0.25));
    b.lathe({{0.035f, 0},
             {0.035f, 0.012f},
             {0.014f, 0.02f},
             {0.014f, 0.035f},
             {0.030f, 0.045f},
             {0.030f, 0.062f},
             {0.018f, 0.07f},
             {0, 0.072f}},
            10);
    return b;
}

MeshBuilder doorStepPart() {
    MeshBuilder b;
    b.use(Mat::stone);
    b.box({-0.85f, -0.05f, -0.21f}, {0.85f, 0.30f, 0.38f}, 0.02f);
    b.box({-1.05f, -0.05f, 0.38f}, {1.05f, 0.15f, 0.72f}, 0.02f);
    return b;
}

}  // namespace rushlight::content
