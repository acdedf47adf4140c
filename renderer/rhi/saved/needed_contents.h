#pragma once

#include "renderer/rhi/commands/command_buffer.h"

#include <map>
#include <vector>

namespace rushlight {

/// For every texture that the commands name, which of its images (mipLevel * layers + layer) need
/// what they held before: those that the commands sample, keep or copy before a pass clears or
/// discards them.
std::map<TextureHandle, std::vector<bool>> neededContents(const CommandBuffer& commands,
                                                          const ResourceLookup& resources);

}  // namespace rushlight
