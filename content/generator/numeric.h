#pragma once
// Arithmetic that gives the same bits on every machine: only + - * / sqrt and floor of IEEE
// doubles, which the standard rounds exactly. Angles are in turns (1 = 360 degrees).

#include "engine/core/math.h"

#include <cmath>
#include <cstdint>

namespace rushlight::content {

/// Sine of an angle in turns; the Taylor series on a quarter turn, error below 1e-11.
double sinTurns(double turns);
inline double cosTurns(double turns) { return sinTurns(turns + 0.25); }

/// The direction (sin, 0, cos) of a yaw angle: 0 looks along +z, 0.25 along +x.
inline vec3 yawDirection(double turns) {
    return {float(sinTurns(turns)), 0, float(cosTurns(turns))};
}

/// A unit quaternion that turns around a unit axis.
quat rotationTurns(const vec3& axis, double turns);

/// A uniform 32-bit hash of three integers (the finaliser of MurmurHash3 over a multiply-add of
/// them).
uint32_t hash3(uint32_t a, uint32_t b, uint32_t c);

/// The hash as a number in [0, 1).
inline float unit(uint32_t a, uint32_t b = 0, uint32_t c = 0) {
    return float(hash3(a, b, c) >> 8) * (1.0f / 16777216.0f);
}

inline float saturate(float x) { return x < 0 ? 0.0f : x > 1 ? 1.0f : x; }
inline float mixf(float a, float b, float t) { return a + (b - a) * t; }
inline float smooth(float low, float high, float x) {
    const float t = saturate((x - low) / (high - low));
    return t * t * (3 - 2 * t);
}

/// A sequence of numbers that depends on its seed alone.
class Random {
public:
    explicit Random(uint32_t seed) : seed_(seed) {}
    float next() { return unit(seed_, count_++, 0x51ed27u); }
    float range(float low, float high) { return mixf(low, high, next()); }

private:
    uint32_t seed_;
    uint32_t count_ = 0;
};

}  // namespace rushlight::content
