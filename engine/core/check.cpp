#include "engine/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace rushlight {

void checkFailed(const char* file, int line, const char* condition, const char* reason) {
    std::fprintf(stderr, "rushlight: check failed: %s:%d: (%s): %s\n", file, line, condition,
                 reason);
    std::abort();
}

}  // namespace rushlight
