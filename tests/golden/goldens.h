#pragma once
// The golden pictures: what each shows and how far a frame may be from it.

#include "renderer/testing/verdict.h"

#include <span>

namespace rushlight {

struct Golden {
    const char* name;         ///< of the file in tests/golden/, without .png
    const char* scene;        ///< below content/
    const char* environment;  ///< below content/, or empty
    SceneView view;
};

std::span<const Golden> goldens();

Result<golden::Frame> renderGolden(const Golden& golden, golden::Offscreen& offscreen);

/// Limits of a frame that is the same. They leave room for another driver's rounding, and for
/// nothing that a fault in a shader changes (golden_gl_test seeds such faults).
golden::Near nearGolden(const Golden& golden);

}  // namespace rushlight
