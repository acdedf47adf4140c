#include "content/generator/parts/parts.h"
#include "content/generator/parts/wall_panel.h"

namespace rushlight::content {
namespace {

constexpr float kRise = 0.62f;  // of the roof: height over reach
constexpr float kEaves = 0.55f;
constexpr float kPlinth = 0.6f;

float windowCenter(int bays, int i) { return kBay * (float(i) - 0.5f * float(bays - 1)); }

Opening windowHole(int bays, int i, float floorHeight) {
    const float x = windowCenter(bays, i), y = floorHeight + kWindowSill;
    return {x - kWindowWidth / 2, x + kWindowWidth / 2, y, y + kWindowHeight};
}

/// Sides and back of a house's shell.
void shell(MeshBuilder& b, float half, float y0, float y1) {
    b.quad({-half, y0, -kHouseDepth}, {-half, y0, 0}, {-half, y1, 0}, {-half, y1, -kHouseDepth});
    b.quad({half, y0, 0}, {half, y0, -kHouseDepth}, {half, y1, -kHouseDepth}, {half, y1, 0});
    b.quad({half, y0, -kHouseDepth}, {-half, y0, -kHouseDepth}, {-half, y1, -kHouseDepth},
           {half, y1, -kHouseDepth});
}

}  // namespace

MeshBuilder upperWallPart(int bays, int storeys) {
    MeshBuilder b;
    b.use(Mat::plasterCream);
    const float half = kBay * float(bays) / 2, top = kStorey * float(storeys);
    std::vector<Opening> holes;
    for (int s = 0; s < storeys; ++s)
        for (int i = 0; i < bays; ++i) holes.push_back(windowHole(bays, i, kStorey * float(s)));
    wallPanel(b, {-half, half, 0, top, 0}, holes, 0.22f);
    shell(b, half, 0, top);
    const float ridge = top + kRise * kHouseDepth / 2, middle = -kHouseDepth / 2;
    b.triangle({-half, top, -kHouseDepth}, {-half, top, 0}, {-half, ridge, middle});
    b.triangle({half, top, 0}, {half, top, -kHouseDepth}, {half, ridge, middle});
    return b;
}

MeshBuilder groundWallPart(int bays, int doorBay) {
    MeshBuilder b;
    b.use(Mat::plasterCream);
    const float half = kBay * float(bays) / 2;
    const float door = windowCenter(bays, doorBay);
    std::vector<Opening> holes = {{door - 0.5f, door + 0.5f, 0.3f, 2.5f}};
    for (int i = 0; i < bays; ++i)
        if (i != doorBay) holes.push_back(windowHole(bays, i, 0.35f));
    wallPanel(b, {-half, half, 0, kGroundFloor, 0}, holes, 0.22f);
    shell(b, half, 0, kGroundFloor);
    b.use(Mat::ashlarDark);
    b.box({-half + 0.004f, 0, -0.05f}, {door - 0.68f, kPlinth, 0.07f}, 0.015f);
    b.box({door + 0.68f, 0, -0.05f}, {half - 0.004f, kPlinth, 0.07f}, 0.015f);
    b.use(Mat::stone);  // quoins at both corners
    for (int i = 0; i < 7; ++i)
        for (const float side : {-1.0f, 1.0f}) {
            const float length = i % 2 ? 0.34f : 0.54f, y = kPlinth + 0.425f * float(i);
            const float x0 = side > 0 ? half - length : -half + 0.004f;
            const float x1 = side > 0 ? half - 0.004f : -half + length;
            b.box({x0, y + 0.006f, -0.05f}, {x1, y + 0.42f, 0.03f}, 0.010f);
        }
    return b;
}

MeshBuilder stringCoursePart(int bays) {
    MeshBuilder b;
    b.use(Mat::stone);
    const float half = kBay * float(bays) / 2;
    b.moulding({{0, -0.12f},
                {0.06f, -0.12f},
                {0.06f, -0.06f},
                {0.09f, -0.03f},
                {0.13f, 0.0f},
                {0.13f, 0.07f},
                {0, 0.12f}},
               -half, half);
    return b;
}

MeshBuilder cornicePart(int bays) {
    MeshBuilder b;
    b.use(Mat::stone);
    const float half = kBay * float(bays) / 2;
    b.moulding({{0, -0.42f},
                {0.05f, -0.42f},
                {0.05f, -0.32f},
                {0.09f, -0.29f},
                {0.12f, -0.24f},
                {0.12f, -0.20f},
                {0.26f, -0.20f},
                {0.26f, -0.12f},
                {0.29f, -0.09f},
                {0.33f, -0.02f},
                {0.33f, 0.02f},
                {0, 0.02f}},
               -half, half);
    for (float x = -half + 0.2f; x < half - 0.1f; x += 0.4f)  // modillions
        b.box({x - 0.07f, -0.33f, 0.0f}, {x + 0.07f, -0.20f, 0.22f});
    return b;
}

MeshBuilder roofPart(int bays) {
    MeshBuilder b;
    b.use(Mat::roof);
    const float half = kBay * float(bays) / 2, reach = kHouseDepth / 2;
    const float ridge = kRise * reach, thick = 0.14f;
    for (const float side : {1.0f, -1.0f}) {
        b.placeRotated({0, 0, -reach}, rotationTurns({0, 1, 0}, side > 0 ? 0 : 0.5));
        const float z = reach + kEaves, y = -kRise * kEaves;
        b.hexahedron({vec3(-half, ridge, 0), vec3(half, ridge, 0), vec3(-half, ridge + thick, 0),
                      vec3(half, ridge + thick, 0), vec3(-half, y, z), vec3(half, y, z),
                      vec3(-half, y + thick, z), vec3(half, y + thick, z)},
                     0.015f);
        // The last tiles over the gutter.
        const int tiles = int(half * 2 / 0.32f + 0.5f);
        for (int i = 0; i < tiles; ++i) {
            const float x = -half + 0.16f + 0.32f * float(i);
            const vec3 path[2] = {{x, y + thick + 0.13f, z - 0.28f},
                                  {x, y + thick - 0.035f, z + 0.05f}};
            b.tube(path, 0.085f, 6);
        }
    }
    b.placeRotated({0, 0, -reach}, quat(1, 0, 0, 0));
    for (float x = -half; x < half - 0.2f; x += 0.4f) {
        const vec3 path[2] = {{x + 0.01f, ridge + thick - 0.02f, 0},
                              {x + 0.40f, ridge + thick + 0.005f, 0}};
        b.tube(path, 0.125f, 8);
    }
    return b;
}

MeshBuilder chimneyPart() {
    MeshBuilder b;
    b.use(Mat::brick).box({-0.4f, -1.2f, -0.3f}, {0.4f, 1.15f, 0.3f}, 0.012f);
    b.use(Mat::stone).box({-0.48f, 1.15f, -0.38f}, {0.48f, 1.27f, 0.38f}, 0.02f);
    b.use(Mat::terracotta);
    for (const float x : {-0.2f, 0.2f}) {
        b.place({x, 1.27f, 0});
        b.lathe({{0.13f, 0},
                 {0.10f, 0.35f},
                 {0.125f, 0.37f},
                 {0.125f, 0.41f},
                 {0.08f, 0.41f},
                 {0.08f, 0.1f}},
                12);
    }
    return b;
}

}  // namespace rushlight::content
