// Included once for each instruction set that the kernels are compiled for, hence the guard
// (Highway's quick reference, "Ops in headers").
#if defined(RUSHLIGHT_OCCLUSION_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RUSHLIGHT_OCCLUSION_LANES
#undef RUSHLIGHT_OCCLUSION_LANES
#else
#define RUSHLIGHT_OCCLUSION_LANES
#endif

#include "renderer/visibility/occlusion/occlusion_types.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rushlight::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kMaxLanes>;
using Ints = hn::RebindToSigned<Floats>;
using Masks = hn::RebindToUnsigned<Floats>;
using F = hn::Vec<Floats>;
using I = hn::Vec<Ints>;
using U = hn::Vec<Masks>;

/// Bits [first, last] of the eight columns that begin at `base`, in the lowest byte.
HWY_INLINE U columnBits(I base, int32_t first, int32_t last) {
    const Ints di;
    const I zero = hn::Zero(di), eight = hn::Set(di, int32_t(kTileWidth));
    const I low = hn::Min(hn::Max(hn::Sub(hn::Set(di, first), base), zero), eight);
    const I high = hn::Min(hn::Max(hn::Sub(hn::Set(di, last + 1), base), zero), eight);
    const U ones = hn::Set(Masks(), 0xffu);
    const U from = hn::Shl(ones, hn::BitCast(Masks(), low)),
            beyond = hn::Shl(ones, hn::BitCast(Masks(), high));
    return hn::And(hn::AndNot(beyond, from), ones);
}

}  // namespace rushlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
