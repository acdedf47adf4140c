#include "renderer/lighting/clusters/light_coverage.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/lighting/clusters/light_coverage.cpp"
#include <hwy/foreach_target.h>
// after foreach_target, by Highway's rules
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rushlight {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Lanes = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

HWY_INLINE uint32_t bitsOf(Lanes d, Mask mask) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    uint32_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

/// A light within a slice: the depths that both have, and what of the tests is the same for a whole
/// row.
struct Reach {
    float low, high;            ///< depth
    float scaleLow, scaleHigh;  ///< of slopes, there
    float inverseLow, inverseHigh;
    float limit;  ///< squared distance across the view at these depths
};

/// How far `p` is outside of [low, high].
HWY_INLINE float outside(float p, float low, float high) {
    const float d = low - p > p - high ? low - p : p - high;
    return d > 0 ? d : 0;
}

// The squared distance to the wedge between two pairs of planes through the eye. Within the corner
// of planes with outward normals m and n at distances a and b, and c = m.n, it is that from the
// edge, (a² + b² - 2abc) / (1 - c²); elsewhere the larger distance.
HWY_INLINE Vec wedgeDistance2(Lanes d, Vec a, Vec b, Vec c) {
    const auto one = hn::Set(d, 1.0f);
    const auto larger = hn::Max(a, b);
    const auto edge = hn::Div(
        hn::NegMulAdd(hn::Mul(hn::Set(d, 2.0f), hn::Mul(a, b)), c, hn::MulAdd(a, a, hn::Mul(b, b))),
        hn::NegMulAdd(c, c, one));
    const auto corner = hn::And(hn::Gt(a, hn::Mul(b, c)), hn::Gt(b, hn::Mul(a, c)));
    return hn::IfThenElse(corner, edge, hn::Mul(larger, larger));
}

/// The tiles of one row that a light's sphere may reach, from column `x` on.
struct SphereRow {
    const FroxelGrid& grid;
    const LightVolume& light;
    const Reach& reach;
    float boxY2 = 0;       ///< squared distance of the row's box
    float wedgeY = 0;      ///< distance outside of the row's wedge
    float wedgeSlope = 0;  ///< y of the outward normal's z part there: sign * slope / root

    HWY_INLINE SphereRow(const FroxelGrid& g, const LightVolume& l, const Reach& r, uint32_t row)
        : grid(g), light(l), reach(r) {
        const float bottom = g.slopesY[row], top = g.slopesY[row + 1];
        const float boxY = outside(l.center.y, std::min(bottom * r.scaleLow, bottom * r.scaleHigh),
                                   std::max(top * r.scaleLow, top * r.scaleHigh));
        boxY2 = boxY * boxY;
        if (!g.perspective) return;
        const float rootBelow = g.rootsY[row], rootAbove = g.rootsY[row + 1];
        const float below = (bottom * l.center.z - l.center.y) * rootBelow;
        const float above = (l.center.y - top * l.center.z) * rootAbove;
        wedgeY = std::max({below, above, 0.0f});
        // Outward normals are (-1, slope) / root below and (1, -slope) / root above.
        wedgeSlope = below > above ? bottom * rootBelow : -top * rootAbove;
    }

    HWY_INLINE Mask test(Lanes d, uint32_t x) const {
        const auto zero = hn::Zero(d);
        const auto left = hn::LoadU(d, &grid.slopesX[x]),
                   right = hn::LoadU(d, &grid.slopesX[x + 1]);
        const auto low = hn::Set(d, reach.scaleLow), high = hn::Set(d, reach.scaleHigh);
        const auto cx = hn::Set(d, light.center.x);
        const auto boxLeft = hn::Min(hn::Mul(left, low), hn::Mul(left, high));
        const auto boxRight = hn::Max(hn::Mul(right, low), hn::Mul(right, high));
        const auto box = hn::Max(hn::Max(hn::Sub(boxLeft, cx), hn::Sub(cx, boxRight)), zero);
        auto inside = hn::Lt(hn::MulAdd(box, box, hn::Set(d, boxY2)), hn::Set(d, reach.limit));
        if (!grid.perspective) return inside;
        const auto cz = hn::Set(d, light.center.z);
        const auto rootLeft = hn::LoadU(d, &grid.rootsX[x]);
        const auto rootRight = hn::LoadU(d, &grid.rootsX[x + 1]);
        const auto beforeLeft = hn::Mul(hn::MulSub(left, cz, cx), rootLeft);
        const auto afterRight = hn::Mul(hn::NegMulAdd(right, cz, cx), rootRight);
        const auto wedgeX = hn::Max(hn::Max(beforeLeft, afterRight), zero);
        const auto slope = hn::IfThenElse(hn::Gt(beforeLeft, afterRight), hn::Mul(left, rootLeft),
                                          hn::Neg(hn::Mul(right, rootRight)));
        const auto distance2 = wedgeDistance2(d, wedgeX, hn::Set(d, wedgeY),
                                              hn::Mul(slope, hn::Set(d, wedgeSlope)));
        return hn::And(inside, hn::Lt(distance2, hn::Set(d, light.radius * light.radius)));
    }
};

// A froxel lies within a tube around the middle line of its tile, as wide as the tile's half
// diagonal at its far end. The distance to a cone (below 90 degrees), cos * |perpendicular| - sin *
// along, is convex, and on the line q(t) = q0 + t e it is cos * (sqrt(a t² + 2 b t + c) - g t) +
// constants, with its least value where the derivative is zero.
struct ConeRow {
    const FroxelGrid& grid;
    const LightVolume& light;
    const Reach& reach;
    float middleY, sine, margin;

    HWY_INLINE ConeRow(const FroxelGrid& g, const LightVolume& l, const Reach& r, uint32_t row)
        : grid(g),
          light(l),
          reach(r),
          middleY(0.5f * (g.slopesY[row] + g.slopesY[row + 1])),
          sine(std::sqrt(std::max(0.0f, 1 - l.cosine * l.cosine))),
          margin(g.tileRadius * r.scaleHigh + 1e-3f * l.radius) {}

    HWY_INLINE Mask test(Lanes d, uint32_t x) const {
        const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), tiny = hn::Set(d, 1e-20f);
        const auto middleX = hn::Mul(
            hn::Add(hn::LoadU(d, &grid.slopesX[x]), hn::LoadU(d, &grid.slopesX[x + 1])),
            hn::Set(d, 0.5f));
        const float spread = reach.scaleHigh - reach.scaleLow, depth = reach.high - reach.low;
        const auto qx = hn::MulSub(middleX, hn::Set(d, reach.scaleLow), hn::Set(d, light.apex.x));
        const auto qy = hn::Set(d, middleY * reach.scaleLow - light.apex.y);
        const auto qz = hn::Set(d, reach.low - light.apex.z);
        const auto ex = hn::Mul(middleX, hn::Set(d, spread));
        const auto ey = hn::Set(d, middleY * spread), ez = hn::Set(d, depth);
        const auto along = [&](Vec ax, Vec ay, Vec az, Vec bx, Vec by, Vec bz) {
            return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
        };
        const auto nx = hn::Set(d, light.axis.x), ny = hn::Set(d, light.axis.y),
                   nz = hn::Set(d, light.axis.z);
        const auto qn = along(qx, qy, qz, nx, ny, nz), en = along(ex, ey, ez, nx, ny, nz);
        const auto a = hn::Max(hn::NegMulAdd(en, en, along(ex, ey, ez, ex, ey, ez)), tiny);
        const auto b = hn::NegMulAdd(qn, en, along(qx, qy, qz, ex, ey, ez));
        const auto c = hn::Max(hn::NegMulAdd(qn, qn, along(qx, qy, qz, qx, qy, qz)), zero);
        const auto g = hn::Mul(en, hn::Set(d, sine / std::max(light.cosine, 1e-3f)));
        const auto h2 = hn::Max(hn::NegMulAdd(b, hn::Div(b, a), c), zero);
        const auto slack = hn::Max(hn::Mul(a, hn::NegMulAdd(g, g, a)), tiny);
        const auto turn = hn::MulAdd(g, hn::Sqrt(hn::Div(h2, slack)), hn::Neg(hn::Div(b, a)));
        // Where the line is steeper than the cone, the distance falls all the way along g.
        const auto end = hn::IfThenElse(hn::Gt(g, zero), one, zero);
        const auto steep = hn::Ge(hn::Mul(g, g), a);
        const auto t = hn::Min(hn::Max(hn::IfThenElse(steep, end, turn), zero), one);
        const auto perpendicular2 = hn::MulAdd(hn::MulAdd(a, t, hn::Add(b, b)), t, c);
        const auto distance = hn::MulSub(hn::Set(d, light.cosine),
                                         hn::Sqrt(hn::Max(perpendicular2, zero)),
                                         hn::Mul(hn::Set(d, sine), hn::MulAdd(en, t, qn)));
        return hn::Lt(distance, hn::Set(d, margin));
    }
};

/// The tiles whose box may overlap [low, high] metres across.
struct TileRange {
    uint32_t first = 0, last = 0;
};

HWY_INLINE TileRange tilesWithin(float low, float high, const Reach& reach, float firstSlope,
                                 float inverseTile, uint32_t tiles) {
    const float least = low * (low < 0 ? reach.inverseLow : reach.inverseHigh);
    const float most = high * (high > 0 ? reach.inverseLow : reach.inverseHigh);
    // A thousandth of a tile more than is needed, against rounding
    const float first = (least - firstSlope) * inverseTile - 0.001f;
    const float last = (most - firstSlope) * inverseTile + 1.001f;
    const float limit = float(tiles);
    return {uint32_t(std::clamp(first, 0.0f, limit)), uint32_t(std::clamp(last, 0.0f, limit))};
}

/// `visit(light, row, column, bits)` for tiles from `column` on.
template <class Visit>
HWY_INLINE void coverLight(const FroxelGrid& grid, const LightVolume& light, const FroxelBand& band,
                           Visit&& visit) {
    const Lanes d;
    const float sliceLow = grid.depths[band.slice], sliceHigh = grid.depths[band.slice + 1];
    Reach reach;
    reach.low = std::max(sliceLow, light.center.z - light.radius);
    reach.high = std::min(sliceHigh, light.center.z + light.radius);
    reach.scaleLow = grid.perspective ? std::max(reach.low, 1e-4f) : 1;
    reach.scaleHigh = grid.perspective ? std::max(reach.high, 1e-4f) : 1;
    const float gap = outside(light.center.z, sliceLow, sliceHigh);
    reach.limit = light.radius * light.radius - gap * gap;
    if (reach.limit <= 0) return;
    reach.inverseLow = 1 / reach.scaleLow;
    reach.inverseHigh = 1 / reach.scaleHigh;
    const float across = std::sqrt(reach.limit);
    const TileRange columns = tilesWithin(light.center.x - across, light.center.x + across, reach,
                                          grid.slopesX[0], grid.inverseTileX, grid.tilesX);
    const TileRange rows = tilesWithin(light.center.y - across, light.center.y + across, reach,
                                       grid.slopesY[0], grid.inverseTileY, grid.tilesY);
    const uint32_t lanes = uint32_t(hn::Lanes(d));
    for (uint32_t row = std::max(rows.first, band.firstRow);
         row < std::min(rows.last, band.lastRow); ++row) {
        const SphereRow sphere(grid, light, reach, row);
        for (uint32_t x = columns.first; x < columns.last; x += lanes) {
            auto mask = hn::And(sphere.test(d, x), hn::FirstN(d, columns.last - x));
            if (light.cosine >= 0 && !hn::AllFalse(d, mask))
                mask = hn::And(mask, ConeRow(grid, light, reach, row).test(d, x));
            if (const uint32_t bits = bitsOf(d, mask)) visit(light, row, x, bits);
        }
    }
}

template <class Visit>
HWY_INLINE void coverBand(const FroxelGrid& grid, const LightVolumes& volumes,
                          const FroxelBand& band, Visit&& visit) {
    const Lanes d;
    const auto low = hn::Set(d, grid.depths[band.slice]);
    const auto high = hn::Set(d, grid.depths[band.slice + 1]);
    const uint32_t count = uint32_t(volumes.items.size());
    for (uint32_t i = 0; i < count; i += uint32_t(hn::Lanes(d))) {
        const auto overlaps = hn::And(hn::Le(hn::LoadU(d, &volumes.nearest[i]), high),
                                      hn::Ge(hn::LoadU(d, &volumes.farthest[i]), low));
        for (uint32_t bits = bitsOf(d, overlaps); bits; bits &= bits - 1)
            coverLight(grid, volumes.items[i + uint32_t(std::countr_zero(bits))], band, visit);
    }
}

}  // namespace

void countFroxels(const FroxelGrid& grid, const LightVolumes& volumes, const FroxelBand& band,
                  uint32_t listsOfFroxel, uint32_t* counts) {
    coverBand(grid, volumes, band,
              [&](const LightVolume& light, uint32_t row, uint32_t column, uint32_t bits) {
                  const size_t froxel = (size_t(band.slice) * grid.tilesY + row) * grid.tilesX +
                                        column;
                  uint32_t* lists = counts + froxel * listsOfFroxel + light.lightClass;
                  for (; bits; bits &= bits - 1)
                      ++lists[uint32_t(std::countr_zero(bits)) * listsOfFroxel];
              });
}

void writeFroxels(const FroxelGrid& grid, const LightVolumes& volumes, const FroxelBand& band,
                  uint32_t listsOfFroxel, uint32_t* next, const uint32_t* ends, uint16_t* slots) {
    coverBand(grid, volumes, band,
              [&](const LightVolume& light, uint32_t row, uint32_t column, uint32_t bits) {
                  const size_t froxel = (size_t(band.slice) * grid.tilesY + row) * grid.tilesX +
                                        column;
                  const size_t first = froxel * listsOfFroxel + light.lightClass;
                  for (; bits; bits &= bits - 1) {
                      const size_t list = first + uint32_t(std::countr_zero(bits)) * listsOfFroxel;
                      if (next[list] < ends[list]) slots[next[list]++] = light.slot;
                  }
              });
}

}  // namespace HWY_NAMESPACE
}  // namespace rushlight
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {

HWY_EXPORT(countFroxels);
HWY_EXPORT(writeFroxels);

namespace {
constexpr uint32_t kPadding = 16;  // lanes of the widest vector
}

void countLights(const FroxelGrid& grid, const LightVolumes& volumes, const FroxelBand& band,
                 uint32_t lists, uint32_t* counts) {
    HWY_DYNAMIC_DISPATCH(countFroxels)(grid, volumes, band, lists, counts);
}

void writeLights(const FroxelGrid& grid, const LightVolumes& volumes, const FroxelBand& band,
                 uint32_t lists, uint32_t* next, const uint32_t* ends, uint16_t* slots) {
    HWY_DYNAMIC_DISPATCH(writeFroxels)(grid, volumes, band, lists, next, ends, slots);
}

void FroxelGrid::setTiles(float slopeLimitX, float slopeLimitY, float tileSlopeX,
                          float tileSlopeY) {
    const auto fill = [](std::vector<float>& edges, std::vector<float>& roots, uint32_t tiles,
                         float limit, float tile) {
        edges.resize(tiles + 1 + kPadding);
        roots.resize(edges.size());
        for (uint32_t i = 0; i < edges.size(); ++i) {
            edges[i] = float(i) * tile - limit;
            roots[i] = 1 / std::sqrt(1 + edges[i] * edges[i]);
        }
    };
    fill(slopesX, rootsX, tilesX, slopeLimitX, tileSlopeX);
    fill(slopesY, rootsY, tilesY, slopeLimitY, tileSlopeY);
    inverseTileX = 1 / tileSlopeX;
    inverseTileY = 1 / tileSlopeY;
    tileRadius = 0.5f * std::hypot(tileSlopeX, tileSlopeY);
}

void LightVolumes::finish() {
    // Padding reaches no depth.
    nearest.assign(items.size() + kPadding, std::numeric_limits<float>::infinity());
    farthest.assign(items.size() + kPadding, -std::numeric_limits<float>::infinity());
    for (size_t i = 0; i < items.size(); ++i) {
        nearest[i] = items[i].center.z - items[i].radius;
        farthest[i] = items[i].center.z + items[i].radius;
    }
}

}  // namespace rushlight
#endif
