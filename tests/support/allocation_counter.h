#pragma once

#include <cstdint>

namespace rushlight {

/// Calls of operator new on this thread since it began. Linking allocation_counter.cpp replaces the
/// global operators.
uint64_t allocationsOnThisThread();

}  // namespace rushlight
