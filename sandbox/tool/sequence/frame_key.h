#pragma once

#include "sandbox/tool/options.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace rushlight::tool {

/// A short text that differs where a frame of `command` could: of its options but those of the
/// names in `without`, the contents of the files that the scene is made of, not where they lie, and
/// the version of the program.
std::string frameKey(const CLI::App& command, const RenderOptions& options,
                     std::initializer_list<std::string_view> without);

}  // namespace rushlight::tool
