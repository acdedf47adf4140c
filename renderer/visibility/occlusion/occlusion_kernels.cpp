#include "renderer/visibility/occlusion/occlusion_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/visibility/occlusion/occlusion_kernels.cpp"
#include <hwy/foreach_target.h>

#include "renderer/visibility/occlusion/occlusion_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace rushlight::HWY_NAMESPACE {
constexpr int32_t kNoColumn = 1 << 20;

// --- vertices ---

HWY_INLINE F dotRow(F x, F y, F z, const mat4& m, int row) {
    const Floats d;
    const auto term = [&](F v, int column) { return hn::Mul(v, hn::Set(d, m[column][row])); };
    return hn::Add(hn::Add(term(x, 0), term(y, 1)), hn::Add(term(z, 2), hn::Set(d, m[3][row])));
}

ProjectedBounds ProjectVertices(const OccluderMesh& mesh, const ProjectParameters& p,
                                ScreenVertex* out) {
    const Floats d;
    const F halfWidth = hn::Set(d, p.halfWidth), halfHeight = hn::Set(d, p.halfHeight);
    F leastW = hn::Set(d, std::numeric_limits<float>::max());
    F greatest = hn::Zero(d);
    U any = hn::Zero(Masks());
    const auto snap = [&](F v) {
        return hn::Mul(hn::Round(hn::Mul(v, hn::Set(d, 256.0f))), hn::Set(d, 1 / 256.0f));
    };
    for (size_t i = 0; i < mesh.vertexCount; i += hn::Lanes(d)) {
        const F x = hn::LoadU(d, &mesh.x[i]), y = hn::LoadU(d, &mesh.y[i]),
                z = hn::LoadU(d, &mesh.z[i]);
        const F clipX = dotRow(x, y, z, p.clipFromLocal, 0),
                clipY = dotRow(x, y, z, p.clipFromLocal, 1);
        const F clipZ = dotRow(x, y, z, p.clipFromLocal, 2),
                clipW = dotRow(x, y, z, p.clipFromLocal, 3);
        const F limitX = hn::Mul(clipW, hn::Set(d, p.guardX)),
                limitY = hn::Mul(clipW, hn::Set(d, p.guardY));

        U outside = hn::Zero(Masks());
        const auto flag = [&](auto inside, uint32_t bit) {
            const U bits = hn::Set(Masks(), bit);
            outside = hn::Or(outside, hn::IfThenZeroElse(hn::RebindMask(Masks(), inside), bits));
        };
        // Written as what holds inside, so that a NaN is outside.
        flag(hn::And(hn::Le(clipZ, hn::Mul(clipW, hn::Set(d, p.nearFactor))),
                     hn::Gt(clipW, hn::Zero(d))),
             kOutsideNear);
        flag(hn::Ge(clipX, hn::Neg(limitX)), kOutsideLeft);
        flag(hn::Le(clipX, limitX), kOutsideRight);
        flag(hn::Ge(clipY, hn::Neg(limitY)), kOutsideBottom);
        flag(hn::Le(clipY, limitY), kOutsideTop);

        const F inverse = hn::Div(hn::Set(d, 1.0f), clipW);
        const F pixelX = snap(hn::Add(hn::Mul(hn::Mul(clipX, inverse), halfWidth), halfWidth));
        const F pixelY = snap(hn::Add(hn::Mul(hn::Mul(clipY, inverse), halfHeight), halfHeight));
        hn::StoreInterleaved4(pixelX, pixelY, hn::Mul(clipZ, inverse), hn::BitCast(d, outside), d,
                              &out[i].x);

        const auto inside = hn::RebindMask(d, hn::Eq(outside, hn::Zero(Masks())));
        leastW = hn::IfThenElse(inside, hn::Min(leastW, clipW), leastW);
        const F pixel = hn::Max(hn::Abs(pixelX), hn::Abs(pixelY));
        greatest = hn::IfThenElse(inside, hn::Max(greatest, pixel), greatest);
        if (i + hn::Lanes(d) > mesh.vertexCount)
            outside = hn::IfThenElseZero(hn::FirstN(Masks(), mesh.vertexCount - i), outside);
        any = hn::Or(any, outside);
    }
    HWY_ALIGN uint32_t anyBits[kMaxLanes];
    hn::Store(any, Masks(), anyBits);
    uint32_t outsideAny = 0;
    for (size_t lane = 0; lane < hn::Lanes(d); ++lane) outsideAny |= anyBits[lane];
    return {hn::GetLane(hn::MinOfLanes(d, leastW)), hn::GetLane(hn::MaxOfLanes(d, greatest)),
            outsideAny};
}

// --- filling ---

/// The first and last columns of a triangle in each row of a band.
struct Spans {
    HWY_ALIGN int32_t first[kBandRows + kMaxLanes];
    HWY_ALIGN int32_t last[kBandRows + kMaxLanes];
};

/// Sample heights of rows from `row` on. Below the target's last row its samples are repeated, so
/// that tiles that reach over the edge can fill up.
HWY_INLINE F sampleHeights(const DepthTiles& tiles, uint32_t row) {
    const I rows = hn::Min(hn::Iota(Ints(), int32_t(row)),
                           hn::Set(Ints(), int32_t(tiles.height) - 1));
    return hn::Add(hn::ConvertTo(Floats(), rows), hn::Set(Floats(), 0.5f));
}

HWY_INLINE F edgeX(F height, float x, float y, float slope) {
    const Floats d;
    return hn::Add(hn::Set(d, x), hn::Mul(hn::Set(d, slope), hn::Sub(height, hn::Set(d, y))));
}

/// Spans of rows [begin, end), rows counted from the band's first, `begin` a multiple of
/// kTileHeight.
HWY_INLINE void findSpans(const DepthTiles& tiles, const FillTriangle& t, RowRange rows,
                          uint32_t bandRow, uint32_t begin, uint32_t end, Spans& spans) {
    const Floats d;
    const Ints di;
    const F half = hn::Set(d, 0.5f), width = hn::Set(d, float(tiles.width));
    const I lastColumn = hn::Set(di, int32_t(tiles.width) - 1);
    const I lastPadded = hn::Set(di, int32_t(tiles.columns * kTileWidth) - 1);
    const I lastRow = hn::Set(di, int32_t(tiles.height) - 1);
    for (uint32_t row = begin; row < end; row += uint32_t(hn::Lanes(d))) {
        const F height = sampleHeights(tiles, bandRow + row);
        const F longX = edgeX(height, t.lowX, t.lowY, t.longSlope);
        const F lowX = edgeX(height, t.lowEdgeX, t.lowY, t.lowSlope);
        const F highX = edgeX(height, t.highX, t.midY, t.highSlope);
        const F left = t.longIsLeft ? longX : hn::Max(lowX, highX);
        const F right = t.longIsLeft ? hn::Min(lowX, highX) : longX;
        I first = hn::ConvertTo(
            di, hn::Min(hn::Max(hn::Ceil(hn::Sub(left, half)), hn::Zero(d)), width));
        I last = hn::ConvertTo(
            di, hn::Min(hn::Max(hn::Floor(hn::Sub(right, half)), hn::Set(d, -1.0f)), width));
        last = hn::IfThenElse(hn::Lt(last, lastColumn), last, lastPadded);
        const I number = hn::Min(hn::Iota(di, int32_t(bandRow + row)), lastRow);
        const auto without = hn::Or(hn::Lt(number, hn::Set(di, int32_t(rows.first))),
                                    hn::Gt(number, hn::Set(di, int32_t(rows.last))));
        const auto none = hn::Or(without, hn::Gt(first, last));
        hn::StoreU(hn::IfThenElse(none, hn::Set(di, kNoColumn), first), di, spans.first + row);
        hn::StoreU(hn::IfThenElse(none, hn::Set(di, -1), last), di, spans.last + row);
    }
}

/// Adds to tiles the samples of `coverage`, all of depth `depth` or nearer. What is partly covered
/// is kept in one layer: a surface far nearer than that layer replaces it, another one joins it at
/// the farther of the two depths.
HWY_INLINE void addCoverage(const DepthTiles& tiles, size_t at, U coverage, F depth) {
    const Floats d;
    const Masks du;
    F full = hn::LoadU(d, tiles.full + at), partial = hn::LoadU(d, tiles.partial + at);
    U mask = hn::LoadU(du, tiles.mask + at);
    const U all = hn::Set(du, ~0u), none = hn::Zero(du);
    const auto toFloat = [&](auto m) { return hn::RebindMask(d, m); };

    const auto covered = hn::Eq(coverage, all);
    full = hn::IfThenElse(toFloat(covered), hn::Max(full, depth), full);
    coverage = hn::IfThenElseZero(hn::RebindMask(du, hn::Gt(depth, full)), coverage);
    mask = hn::IfThenElseZero(hn::RebindMask(du, hn::Gt(partial, full)), mask);
    const U joined = hn::Or(mask, coverage);
    const auto addsNothing = hn::And(hn::Eq(joined, mask),
                                     hn::RebindMask(du, hn::Le(depth, partial)));
    const auto hidesMask = hn::And(hn::Eq(joined, coverage),
                                   hn::RebindMask(du, hn::Ge(depth, partial)));
    const auto farNearer = hn::RebindMask(du,
                                          hn::Gt(hn::Sub(depth, partial), hn::Sub(partial, full)));
    const auto covers = hn::Ne(coverage, none);
    const auto replaces = hn::And(covers, hn::Or(hn::Or(hn::Eq(mask, none), hidesMask),
                                                 hn::And(farNearer, hn::Ne(joined, all))));
    const auto joins = hn::AndNot(hn::Or(replaces, addsNothing), covers);
    partial = hn::IfThenElse(toFloat(replaces), depth,
                             hn::IfThenElse(toFloat(joins), hn::Min(partial, depth), partial));
    mask = hn::IfThenElse(replaces, coverage, hn::IfThenElse(joins, joined, mask));

    const auto complete = hn::Eq(mask, all);
    full = hn::IfThenElse(toFloat(complete), hn::Max(full, partial), full);
    mask = hn::IfThenElse(complete, none, mask);
    hn::StoreU(full, d, tiles.full + at);
    hn::StoreU(partial, d, tiles.partial + at);
    hn::StoreU(mask, du, tiles.mask + at);
}

/// The farthest depth that a triangle's plane has in the tiles of a row, never behind its farthest
/// vertex.
struct TilePlane {
    float atFirst, step, least;

    TilePlane(const FillTriangle& t, uint32_t tileRow)
        : step(t.depthX * float(kTileWidth)), least(t.leastDepth) {
        const float farX = t.depthX > 0 ? 0.5f : float(kTileWidth) - 0.5f;
        const float farY = t.depthY > 0 ? 0.5f : float(kTileHeight) - 0.5f;
        const float height = float(tileRow * kTileHeight) + farY;
        atFirst = t.depth + t.depthY * (height - t.lowY) + t.depthX * (farX - t.lowX);
    }
    F at(int32_t column) const {
        const Floats d;
        const F offset = hn::Mul(hn::Set(d, step), hn::Iota(d, float(column)));
        return hn::Max(hn::Add(hn::Set(d, atFirst), offset), hn::Set(d, least));
    }
};

HWY_INLINE bool isUncut(const DepthTiles& tiles, size_t at) {
    const Masks du;
    return hn::AllTrue(du, hn::Eq(hn::LoadU(du, tiles.cut + at), hn::Zero(du)));
}

HWY_INLINE void fillTileRow(const DepthTiles& tiles, const FillTriangle& t, const int32_t* first,
                            const int32_t* last, uint32_t tileRow, bool cut) {
    const Floats d;
    const int32_t lanes = int32_t(hn::Lanes(d));
    const int32_t leftMost = std::min(std::min(first[0], first[1]), std::min(first[2], first[3]));
    const int32_t rightMost = std::max(std::max(last[0], last[1]), std::max(last[2], last[3]));
    if (rightMost < leftMost) return;
    const int32_t innerLeft = std::max(std::max(first[0], first[1]), std::max(first[2], first[3]));
    const int32_t innerRight = std::min(std::min(last[0], last[1]), std::min(last[2], last[3]));
    const int32_t wholeBegin = (innerLeft + 7) >> 3, wholeEnd = (innerRight + 1) >> 3;
    const TilePlane plane(t, tileRow);
    const size_t rowAt = size_t(tileRow) * tiles.stride;
    for (int32_t column = leftMost >> 3; column <= rightMost >> 3; column += lanes) {
        const size_t at = rowAt + size_t(column);
        const F depth = plane.at(column);
        if (column >= wholeBegin && column + lanes <= wholeEnd && (!cut || isUncut(tiles, at))) {
            hn::StoreU(hn::Max(hn::LoadU(d, tiles.full + at), depth), d, tiles.full + at);
            continue;
        }
        if (hn::AllTrue(d, hn::Le(depth, hn::LoadU(d, tiles.full + at)))) continue;
        const I base = hn::ShiftLeft<3>(hn::Iota(Ints(), column));
        U coverage = columnBits(base, first[0], last[0]);
        coverage = hn::Or(coverage, hn::ShiftLeft<8>(columnBits(base, first[1], last[1])));
        coverage = hn::Or(coverage, hn::ShiftLeft<16>(columnBits(base, first[2], last[2])));
        coverage = hn::Or(coverage, hn::ShiftLeft<24>(columnBits(base, first[3], last[3])));
        if (cut) coverage = hn::AndNot(hn::LoadU(Masks(), tiles.cut + at), coverage);
        addCoverage(tiles, at, coverage, depth);
    }
}

HWY_INLINE void fillTriangle(const DepthTiles& tiles, const FillTriangle& t, RowRange rows,
                             uint32_t bandRow, bool cut, Spans& spans) {
    const uint32_t bandEnd = std::min(bandRow + kBandRows, tiles.height);
    const uint32_t firstRow = std::max<uint32_t>(rows.first, bandRow) - bandRow;
    const uint32_t lastRow = std::min<uint32_t>(rows.last, bandEnd - 1) - bandRow;
    const uint32_t begin = firstRow / kTileHeight * kTileHeight;
    const uint32_t end = (lastRow / kTileHeight + 1) * kTileHeight;
    findSpans(tiles, t, rows, bandRow, begin, end, spans);
    for (uint32_t row = begin; row < end; row += kTileHeight)
        fillTileRow(tiles, t, spans.first + row, spans.last + row, (bandRow + row) / kTileHeight,
                    cut);
}

/// Marks the samples near an occluder's outline that lie in a band; true where there are any.
HWY_INLINE bool cutOutline(const DepthTiles& tiles, const OutlineEdge& e, uint32_t bandRow) {
    const Floats d;
    const F half = hn::Set(d, 0.5f);
    const uint32_t begin = std::max<uint32_t>(e.firstRow, bandRow);
    const uint32_t end = std::min({uint32_t(e.lastRow) + 1, bandRow + kBandRows, tiles.height});
    const F leftLimit = hn::Set(d, e.left), rightLimit = hn::Set(d, e.right),
            reach = hn::Set(d, e.reach);
    const F width = hn::Set(d, float(tiles.width));
    bool any = false;
    HWY_ALIGN int32_t firsts[kMaxLanes], lasts[kMaxLanes];
    for (uint32_t row = begin; row < end; row += uint32_t(hn::Lanes(d))) {
        const F x = edgeX(sampleHeights(tiles, row), e.x, e.y, e.slope);
        const F left = hn::Max(hn::Sub(x, reach), leftLimit),
                right = hn::Min(hn::Add(x, reach), rightLimit);
        const F first = hn::Max(hn::Ceil(hn::Sub(left, half)), hn::Zero(d));
        const F last = hn::Min(hn::Floor(hn::Sub(right, half)), hn::Sub(width, hn::Set(d, 1.0f)));
        if (hn::AllFalse(d, hn::Le(first, last))) continue;
        hn::Store(hn::ConvertTo(Ints(), hn::Min(first, width)), Ints(), firsts);
        hn::Store(hn::ConvertTo(Ints(), hn::Max(last, hn::Set(d, -1.0f))), Ints(), lasts);
        for (uint32_t lane = 0; lane < hn::Lanes(d) && row + lane < end; ++lane)
            for (int32_t column = firsts[lane]; column <= lasts[lane]; ++column) {
                const uint32_t y = row + lane;
                tiles.cut[size_t(y / kTileHeight) * tiles.stride + size_t(column) / kTileWidth] |=
                    1u << (y % kTileHeight * kTileWidth + uint32_t(column) % kTileWidth);
                any = true;
            }
    }
    return any;
}

void FillBand(const DepthTiles& tiles, std::span<const FillList> occluders, uint32_t band) {
    const uint32_t bandRow = band * kBandRows,
                   bandEnd = std::min(bandRow + kBandRows, tiles.height);
    const size_t begin = size_t(bandRow / kTileHeight) * tiles.stride;
    const size_t count = (bandEnd - bandRow + kTileHeight - 1) / kTileHeight * size_t(tiles.stride);
    const auto clear = [&](auto* values) {
        std::memset(values + begin, 0, count * sizeof *values);
    };
    clear(tiles.full);
    clear(tiles.partial);
    clear(tiles.mask);
    clear(tiles.cut);
    Spans spans;
    for (const FillList& occluder : occluders) {
        if (occluder.rows.first >= bandEnd || occluder.rows.last < bandRow) continue;
        bool cut = false;
        for (const OutlineEdge& edge : occluder.outline)
            if (edge.firstRow < bandEnd && edge.lastRow >= bandRow)
                cut |= cutOutline(tiles, edge, bandRow);
        for (size_t i = 0; i < occluder.triangleRows.size(); ++i) {
            const RowRange rows = occluder.triangleRows[i];
            if (rows.first < bandEnd && rows.last >= bandRow)
                fillTriangle(tiles, occluder.triangles[i], rows, bandRow, cut, spans);
        }
        if (cut) clear(tiles.cut);
    }
}

}  // namespace rushlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {

HWY_EXPORT(ProjectVertices);
HWY_EXPORT(FillBand);

ProjectedBounds projectVertices(const OccluderMesh& mesh, const ProjectParameters& parameters,
                                ScreenVertex* out) {
    return HWY_DYNAMIC_DISPATCH(ProjectVertices)(mesh, parameters, out);
}

void fillBand(const DepthTiles& tiles, std::span<const FillList> occluders, uint32_t band) {
    HWY_DYNAMIC_DISPATCH(FillBand)(tiles, occluders, band);
}

}  // namespace rushlight
#endif
