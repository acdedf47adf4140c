#pragma once

#include "renderer/context/context.h"

#include <string>

namespace rushlight {

/// Empty when the current context is OpenGL 4.5 or later, else a sentence with the version that it
/// has.
std::string versionProblem(GlLoader);

/// Fills the strings and `missing` from the current context.
void describeContext(GlLoader, ContextAttempt&);

}  // namespace rushlight
