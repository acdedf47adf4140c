#pragma once
// The things of the square, each a mesh in its own space: origin on the ground in the middle, front
// towards +z. Lengths in metres.

#include "content/generator/mesh_builder.h"

namespace rushlight::content {

// Arcade: one bay, from column axis to column axis.
inline constexpr float kBay = 3.2f;
inline constexpr float kArcadeFloor = 0.15f;
inline constexpr float kArcadeHeight = 4.2f;
inline constexpr float kArcadeDepth = 3.75f;
MeshBuilder archPart();
MeshBuilder columnPart();
MeshBuilder pierPart();
MeshBuilder arcadeFloorPart();
MeshBuilder arcadeBackPart(bool door);

// Houses: `bays` windows wide; every storey is three metres.
inline constexpr float kStorey = 3.0f;
inline constexpr float kGroundFloor = 3.6f;
inline constexpr float kHouseDepth = 8.0f;
inline constexpr float kWindowWidth = 1.0f;
inline constexpr float kWindowHeight = 1.5f;
inline constexpr float kWindowSill = 0.85f;
MeshBuilder upperWallPart(int bays, int storeys);
MeshBuilder groundWallPart(int bays, int doorBay);
MeshBuilder stringCoursePart(int bays);
MeshBuilder cornicePart(int bays);
MeshBuilder roofPart(int bays);
MeshBuilder chimneyPart();

// Openings: origin at the lower middle of the hole, in the plane of the wall.
MeshBuilder windowPart();
MeshBuilder shutterPart();
MeshBuilder doorPart();
MeshBuilder doorStepPart();

// Tower and wall.
inline constexpr float kTowerShaft = 15.0f;
MeshBuilder towerShaftPart();
MeshBuilder belfryPart();
MeshBuilder towerRoofPart();
MeshBuilder bellPart();
inline constexpr float kWallHeight = 5.2f;
inline constexpr float kWallSegment = 4.0f;
MeshBuilder townWallPart();
MeshBuilder gateTowerPart();
MeshBuilder gateLeafPart();

// Fountain.
MeshBuilder fountainBasinPart();
MeshBuilder fountainColumnPart();
MeshBuilder waterPart(float radius, int rings);

// Lamps: a lantern hangs from its origin; its light is at (0, -kLanternDrop, 0).
inline constexpr float kLanternDrop = 0.56f;
MeshBuilder lanternPart();
MeshBuilder bulbPart();
MeshBuilder lampPostPart();
MeshBuilder wallBracketPart();
MeshBuilder chainPart(float length);

// Market and furniture.
MeshBuilder benchPart();
MeshBuilder barrelPart();
MeshBuilder cratePart();
MeshBuilder sackPart();
MeshBuilder stallFramePart();
MeshBuilder awningPart();
MeshBuilder producePart(uint32_t seed);
MeshBuilder cartPart();

// Plants.
MeshBuilder potPart();
MeshBuilder bushPart(uint32_t seed);
MeshBuilder treeTrunkPart();
MeshBuilder treeCrownPart(uint32_t seed);
MeshBuilder ivyPart(float width, float height, uint32_t seed);

// Ground.
MeshBuilder groundPart(float x0, float x1, float z0, float z1);
MeshBuilder drainPart(float length);
MeshBuilder pavementPart(float length, float width);

}  // namespace rushlight::content
