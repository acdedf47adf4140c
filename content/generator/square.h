#pragma once

#include "content/generator/document.h"
#include "content/generator/parts/parts.h"

namespace rushlight::content {

/// The level under construction: a document, and counters for the names of nodes.
struct Square {
    Document document{"square"};
    int lamps = 0;
    int swingingLamps = 0;
    int windows = 0;
};

/// A wall's local space in the world: x to the right along it, z out of it.
struct WallFrame {
    vec3 origin{0};
    double yaw = 0;  ///< turns; 0 faces +z

    vec3 point(const vec3& local) const { return origin + rotationTurns({0, 1, 0}, yaw) * local; }
    Placement at(const vec3& local, double turn = 0, float scale = 1) const {
        return content::at(point(local), yaw + turn, scale);
    }
};

enum class LampColor { warm, amber, cool };

void buildBuildings(Square& square);
void buildGround(Square& square);
void buildFurniture(Square& square);
void buildLamps(Square& square);

/// Places windows and shutters over the holes of an upper or ground wall.
struct WindowKit {
    int window, shutter;
};

std::string numbered(const char* stem, int number);

/// The walls that several builders hang things on.
inline constexpr float kNorthFront = -14.0f;  ///< z of the arcade's columns
inline constexpr float kWestFront = -18.0f;   ///< x of the arcade's columns
inline constexpr float kEastFront = 17.6f;    ///< x of the houses' fronts
inline constexpr float kSouthFront = 18.0f;   ///< z of the town wall
inline constexpr float kGateX = 4.0f;
inline constexpr vec3 kTowerAt{-21.0f, 0, -17.0f};
WallFrame northArcade();
WallFrame westArcade();
WallFrame eastRow();
WallFrame southWall();

/// The whole level; the caller saves it.
Square buildSquare();

/// A small scene for picture tests.
Document buildTestCard();

}  // namespace rushlight::content
