#pragma once
// What the steps of occlusion culling hand to each other: see occlusion_buffer.h for the whole.

#include "engine/core/math.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rushlight {

inline constexpr uint32_t kTileWidth = 8, kTileHeight = 4;  ///< a bit of a 32-bit mask each
inline constexpr uint32_t kBandRows = 64;                   ///< pixel rows that one job fills
inline constexpr uint32_t kMaxLanes = 8;  ///< vectors of the kernels are at most this long

inline constexpr size_t paddedToLanes(size_t count) {
    return (count + kMaxLanes - 1) / kMaxLanes * kMaxLanes;
}

/// A bound of what float arithmetic does to a clip coordinate, relative to the sum of the absolute
/// values of what was added up: a GPU's two products with four terms each (world, clip), ours, and
/// the clipping at a plane, 20 roundings in all, each to 2^-24 (Higham, "Accuracy and Stability of
/// Numerical Algorithms", 2002, section 3.1).
inline constexpr float kTransformError = 0x1.4p-20f;

/// What float arithmetic on pixel coordinates does, relative to the largest: viewport transform,
/// edges, planes.
inline constexpr float kPixelError = 0x1p-20f;

/// What float arithmetic does to the slope of a triangle's plane, relative to the slope and to how
/// badly the triangle is shaped: its longest side squared by its area.
inline constexpr float kPlaneError = 0x1p-22f;

/// Depth tiles, row by row. A tile's 32 samples have depth >= `full`; those of `mask` also have
/// depth >= `partial`. (Reversed z: greater is nearer.) Bit 8 * y + x of a mask is sample (x, y).
/// `cut` is zero between occluders.
struct DepthTiles {
    uint32_t width = 0, height = 0;  ///< pixels
    uint32_t columns = 0, rows = 0;  ///< tiles
    uint32_t stride = 0;             ///< tiles from row to row, more than columns + kMaxLanes
    float* full = nullptr;
    float* partial = nullptr;
    uint32_t* mask = nullptr;
    uint32_t* cut = nullptr;
};

/// In pixels, y up, on a grid of 1/256; `depth` is z / w.
struct ScreenVertex {
    float x, y, depth;
    uint32_t outside;  ///< kOutside... bits; where any is set, x and y mean nothing
};
inline constexpr uint32_t kOutsideNear = 1, kOutsideLeft = 2, kOutsideRight = 4, kOutsideBottom = 8,
                          kOutsideTop = 16;

/// A triangle to fill: x between a long edge, from the lowest to the highest vertex, and two short
/// ones.
struct FillTriangle {
    float lowX, lowY, midX, midY;
    float longSlope, lowSlope, highSlope;  ///< dx/dy from low to high, low to mid, and mid to high
    float highX;     ///< where the upper short edge begins: midX, or beyond everything if it is
                     ///< horizontal
    float lowEdgeX;  ///< where the lower short edge begins: lowX, or beyond everything if it is
                     ///< horizontal
    float depth;     ///< at (lowX, lowY), rounded to the far side
    float depthX, depthY;  ///< per pixel
    float leastDepth;      ///< of the vertices, rounded to the far side
    uint32_t longIsLeft;
};

/// A part of an occluder's outline: samples nearer to it than the error of its vertices are not to
/// be relied on.
struct OutlineEdge {
    float x, y, slope;  ///< x at height y, dx/dy
    float reach;        ///< pixels in x within which a sample is too near
    float left, right;  ///< bounds of all of it
    uint16_t firstRow, lastRow;
};

struct RowRange {
    uint16_t first, last;  ///< inclusive
};

/// One occluder, ready to be filled.
struct FillList {
    std::span<const FillTriangle> triangles;
    std::span<const RowRange> triangleRows;
    std::span<const OutlineEdge> outline;
    RowRange rows;  ///< of all triangles
};

struct OcclusionBox {
    vec3 center;      ///< world
    vec3 halfExtent;  ///< not negative
};

}  // namespace rushlight
