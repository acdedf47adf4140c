#include "content/generator/noise.h"

namespace rushlight::content {
namespace {

int wrapCell(int cell, int count) { return ((cell % count) + count) % count; }

float corner(int x, int y, int cellsU, int cellsV, uint32_t seed) {
    return unit(uint32_t(wrapCell(x, cellsU)), uint32_t(wrapCell(y, cellsV)), seed);
}

/// 6t^5 - 15t^4 + 10t^3: the second derivative vanishes at both ends (Perlin, "Improving Noise",
/// 2002).
float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

float valueNoise(float u, float v, int cellsU, int cellsV, uint32_t seed) {
    const float x = u * float(cellsU), y = v * float(cellsV);
    const int cx = int(std::floor(x)), cy = int(std::floor(y));
    const float fx = fade(x - float(cx)), fy = fade(y - float(cy));
    const float low = mixf(corner(cx, cy, cellsU, cellsV, seed),
                           corner(cx + 1, cy, cellsU, cellsV, seed), fx);
    const float high = mixf(corner(cx, cy + 1, cellsU, cellsV, seed),
                            corner(cx + 1, cy + 1, cellsU, cellsV, seed), fx);
    return mixf(low, high, fy);
}

float fractalNoise(float u, float v, int cellsU, int cellsV, int octaves, uint32_t seed) {
    float sum = 0, weight = 1, total = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * valueNoise(u, v, cellsU << i, cellsV << i, seed + uint32_t(i) * 101u);
        total += weight;
        weight *= 0.5f;
    }
    return sum / total;
}

CellHit cellNoise(float u, float v, int cellsU, int cellsV, float jitter, uint32_t seed) {
    const float x = u * float(cellsU), y = v * float(cellsV);
    const int row = int(std::floor(y)), column = int(std::floor(x));
    vec2 best{0}, points[35];
    float nearest = 1e9f;
    int count = 0, winner = 0;
    CellHit hit;
    for (int j = row - 2; j <= row + 2; ++j)
        for (int i = column - 3; i <= column + 3; ++i) {
            const auto ci = uint32_t(wrapCell(i, cellsU)), cj = uint32_t(wrapCell(j, cellsV));
            const float shift = wrapCell(j, 2) ? 0.5f : 0.0f;
            const vec2 p(float(i) + 0.5f + shift + jitter * (unit(ci, cj, seed) - 0.5f),
                         float(j) + 0.5f + jitter * (unit(ci, cj, seed + 7) - 0.5f));
            points[count] = p - vec2(x, y);
            const float d = dot(points[count], points[count]);
            if (d < nearest) {
                nearest = d;
                winner = count;
                best = points[count];
                hit.id = hash3(ci, cj, seed + 13);
            }
            ++count;
        }
    // Distance to the bisector between the nearest point and each other one.
    hit.edge = 1e9f;
    for (int k = 0; k < count; ++k) {
        if (k == winner) continue;
        const vec2 between = points[k] - best;
        const float length = std::sqrt(dot(between, between));
        if (length > 1e-5f)
            hit.edge = std::fmin(hit.edge, dot(0.5f * (points[k] + best), between) / length);
    }
    hit.offset = -best;
    return hit;
}

}  // namespace rushlight::content
