#pragma once

#include <cstdint>

namespace rushlight {

/// How often this process has called operator new so far, on any thread.
uint64_t allocationCount();

}  // namespace rushlight
