#include "content/generator/square.h"

namespace rushlight::content {

std::string numbered(const char* stem, int number) {
    return std::string(stem) + (number < 10 ? ".0" : ".") + std::to_string(number);
}

// Each frame's origin is the middle of its row, on the ground.
WallFrame northArcade() { return {{kWestFront + 5.5f * kBay, 0, kNorthFront}, 0}; }
WallFrame westArcade() { return {{kWestFront, 0, kNorthFront + 5 * kBay}, 0.25}; }
WallFrame eastRow() { return {{kEastFront, 0, -0.4f}, 0.75}; }
WallFrame southWall() { return {{0, 0, kSouthFront}, 0.5}; }

Square buildSquare() {
    Square square;
    Document& d = square.document;
    d.addCamera("square", {10.2f, 1.72f, 10.6f}, {-5.2f, 4.3f, -7.5f}, 52);
    d.addCamera("arcade", {14.9f, 1.75f, -15.9f}, {-6.0f, 2.0f, -15.3f}, 50);
    d.addCamera("fountain", {3.9f, 1.5f, 4.6f}, {-0.4f, 1.7f, -0.6f}, 45);
    d.addCamera("overview", {14.5f, 14.5f, 22.5f}, {-3.5f, 2.0f, -3.5f}, 52);
    d.addCamera("gate", {-3.2f, 1.7f, 6.2f}, {4.2f, 3.0f, 18.0f}, 55);
    d.addNode("spawn", -1, at({8.0f, 0, 9.0f}, 0.61));
    const int sun = d.addNode("sun", -1,
                              {{-30, 24, 22},
                               rotationTurns({0, 1, 0}, -0.112) * rotationTurns({1, 0, 0}, -0.066),
                               vec3(1)});
    d.addLight(sun, {LightSpec::Kind::sun, {1.0f, 0.60f, 0.33f}, 3.0f});
    buildGround(square);
    buildBuildings(square);
    buildFurniture(square);
    buildLamps(square);
    return square;
}

}  // namespace rushlight::content
