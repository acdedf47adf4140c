#pragma once

#include "sandbox/viewer/viewer.h"

#include <optional>

namespace rushlight {

struct SandboxOptions {
    ViewerOptions viewer;
    bool allLit = false;
};

/// The command line; or nothing and the exit code (0 after --help, 2 for wrong usage).
std::optional<SandboxOptions> parseOptions(int argc, char** argv, int& exitCode);

}  // namespace rushlight
