#pragma once
// What `--hashes` printed, of two builds or two machines: where a frame begins to differ.

#include "engine/core/result.h"

#include <string>

namespace rushlight::tool {

/// Prints the first image that differs, with the pass that wrote it, and how many do; true where
/// all are equal. Frames are compared pass by pass: where one has a pass that the other has not,
/// that is the first difference. An Error where a file cannot be read or is no such list.
Result<bool> compareHashLists(const std::string& a, const std::string& b);

}  // namespace rushlight::tool
