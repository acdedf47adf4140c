#pragma once
// Each light's share of the opaque surfaces' radiance, by frames in which it shines alone.

#include "renderer/answers/editable_frame.h"
#include "renderer/answers/explain.h"

namespace rushlight {

/// Adds a LightShare to every pixel that has a surface and that the light reaches, in the order of
/// brightness. `plain`: the frame with nothing over its opaque surfaces; the pixels' surfaces and
/// `emissive` are known.
Result<void> addLightShares(Shots& shots, const EditableFrame& plain,
                            std::span<PixelExplanation> pixels);

}  // namespace rushlight
