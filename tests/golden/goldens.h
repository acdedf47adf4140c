#pragma once
// The golden pictures: what each shows and how far a frame may be from it.

#include "tests/support/scene_frames.h"

#include <span>

namespace rushlight {

struct Golden {
    const char* name;         ///< of the file in tests/golden/, without .png
    const char* scene;        ///< below content/
    const char* environment;  ///< below content/, or empty
    SceneView view;
};

std::span<const Golden> goldens();

/// Limits of a frame that is the same. They leave room for another driver's rounding, and for
/// nothing that a fault in a shader changes (golden_gl_test seeds such faults).
inline constexpr double kMaxFlip = 0.004;
inline constexpr double kMinPsnr = 47;  ///< dB

/// Renders one golden in a renderer of its own. `shaderDirectory` as in RendererDesc.
Result<CapturedImage> renderGolden(const Golden& golden, GlLoadFunction loadGl,
                                   const std::string& shaderDirectory = {});

std::string goldenPath(const Golden& golden);

}  // namespace rushlight
