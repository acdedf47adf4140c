#pragma once

#include "renderer/rhi/saved/saved_frame.h"

#include <string>
#include <vector>

namespace rushlight {

/// What is different in `b`, a line each; nothing when the frames are equal. The first command that
/// differs, by number (from 1), name, pass and field; then the data block and the resources that
/// differ, by their labels.
std::vector<std::string> diffFrames(const SavedFrame& a, const SavedFrame& b);

}  // namespace rushlight
