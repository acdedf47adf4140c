#include "sandbox/tool/progress.h"

#include <unistd.h>

#include <cstdio>

namespace rushlight::tool {

Progress::Progress(const char* what) : what_(what), onTerminal_(isatty(STDERR_FILENO)) {}

void Progress::show(uint64_t done, uint64_t count, uint64_t free) const {
    if (!onTerminal_) return;
    std::fprintf(stderr, "\r%s %llu of %llu", what_, static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(count));
    if (done > free) {
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        const auto left = unsigned(seconds / double(done - free) * double(count - done) + 0.5);
        std::fprintf(stderr, ", %u:%02u left ", left / 60, left % 60);
    }
    if (done == count) std::fputc('\n', stderr);
}

}  // namespace rushlight::tool
