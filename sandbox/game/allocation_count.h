#pragma once

#include <cstdint>

namespace rushlight {

/// Heap allocations of this process so far, by operator new.
uint64_t allocationCount();

}  // namespace rushlight
