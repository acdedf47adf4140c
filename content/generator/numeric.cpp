#include "content/generator/numeric.h"

namespace rushlight::content {

double sinTurns(double turns) {
    double t = turns - std::floor(turns + 0.5);
    if (t > 0.25) t = 0.5 - t;
    if (t < -0.25) t = -0.5 - t;
    const double x = t * 6.283185307179586;
    const double s = x * x;
    double sum = 1;
    for (int n = 16; n >= 2; n -= 2) sum = 1 - sum * s / double(n * (n + 1));
    return x * sum;
}

quat rotationTurns(const vec3& axis, double turns) {
    const float s = float(sinTurns(turns * 0.5));
    return {float(cosTurns(turns * 0.5)), axis.x * s, axis.y * s, axis.z * s};
}

uint32_t hash3(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t h = a * 0x9e3779b1u + b * 0x85ebca77u + c * 0xc2b2ae3du + 0x27d4eb2fu;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
    return h;
}

}  // namespace rushlight::content
