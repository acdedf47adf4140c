#pragma once
// What a model says of the light around it, as the renderer takes it.

#include "engine/assets/model.h"
#include "renderer/renderer.h"

#include <vector>

namespace rushlight {

/// The texels, the irradiance and the rotation; the intensity is for
/// Lighting::environmentIntensity. The spans are the light's own.
PrefilteredEnvironmentDesc environmentOf(const assets::ImageBasedLight& light);

/// The same, sharp and turned, as an equirectangular picture of 4 * size x 2 * size texels at most
/// `maxWidth` wide: for baking, which traces rays to it.
std::vector<vec3> equirectOf(const assets::ImageBasedLight& light, uint32_t maxWidth, uvec2& size);

/// The probes of the nodes, without environments. A node that is scaled scales the box.
std::vector<ReflectionProbe> reflectionProbesOf(const assets::Model& model,
                                                const std::vector<int>& nodes,
                                                const std::vector<mat4>& world,
                                                std::vector<CaptureDesc>& captures,
                                                std::vector<std::string>& notes);

}  // namespace rushlight
