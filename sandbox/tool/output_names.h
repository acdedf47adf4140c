#pragma once

#include "engine/core/result.h"

#include <cstdint>
#include <string>

namespace rushlight::tool {

/// The name of one frame of a sequence: `pattern` with its %d, %4d or %04d replaced.
/// ErrorKind::wrongUse when there is not exactly one; %% stands for a per cent sign.
Result<std::string> frameFileName(const std::string& pattern, uint32_t frame);

}  // namespace rushlight::tool
