#pragma once
// A driver of which some functions are a test's own.

#include "tests/support/gl/test_context.h"

#include <span>
#include <string_view>

namespace rushlight {

struct ReplacedGl {
    template <class F>
    ReplacedGl(std::string_view glName, F* own)
        : name(glName), function(reinterpret_cast<void*>(own)) {}

    std::string_view name;
    void* function;
};

/// The test's where there is one, else the driver's.
inline void* loadReplaced(std::span<const ReplacedGl> replaced, const char* name) {
    for (const ReplacedGl& one : replaced)
        if (one.name == name) return one.function;
    return TestContext::load(name);
}

}  // namespace rushlight
