#include "renderer/visibility/occlusion/occlusion_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/visibility/occlusion/occlusion_boxes.cpp"
#include <hwy/foreach_target.h>

#include "renderer/visibility/occlusion/occlusion_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace rushlight::HWY_NAMESPACE {

struct BoxQuery {
    int32_t left, right, bottom, top;  ///< pixels, inclusive
    float depth;                       ///< the nearest, rounded to the near side
};

/// Some of the pixels of a query are not known to be hidden.
HWY_INLINE bool showsThrough(const DepthTiles& tiles, const BoxQuery& q) {
    const Floats d;
    const Masks du;
    const int32_t lanes = int32_t(hn::Lanes(d));
    const F depth = hn::Set(d, q.depth);
    const int32_t firstRow = q.bottom / int32_t(kTileHeight),
                  lastRow = q.top / int32_t(kTileHeight);
    const U firstBits = hn::Set(du, ~0u << (q.bottom - firstRow * int32_t(kTileHeight)) * 8);
    const U lastBits = hn::Set(du, ~0u >> (lastRow * int32_t(kTileHeight) + 3 - q.top) * 8);
    for (int32_t column = q.left / 8; column <= q.right / 8; column += lanes) {
        const I base = hn::ShiftLeft<3>(hn::Iota(Ints(), column));
        U columns = columnBits(base, q.left, q.right);
        columns = hn::Or(columns, hn::ShiftLeft<8>(columns));
        columns = hn::Or(columns, hn::ShiftLeft<16>(columns));
        size_t at = size_t(firstRow) * tiles.stride + size_t(column);
        for (int32_t row = firstRow; row <= lastRow; ++row, at += tiles.stride) {
            const auto behindFull = hn::RebindMask(du,
                                                   hn::Lt(depth, hn::LoadU(d, tiles.full + at)));
            U open = hn::IfThenZeroElse(behindFull, columns);
            if (hn::AllTrue(du, hn::Eq(open, hn::Zero(du)))) continue;
            if (row == firstRow) open = hn::And(open, firstBits);
            if (row == lastRow) open = hn::And(open, lastBits);
            const auto behindPartial = hn::RebindMask(
                du, hn::Lt(depth, hn::LoadU(d, tiles.partial + at)));
            open = hn::AndNot(hn::IfThenElseZero(behindPartial, hn::LoadU(du, tiles.mask + at)),
                              open);
            if (!hn::AllTrue(du, hn::Eq(open, hn::Zero(du)))) return true;
        }
    }
    return false;
}

/// Up to kMaxLanes boxes as pixel rectangles and depths; `unsure` where a box is not wholly before
/// the eye.
struct BoxProjection {
    HWY_ALIGN int32_t left[kMaxLanes], right[kMaxLanes], bottom[kMaxLanes], top[kMaxLanes];
    HWY_ALIGN float depth[kMaxLanes];
    HWY_ALIGN int32_t unsure[kMaxLanes];
};

/// One row of the clip matrix over boxes: at the centre, what each half extent adds, and the sum of
/// all magnitudes.
struct ClipRow {
    F center, x, y, z, magnitude;

    ClipRow(const mat4& m, int row, const F* c, const F* h) {
        const Floats d;
        const F mx = hn::Set(d, m[0][row]), my = hn::Set(d, m[1][row]), mz = hn::Set(d, m[2][row]);
        const F mw = hn::Set(d, m[3][row]);
        center = hn::Add(hn::Add(hn::Mul(c[0], mx), hn::Mul(c[1], my)),
                         hn::Add(hn::Mul(c[2], mz), mw));
        x = hn::Mul(h[0], mx);
        y = hn::Mul(h[1], my);
        z = hn::Mul(h[2], mz);
        const auto term = [](F v, F half, F factor) {
            return hn::Add(hn::Mul(hn::Abs(v), hn::Abs(factor)), hn::Abs(half));
        };
        magnitude = hn::Add(hn::Add(term(c[0], x, mx), term(c[1], y, my)),
                            hn::Add(term(c[2], z, mz), hn::Abs(mw)));
    }
    F corner(int number) const {
        const F a = number & 1 ? hn::Add(center, x) : hn::Sub(center, x);
        const F b = number & 2 ? hn::Add(a, y) : hn::Sub(a, y);
        return number & 4 ? hn::Add(b, z) : hn::Sub(b, z);
    }
};

/// Loads up to a vector of boxes; one alone is spread without a detour over memory.
HWY_INLINE void loadBoxes(const OcclusionBox* boxes, size_t count, F* center, F* half) {
    const Floats d;
    HWY_ALIGN float values[6][kMaxLanes] = {};
    for (size_t i = 0; i < count && count > 1; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            values[axis][i] = boxes[i].center[axis];
            values[3 + axis][i] = boxes[i].halfExtent[axis];
        }
    for (int axis = 0; axis < 3; ++axis) {
        center[axis] = count == 1 ? hn::Set(d, boxes[0].center[axis]) : hn::Load(d, values[axis]);
        half[axis] = count == 1 ? hn::Set(d, boxes[0].halfExtent[axis])
                                : hn::Load(d, values[3 + axis]);
    }
}

HWY_INLINE void projectBoxes(const DepthTiles& tiles, const mat4& m, const F* c, const F* h,
                             BoxProjection& out) {
    const Floats d;
    const ClipRow rx(m, 0, c, h), ry(m, 1, c, h), rz(m, 2, c, h), rw(m, 3, c, h);
    const F huge = hn::Set(d, 1e30f);
    F minX = huge, minY = huge, minZ = huge, minW = huge;
    F maxX = hn::Neg(huge), maxY = maxX, maxZ = maxX;
    for (int corner = 0; corner < 8; ++corner) {
        const F z = rz.corner(corner), w = rw.corner(corner);
        const F inverse = hn::Div(hn::Set(d, 1.0f), w);
        const F x = hn::Mul(rx.corner(corner), inverse), y = hn::Mul(ry.corner(corner), inverse);
        const F depth = hn::Mul(z, inverse);
        minX = hn::Min(minX, x);
        maxX = hn::Max(maxX, x);
        minY = hn::Min(minY, y);
        maxY = hn::Max(maxY, y);
        minZ = hn::Min(minZ, depth);
        maxZ = hn::Max(maxZ, depth);
        minW = hn::Min(minW, w);
    }
    const F error = hn::Set(d, kTransformError);
    const F errorW = hn::Mul(error, rw.magnitude), errorZ = hn::Mul(error, rz.magnitude);
    // A box in front of the eye; one that crosses the near plane has a depth above 1 and is nearer
    // than everything. Written as what holds for a box that is surely there, so that a NaN is
    // unsure.
    auto sure = hn::Gt(minW, hn::Mul(errorW, hn::Set(d, 8.0f)));
    const F inverseW = hn::Div(hn::Set(d, 1.0f), minW);

    const auto side = [&](F low, F high, F magnitude, uint32_t size, int32_t* first,
                          int32_t* last) {
        const F halfSize = hn::Set(d, 0.5f * float(size)), end = hn::Set(d, float(size));
        const F wrong = hn::Mul(hn::Add(hn::Mul(error, magnitude), errorW), inverseW);
        const F margin = hn::Add(hn::Set(d, 1.5f), hn::Mul(wrong, halfSize));
        const F a = hn::Sub(hn::Add(hn::Mul(low, halfSize), halfSize), margin);
        const F b = hn::Add(hn::Add(hn::Mul(high, halfSize), halfSize),
                            hn::Sub(margin, hn::Set(d, 1.0f)));
        sure = hn::And(sure, hn::Le(a, b));
        hn::Store(hn::ConvertTo(Ints(), hn::Min(hn::Max(hn::Ceil(a), hn::Zero(d)), end)), Ints(),
                  first);
        hn::Store(hn::ConvertTo(Ints(), hn::Min(hn::Max(hn::Floor(b), hn::Set(d, -1.0f)),
                                                hn::Sub(end, hn::Set(d, 1.0f)))),
                  Ints(), last);
    };
    side(minX, maxX, rx.magnitude, tiles.width, out.left, out.right);
    side(minY, maxY, ry.magnitude, tiles.height, out.bottom, out.top);

    // A GPU interpolates depth in float: a sixteenth of the box's range on top.
    const F relative = hn::Add(hn::Mul(errorW, inverseW), hn::Set(d, 1 + kPixelError));
    F depth = hn::Add(maxZ, hn::Mul(hn::Sub(maxZ, minZ), hn::Set(d, 1 / 16.0f)));
    depth = hn::Add(hn::Mul(depth, relative), hn::Mul(errorZ, inverseW));
    sure = hn::And(sure, hn::Lt(depth, huge));
    hn::Store(depth, d, out.depth);
    hn::Store(hn::IfThenElseZero(hn::RebindMask(Ints(), hn::Not(sure)), hn::Set(Ints(), 1)), Ints(),
              out.unsure);
}

void TestBoxes(const DepthTiles& tiles, const mat4& clipFromWorld,
               std::span<const OcclusionBox> boxes, uint8_t* visible) {
    BoxProjection projection;
    const size_t lanes = hn::Lanes(Floats());
    for (size_t begin = 0; begin < boxes.size(); begin += lanes) {
        const size_t count = std::min(lanes, boxes.size() - begin);
        F center[3], half[3];
        loadBoxes(&boxes[begin], count, center, half);
        projectBoxes(tiles, clipFromWorld, center, half, projection);
        for (size_t i = 0; i < count; ++i) {
            const BoxQuery query{projection.left[i], projection.right[i], projection.bottom[i],
                                 projection.top[i], projection.depth[i]};
            visible[begin + i] = projection.unsure[i] ||
                                 (query.left <= query.right && query.bottom <= query.top &&
                                  showsThrough(tiles, query));
        }
    }
}

}  // namespace rushlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {

HWY_EXPORT(TestBoxes);

void testBoxes(const DepthTiles& tiles, const mat4& clipFromWorld,
               std::span<const OcclusionBox> boxes, uint8_t* visible) {
    HWY_DYNAMIC_DISPATCH(TestBoxes)(tiles, clipFromWorld, boxes, visible);
}

}  // namespace rushlight
#endif
