// Surfaces that lie on the ground: setts, gravel, water.

#include "content/generator/noise.h"
#include "content/generator/surface.h"

namespace rushlight::content {

SurfaceSpec cobbleSurface() {
    const auto texel = [](float u, float v) {
        // Rows of setts about 14 x 12 cm, pushed out of line a little.
        const float wu = u + 0.012f * (fractalNoise(u, v, 5, 5, 2, 11) - 0.5f);
        const float wv = v + 0.012f * (fractalNoise(u, v, 5, 5, 2, 12) - 0.5f);
        const CellHit cell = cellNoise(wu, wv, 14, 16, 0.34f, 21);
        const float grain = fractalNoise(u, v, 96, 96, 3, 31);
        const float patch = fractalNoise(u, v, 3, 3, 3, 41);
        const float stone = smooth(0.03f, 0.13f, cell.edge);
        const float dome = std::sqrt(saturate(cell.edge / 0.42f));
        const vec2 tilt(unit(cell.id, 1) - 0.5f, unit(cell.id, 2) - 0.5f);

        Texel t;
        const float top = 0.004f * unit(cell.id, 3) + 0.007f * dot(tilt, cell.offset) +
                          0.013f * dome + 0.0011f * grain;
        t.height = mixf(0.0016f * grain, top, stone);

        const float shade = 0.33f + 0.15f * unit(cell.id, 4) + 0.07f * (grain - 0.5f);
        const vec3 warm(1.06f, 0.99f, 0.90f), cool(0.94f, 0.99f, 1.05f);
        vec3 sett = shade * mix(warm, cool, unit(cell.id, 5));
        if (unit(cell.id, 6) > 0.9f)
            sett *= vec3(1.15f, 0.93f, 0.82f);  // a porphyry here and there
        sett *= 0.88f + 0.24f * patch;
        const vec3 earth = vec3(0.20f, 0.175f, 0.14f) * (0.8f + 0.4f * grain);
        const vec3 moss(0.20f, 0.23f, 0.10f);
        const vec3 joint = mix(earth, moss, smooth(0.52f, 0.68f, patch));
        t.color = mix(joint, sett, stone);
        const float polish = 0.36f + 0.16f * unit(cell.id, 7) + 0.25f * (grain - 0.5f);
        t.roughness = mixf(0.95f, polish + 0.2f * smooth(0.35f, 0.65f, patch), stone * dome);
        return t;
    };
    return {"cobble", 1024, 2.0f, 1.0f, false, texel};
}

SurfaceSpec gravelSurface() {
    const auto texel = [](float u, float v) {
        const CellHit pebble = cellNoise(u, v, 32, 32, 0.9f, 51);
        const CellHit big = cellNoise(u, v, 17, 17, 0.95f, 52);
        const float soil = fractalNoise(u, v, 6, 6, 5, 53);
        const bool isBig = unit(big.id, 1) > 0.72f && big.edge > 0.08f;
        const float lump = isBig ? std::sqrt(saturate(big.edge * 1.8f)) * 0.016f
                                 : std::sqrt(saturate(pebble.edge * 2)) * 0.006f;
        const uint32_t id = isBig ? big.id : pebble.id;
        Texel t;
        t.height = 0.012f * soil + lump;
        const vec3 stone = mix(vec3(0.46f, 0.41f, 0.34f), vec3(0.36f, 0.35f, 0.34f), unit(id, 2)) *
                           (0.7f + 0.5f * unit(id, 3));
        t.color = mix(vec3(0.27f, 0.215f, 0.155f), stone,
                      smooth(0.004f, 0.010f, lump + 0.006f * soil));
        t.roughness = 0.9f - 0.1f * unit(id, 4);
        return t;
    };
    return {"gravel", 256, 1.5f, 1.0f, false, texel};
}

SurfaceSpec waterSurface() {
    const auto texel = [](float u, float v) {
        Texel t;
        t.height = 0.020f * fractalNoise(u, v, 7, 7, 3, 61) +
                   0.012f * fractalNoise(v, u, 11, 11, 2, 62);
        t.color = vec3(0.75f, 0.85f, 0.85f);
        t.roughness = 0.04f;
        return t;
    };
    return {"water", 256, 1.5f, 0.2f, false, texel};
}

}  // namespace rushlight::content
