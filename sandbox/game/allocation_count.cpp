// Counts what the program asks of the heap, for the panel's "allocations" line. Replaces the global
// operators as [new.delete] allows; the sized and array forms of the library call these.

#include "sandbox/game/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<uint64_t> count{0};
}

namespace rushlight {
uint64_t allocationCount() { return count.load(std::memory_order_relaxed); }
}  // namespace rushlight

// The address sanitizer brings its own operators, nothrow forms included, which must not be mixed with these.
#if !defined(__SANITIZE_ADDRESS__)
void* operator new(std::size_t size) {
    count.fetch_add(1, std::memory_order_relaxed);
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
