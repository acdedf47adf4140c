#include "engine/jobs/tbb_jobs.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace rushlight {
namespace {

class TbbJobs final : public JobSystem {
public:
    explicit TbbJobs(uint32_t threads)
        : arena_(threads ? int(threads) : tbb::task_arena::automatic) {}

    void parallelFor(uint32_t count, uint32_t grain, RangeFunction function,
                     void* context) override {
        const uint32_t ranges = count / grain + (count % grain != 0);
        if (ranges <= 1 || concurrency() == 1) {
            SerialJobs().parallelFor(count, grain, function, context);
            return;
        }
        arena_.execute([&] {
            tbb::parallel_for(
                uint32_t(0), ranges,
                [&](uint32_t range) {
                    const uint32_t begin = range * grain;
                    const uint32_t end = count - begin > grain ? begin + grain : count;
                    function(context, begin, end);
                },
                tbb::simple_partitioner());
        });
    }

    uint32_t concurrency() const override { return uint32_t(arena_.max_concurrency()); }

private:
    tbb::task_arena arena_;
};

}  // namespace

std::unique_ptr<JobSystem> createTbbJobs(uint32_t threads) {
    return std::make_unique<TbbJobs>(threads);
}

}  // namespace rushlight
