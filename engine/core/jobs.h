#pragma once

#include <cstdint>
#include <type_traits>

namespace rushlight {

/// The job interface: a host may pass its own; `SerialJobs` is the default, `engine/jobs` has
/// oneTBB's. The libraries never start a thread themselves.
class JobSystem {
public:
    using RangeFunction = void (*)(void* context, uint32_t begin, uint32_t end);

    virtual ~JobSystem() = default;

    /// Calls `function` on disjoint ranges that cover [0, count), each at most `grain` long and
    /// each beginning at a multiple of `grain`; returns when all are done. Ranges may run at the
    /// same time.
    virtual void parallelFor(uint32_t count, uint32_t grain, RangeFunction function,
                             void* context) = 0;

    /// How many ranges can run at the same time; at least 1.
    virtual uint32_t concurrency() const = 0;

    /// `body(begin, end)`; no allocation is made for the closure.
    template <class Body>
    void forRanges(uint32_t count, uint32_t grain, Body&& body) {
        using Plain = std::remove_reference_t<Body>;
        parallelFor(
            count, grain,
            [](void* context, uint32_t begin, uint32_t end) {
                (*static_cast<Plain*>(context))(begin, end);
            },
            const_cast<std::remove_const_t<Plain>*>(&body));
    }
};

/// Runs everything on the calling thread.
class SerialJobs final : public JobSystem {
public:
    void parallelFor(uint32_t count, uint32_t grain, RangeFunction function,
                     void* context) override {
        for (uint32_t begin = 0; begin < count; begin += grain)
            function(context, begin, begin + grain < count ? begin + grain : count);
    }
    uint32_t concurrency() const override { return 1; }
};

}  // namespace rushlight
