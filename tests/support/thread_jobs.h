#pragma once

#include "engine/core/jobs.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace rushlight {

/// As many threads as asked for, whatever the machine has, taking ranges from the last to the
/// first: what depends on the order or on which thread does what shows.
class ThreadJobs final : public JobSystem {
public:
    explicit ThreadJobs(uint32_t threads) : threads_(threads) {}
    uint32_t concurrency() const override { return threads_; }

    void parallelFor(uint32_t count, uint32_t grain, RangeFunction function,
                     void* context) override {
        std::atomic<uint32_t> left = (count + grain - 1) / grain;
        const auto work = [&] {
            for (uint32_t range = left.load(); range > 0;) {
                if (!left.compare_exchange_weak(range, range - 1)) continue;
                const uint32_t begin = (range - 1) * grain;
                function(context, begin, std::min(begin + grain, count));
                range = left.load();
            }
        };
        std::vector<std::thread> others;
        for (uint32_t i = 1; i < std::min(threads_, left.load()); ++i) others.emplace_back(work);
        work();
        for (std::thread& other : others) other.join();
    }

private:
    uint32_t threads_;
};

}  // namespace rushlight
