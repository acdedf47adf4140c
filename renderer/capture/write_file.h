#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace rushlight {

/// Writes a whole file: under a temporary name beside it, then renamed, so that a full disk or an
/// interrupted run leaves what was there before. A symbolic link is followed; a device or a pipe is
/// written to directly. The folder is made when it does not exist.
Result<void> writeFile(const std::string& path, std::span<const std::byte> bytes);
Result<void> writeFile(const std::string& path, std::string_view text);

}  // namespace rushlight
