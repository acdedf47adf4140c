// Surfaces of walls and roofs: ashlar, brick, plaster, tiles.

#include "content/generator/noise.h"
#include "content/generator/surface.h"

namespace rushlight::content {
namespace {

/// One block of a wall laid in courses; lengths in the unit of the tile (1 = the whole texture).
struct Block {
    uint32_t id = 0;
    float edge = 0;  ///< distance to the nearest side of the block
};

/// `columns` blocks to a course whose joints move by up to `jitter` of a block; odd courses are
/// shifted by half.
Block layCourses(float u, float v, int columns, int rows, float jitter, uint32_t seed) {
    const float y = v * float(rows);
    const int row = int(std::floor(y));
    const uint32_t course = uint32_t(((row % rows) + rows) % rows);
    const float x = u * float(columns) + (course % 2 ? 0.5f : 0.0f);
    const auto joint = [&](int i) {
        const auto wrapped = uint32_t(((i % columns) + columns) % columns);
        return float(i) + jitter * (unit(wrapped, course, seed) - 0.5f);
    };
    int i = int(std::floor(x));
    if (x < joint(i)) --i;
    if (x >= joint(i + 1)) ++i;
    const float side = std::fmin(x - joint(i), joint(i + 1) - x) / float(columns);
    const float fy = y - float(row);
    const float level = std::fmin(fy, 1 - fy) / float(rows);
    const auto wrapped = uint32_t(((i % columns) + columns) % columns);
    return {hash3(wrapped, course, seed + 3), std::fmin(side, level)};
}

}  // namespace

SurfaceSpec ashlarSurface() {
    const auto texel = [](float u, float v) {
        const float wobble = 0.0022f * (fractalNoise(u, v, 12, 12, 2, 101) - 0.5f);
        const Block block = layCourses(u + wobble, v + wobble, 3, 5, 0.45f, 102);
        const float grain = fractalNoise(u, v, 48, 48, 4, 103);
        const float pits = smooth(0.66f, 0.76f, fractalNoise(u, v, 60, 40, 2, 104));
        const float stain = fractalNoise(u, v, 3, 4, 4, 105);
        const float face = smooth(0.0015f, 0.0085f, block.edge);

        Texel t;
        t.height = 0.012f * face + 0.004f * face * unit(block.id, 1) + 0.0022f * grain -
                   0.003f * pits * face;
        vec3 stone = mix(vec3(0.62f, 0.56f, 0.46f), vec3(0.56f, 0.54f, 0.50f), unit(block.id, 2));
        stone *= 0.86f + 0.20f * unit(block.id, 3);
        stone *= 0.86f + 0.22f * stain + 0.12f * (grain - 0.5f);
        stone *= 1 - 0.12f * pits;
        t.color = mix(vec3(0.42f, 0.385f, 0.33f) * (0.8f + 0.3f * grain), stone, face);
        t.roughness = mixf(0.95f, 0.74f + 0.14f * stain, face);
        return t;
    };
    return {"ashlar", 512, 2.0f, 0.8f, false, texel};
}

SurfaceSpec stoneSurface() {
    const auto texel = [](float u, float v) {
        const float grain = fractalNoise(u, v, 40, 40, 4, 106);
        const float pits = smooth(0.68f, 0.78f, fractalNoise(u, v, 44, 36, 2, 107));
        const float bed = fractalNoise(u, v, 3, 9, 4, 108);
        const float stain = fractalNoise(u, v, 2, 3, 4, 109);
        Texel t;
        t.height = 0.0024f * grain - 0.0024f * pits + 0.002f * bed;
        t.color = mix(vec3(0.66f, 0.61f, 0.52f), vec3(0.57f, 0.55f, 0.51f), bed) *
                  (0.82f + 0.28f * stain + 0.14f * (grain - 0.5f)) * (1 - 0.11f * pits);
        t.roughness = 0.66f + 0.16f * grain + 0.12f * pits;
        return t;
    };
    return {"stone", 512, 1.5f, 0.8f, false, texel};
}

SurfaceSpec brickSurface() {
    const auto texel = [](float u, float v) {
        const float wobble = 0.003f * (fractalNoise(u, v, 20, 20, 2, 111) - 0.5f);
        const Block brick = layCourses(u + wobble, v + wobble, 6, 20, 0.08f, 112);
        const float grain = fractalNoise(u, v, 64, 64, 3, 113);
        const float stain = fractalNoise(u, v, 3, 3, 4, 114);
        const float face = smooth(0.0028f, 0.0065f, brick.edge);

        Texel t;
        t.height = 0.008f * face + 0.003f * face * unit(brick.id, 1) + 0.0022f * grain;
        const vec3 red(0.53f, 0.27f, 0.19f), brown(0.42f, 0.245f, 0.19f), pale(0.62f, 0.40f, 0.28f);
        vec3 clay = mix(red, brown, unit(brick.id, 2));
        clay = mix(clay, pale, smooth(0.75f, 1, unit(brick.id, 3)));
        clay *= 0.82f + 0.22f * unit(brick.id, 4) + 0.2f * (grain - 0.5f);
        const vec3 mortar = vec3(0.53f, 0.49f, 0.43f) * (0.8f + 0.3f * grain);
        t.color = mix(mortar, clay, face) * (0.84f + 0.26f * stain);
        t.roughness = mixf(0.95f, 0.8f, face);
        return t;
    };
    return {"brick", 512, 1.5f, 0.8f, false, texel};
}

SurfaceSpec plasterSurface() {
    const auto texel = [](float u, float v) {
        const float trowel = fractalNoise(u, v, 7, 5, 3, 121);
        const float grain = fractalNoise(u, v, 90, 90, 2, 122);
        const float stain = fractalNoise(u, v, 3, 2, 4, 123);
        const float streak = fractalNoise(u, v, 24, 2, 3, 124);
        const float ridge = std::fabs(fractalNoise(u, v, 4, 4, 4, 125) - 0.5f);
        const float crack = 1 - smooth(0.0f, 0.006f, ridge);
        const float fine = crack * smooth(0.5f, 0.6f, stain);

        Texel t;
        t.height = 0.010f * trowel + 0.0013f * grain - 0.003f * fine;
        const float light = 0.86f + 0.10f * (trowel - 0.5f) + 0.05f * (grain - 0.5f) -
                            0.16f * smooth(0.45f, 0.75f, stain) -
                            0.07f * smooth(0.5f, 0.8f, streak);
        t.color = light * mix(vec3(1.0f, 0.985f, 0.955f), vec3(0.95f, 0.90f, 0.82f), stain);
        t.color *= 1 - 0.35f * fine;
        t.roughness = 0.84f + 0.1f * grain;
        return t;
    };
    return {"plaster", 512, 2.5f, 0.7f, false, texel};
}

SurfaceSpec roofTileSurface() {
    const auto texel = [](float u, float v) {
        constexpr int kColumns = 8, kRows = 6;
        const float y = v * kRows;
        const int row = int(std::floor(y));
        const float along = y - float(row);  // 0 at the upper end of a tile, 1 at its lower lip
        const auto at = [&](float shift) { return u * kColumns + shift; };
        const float drift = 0.10f * (unit(uint32_t(row), 131) - 0.5f);
        const float x = at(drift);
        const int column = int(std::floor(x));
        const float across = 2 * (x - float(column)) - 1;
        const uint32_t id = hash3(uint32_t(((column % kColumns) + kColumns) % kColumns),
                                  uint32_t(row), 132);
        const float grain = fractalNoise(u, v, 64, 64, 3, 133);
        const float stain = fractalNoise(u, v, 3, 3, 4, 134);
        const float lichen = smooth(0.60f, 0.70f, fractalNoise(u, v, 14, 14, 4, 135));

        // A convex tile over the middle, a channel between two of them.
        const float wide = 0.70f + 0.05f * along;
        const float cover = std::fabs(across) < wide
                                ? std::sqrt(1 - across * across / (wide * wide))
                                : 0.0f;
        Texel t;
        t.height = 0.045f * cover + 0.016f * along + 0.006f * unit(id, 1) * cover +
                   0.0018f * grain - 0.012f * smooth(0.94f, 1.0f, along);
        vec3 clay = mix(vec3(0.58f, 0.31f, 0.205f), vec3(0.46f, 0.27f, 0.20f), unit(id, 2));
        clay = mix(clay, vec3(0.66f, 0.45f, 0.31f), smooth(0.8f, 1, unit(id, 3)));
        clay *= 0.80f + 0.24f * unit(id, 4) + 0.18f * (grain - 0.5f);
        clay = mix(clay, vec3(0.46f, 0.45f, 0.36f), 0.55f * lichen);
        t.color = clay * (0.80f + 0.30f * stain) * (0.62f + 0.38f * smooth(0, 0.45f, cover));
        t.roughness = 0.78f + 0.12f * stain;
        return t;
    };
    return {"rooftile", 512, 2.0f, 0.45f, false, texel};
}

}  // namespace rushlight::content
