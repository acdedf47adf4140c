#include "renderer/rhi/half_floats.h"

#include "engine/core/check.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/rhi/half_floats.cpp"
#include <hwy/foreach_target.h>
// after foreach_target, by Highway's rules
#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace rushlight {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Words = hn::RebindToSigned<Floats>;
using Halves = hn::Rebind<uint16_t, Floats>;

// The last lanes go through memory that has room for them.
constexpr size_t kMostLanes = HWY_MAX_BYTES / sizeof(float);

// By integers rather than by the conversions of some processors, for the same bits on all. A half
// has 5 bits of exponent about 15 and 10 of mantissa, a float 8 about 127 and 23.
constexpr int kMantissaShift = 13;
constexpr int32_t kExponents = 112 << 23;                             // between their middles
constexpr int32_t kHalfSpecial = 0x7c00, kFloatSpecial = 0x7f800000;  // infinity; NaN from here on
constexpr int32_t kHalfNormal = 0x0400, kFloatNormal = 113 << 23;
constexpr float kHalfUnit = 0x1p-24f;  // a half below the normal ones counts these

template <class V>
auto promoted(const Floats floats, const Words words, V half) {
    const auto magnitude = hn::And(half, hn::Set(words, 0x7fff));
    const auto shifted = hn::ShiftLeft<kMantissaShift>(magnitude);
    const auto small = hn::Mul(hn::ConvertTo(floats, magnitude), hn::Set(floats, kHalfUnit));
    auto bits = hn::Add(shifted, hn::Set(words, kExponents));
    bits = hn::IfThenElse(hn::Lt(magnitude, hn::Set(words, kHalfNormal)), hn::BitCast(words, small),
                          bits);
    bits = hn::IfThenElse(hn::Gt(magnitude, hn::Set(words, kHalfSpecial - 1)),
                          hn::Or(shifted, hn::Set(words, kFloatSpecial)), bits);
    return hn::Or(bits, hn::ShiftLeft<16>(hn::AndNot(hn::Set(words, 0x7fff), half)));
}

// Where there is one that is equal.
template <class V>
auto demoted(const Floats floats, const Words words, V bits) {
    const auto magnitude = hn::And(bits, hn::Set(words, 0x7fffffff));
    const auto units = hn::Mul(hn::BitCast(floats, magnitude), hn::Set(floats, 1 / kHalfUnit));
    auto half = hn::ShiftRight<kMantissaShift>(hn::Sub(magnitude, hn::Set(words, kExponents)));
    half = hn::IfThenElse(hn::Lt(magnitude, hn::Set(words, kFloatNormal)),
                          hn::ConvertTo(words, units), half);
    const auto special = hn::Sub(magnitude,
                                 hn::Set(words, kFloatSpecial - (kHalfSpecial << kMantissaShift)));
    half = hn::IfThenElse(hn::Gt(magnitude, hn::Set(words, kFloatSpecial - 1)),
                          hn::ShiftRight<kMantissaShift>(special), half);
    half = hn::And(half, hn::Set(words, 0x7fff));  // what is too large is noticed by its bits
    return hn::Or(half, hn::And(hn::ShiftRight<16>(bits), hn::Set(words, 0x8000)));
}

void promote(const std::byte* from, float* to, size_t count) {
    const Floats floats;
    const Words words;
    const Halves halves;
    const size_t lanes = hn::Lanes(floats);
    const auto some = [&](const void* in, float* out) {
        const auto half = hn::LoadU(halves, static_cast<const uint16_t*>(in));
        hn::StoreU(hn::BitCast(floats, promoted(floats, words, hn::PromoteTo(words, half))), floats,
                   out);
    };
    size_t i = 0;
    for (; i + lanes <= count; i += lanes) some(from + i * 2, to + i);
    if (i == count) return;
    HWY_ALIGN uint16_t in[kMostLanes] = {};
    HWY_ALIGN float out[kMostLanes];
    std::memcpy(in, from + i * 2, (count - i) * 2);
    some(in, out);
    std::memcpy(to + i, out, (count - i) * sizeof(float));
}

bool demote(const float* from, uint16_t* to, size_t count) {
    const Floats floats;
    const Words words;
    const Halves halves;
    const size_t lanes = hn::Lanes(floats);
    const auto exact = [&](const float* in, uint16_t* out) {
        const auto bits = hn::BitCast(words, hn::LoadU(floats, in));
        const auto half = demoted(floats, words, bits);
        hn::StoreU(hn::DemoteTo(halves, half), halves, out);
        return hn::AllTrue(words, hn::Eq(bits, promoted(floats, words, half)));
    };
    size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        if (!exact(from + i, to + i)) return false;
    if (i == count) return true;
    HWY_ALIGN float in[kMostLanes] = {};
    HWY_ALIGN uint16_t out[kMostLanes];
    std::memcpy(in, from + i, (count - i) * sizeof(float));
    const bool last = exact(in, out);
    std::memcpy(to + i, out, (count - i) * 2);
    return last;
}

}  // namespace HWY_NAMESPACE
}  // namespace rushlight
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {

HWY_EXPORT(promote);
HWY_EXPORT(demote);

void floatsFromHalves(std::span<const std::byte> halves, std::span<float> floats) {
    RL_CHECK(halves.size() == floats.size() * 2, "a half has two bytes");
    RL_CHECK(reinterpret_cast<uintptr_t>(halves.data()) % 2 == 0, "halves are aligned");
    HWY_DYNAMIC_DISPATCH(promote)(halves.data(), floats.data(), floats.size());
}

bool exactHalves(std::span<const float> floats, std::span<uint16_t> halves) {
    RL_CHECK(halves.size() == floats.size(), "as many halves as floats");
    return HWY_DYNAMIC_DISPATCH(demote)(floats.data(), halves.data(), floats.size());
}

}  // namespace rushlight
#endif
