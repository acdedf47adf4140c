// Surfaces of things people made and grew: planks, metal, cloth, leaves, lit windows.

#include "content/generator/noise.h"
#include "content/generator/surface.h"

namespace rushlight::content {

SurfaceSpec plankSurface() {
    const auto texel = [](float u, float v) {
        constexpr int kPlanks = 6;
        const float x = u * kPlanks;
        const auto plank = uint32_t(x);
        const float across = x - float(plank);
        const float edge = std::fmin(across, 1 - across) / kPlanks;
        const float shift = unit(plank, 141);
        // Grain runs along v: noise stretched twenty times, bent by a slow wave.
        const float bend = 0.035f * (fractalNoise(u, v + shift, 6, 2, 2, 142) - 0.5f);
        const float rings = fractalNoise(u + bend, v + shift, 48, 2, 4, 143);
        const float fibre = fractalNoise(u + bend, v, 110, 6, 2, 144);
        const float stain = fractalNoise(u, v, 4, 3, 3, 145);
        const float face = smooth(0.001f, 0.007f, edge);
        Texel t;
        t.height = 0.006f * face + 0.0022f * rings * face + 0.0011f * fibre +
                   0.003f * unit(plank, 146) * face;
        vec3 wood = mix(vec3(0.36f, 0.245f, 0.155f), vec3(0.55f, 0.40f, 0.265f), rings);
        wood *= 0.82f + 0.25f * unit(plank, 147) + 0.16f * (fibre - 0.5f);
        wood *= 0.86f + 0.25f * stain;
        t.color = mix(vec3(0.10f, 0.075f, 0.055f), wood, face);
        t.roughness = 0.62f + 0.22f * fibre + 0.1f * stain;
        return t;
    };
    return {"plank", 512, 1.0f, 0.8f, false, texel};
}

SurfaceSpec metalSurface() {
    const auto texel = [](float u, float v) {
        const CellHit dent = cellNoise(u, v, 12, 12, 0.9f, 151);
        const float grain = fractalNoise(u, v, 40, 40, 3, 152);
        const float wear = fractalNoise(u, v, 5, 5, 4, 153);
        const float tarnish = smooth(0.50f, 0.72f, wear);
        Texel t;
        t.height = 0.0011f * saturate(dent.edge * 2) + 0.0006f * grain;
        t.color = mix(vec3(0.84f), vec3(0.60f, 0.58f, 0.55f), tarnish) *
                  (0.9f + 0.2f * (grain - 0.5f));
        t.roughness = 0.36f + 0.3f * tarnish + 0.12f * grain;
        t.metallic = 1 - 0.35f * tarnish;
        return t;
    };
    return {"metal", 512, 0.5f, 0.5f, false, texel};
}

SurfaceSpec clothSurface(const vec3& stripe, const std::string& name) {
    const auto texel = [stripe](float u, float v) {
        constexpr int kThreads = 64;
        const float a = float(sinTurns(u * kThreads)), b = float(sinTurns(v * kThreads));
        const bool over = (int(u * kThreads) + int(v * kThreads)) % 2 == 0;
        const float weave = over ? a * a : b * b;
        const float fold = fractalNoise(u, v, 4, 2, 3, 161);
        const float dirt = fractalNoise(u, v, 5, 4, 4, 162);
        const float band = u * 4 - std::floor(u * 4);
        const float inStripe = smooth(0.06f, 0.08f, band) * (1 - smooth(0.50f, 0.52f, band));
        Texel t;
        t.height = 0.0009f * weave + 0.012f * fold;
        t.color = mix(vec3(0.86f, 0.81f, 0.70f), stripe, inStripe) *
                  (0.86f + 0.08f * weave + 0.22f * (dirt - 0.5f));
        t.roughness = 0.88f;
        return t;
    };
    return {name, 512, 1.0f, 0.6f, false, texel};
}

SurfaceSpec leafSurface() {
    // Leaves lie over each other on a card: each a pointed oval with a rib, the later ones in
    // front.
    const auto texel = [](float u, float v) {
        constexpr uint32_t kLeaves = 170;
        Texel t;
        t.alpha = 0;
        t.color = vec3(0.17f, 0.22f, 0.09f);
        t.roughness = 0.62f;
        for (uint32_t i = 0; i < kLeaves; ++i) {
            const double angle = double(unit(i, 171));
            const float reach = 0.42f * std::sqrt(unit(i, 172));
            const float cx = 0.5f + reach * float(sinTurns(angle));
            const float cy = 0.5f + reach * float(cosTurns(angle));
            const double turn = angle + 0.28 * (double(unit(i, 173)) - 0.5);
            const float s = float(sinTurns(turn)), c = float(cosTurns(turn));
            const float half = 0.056f + 0.032f * unit(i, 174);
            const float along = ((u - cx) * s + (v - cy) * c) / half;
            const float across = ((u - cx) * c - (v - cy) * s) / half;
            if (along < -1 || along > 1) continue;
            const float outline = 0.50f * (1 - along * along) * (1 - 0.30f * along);
            const float inside = outline - std::fabs(across);
            if (inside <= 0) continue;
            const float depth = float(i) / kLeaves;
            const float rib = 1 - smooth(0.015f, 0.055f, std::fabs(across));
            const float veins = smooth(0.6f, 0.95f,
                                       float(sinTurns(double(along * 3 - std::fabs(across) * 3))));
            t.alpha = smooth(0, 0.04f, inside);
            t.height = 0.012f * depth + half * 0.16f * (outline - across * across) - 0.0016f * rib;
            const vec3 dark(0.19f, 0.29f, 0.10f), fresh(0.36f, 0.46f, 0.17f),
                dry(0.50f, 0.45f, 0.18f);
            vec3 leaf = mix(dark, fresh, unit(i, 175));
            if (unit(i, 176) > 0.93f) leaf = dry;
            t.color = leaf * (0.55f + 0.45f * depth) * (1 + 0.22f * rib - 0.08f * veins);
        }
        return t;
    };
    return {"leaf", 512, 0.8f, 0.4f, true, texel};
}

SurfaceSpec windowSurface() {
    // The room behind a lit window: a lamp's glow, curtains at both sides, the dark of the sill.
    const auto texel = [](float u, float v) {
        const float side = 2 * std::fabs(u - 0.5f);
        const float drape = smooth(0.52f, 0.62f, side + 0.16f * (v - 0.5f) * (v - 0.5f));
        const float folds = 0.65f + 0.35f * float(sinTurns(double(u) * 11 + 0.3 * double(v)));
        const float dx = u - 0.56f, dy = v - 0.40f;
        const float glow = 1 / (1 + 9 * (dx * dx + dy * dy));
        const float room = 0.85f + 0.3f * (fractalNoise(u, v, 4, 4, 3, 181) - 0.5f);
        Texel t;
        t.color = mix(vec3(1.0f, 0.80f, 0.50f) * glow * room,
                      vec3(0.74f, 0.42f, 0.22f) * folds * (0.55f + 0.45f * glow), drape);
        t.color *= 1 - 0.5f * smooth(0.86f, 1.0f, v);
        return t;
    };
    return {"window", 256, 1.0f, 0.0f, false, texel};
}

}  // namespace rushlight::content
