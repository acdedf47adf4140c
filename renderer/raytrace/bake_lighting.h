#pragma once

#include "renderer/lighting/light_patterns.h"

#include <cstdint>
#include <span>

namespace rushlight {

/// What shines into a baked scene. Spans are read while a BakeLight is made.
struct BakeLighting {
    std::span<const DirectionalLight> directional = {};
    std::span<const PunctualLight> punctual = {};
    std::span<const AreaLight> area = {};
    const LightPatternSet* patterns = nullptr;  ///< of those; must outlive the BakeLight; null:
                                                ///< none has any
    EnvironmentDesc environment = {};           ///< no pixels: the hemisphere below
    float environmentRotation = 0;
    float environmentIntensity = 1;
    vec3 ambientSky{0}, ambientGround{0};  ///< as in Lighting
};

/// Tells lightings apart that give other light.
uint64_t hashOf(const BakeLighting& lighting);

}  // namespace rushlight
