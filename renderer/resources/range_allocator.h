#pragma once

#include <cstdint>
#include <vector>

namespace rushlight {

/// First-fit allocation of ranges in a growing address space; freed neighbours merge.
class RangeAllocator {
public:
    uint32_t allocate(uint32_t count) {
        for (size_t i = 0; i < free_.size(); ++i) {
            Range& range = free_[i];
            if (range.count < count) continue;
            const uint32_t first = range.first;
            range.first += count;
            range.count -= count;
            if (range.count == 0) free_.erase(free_.begin() + std::ptrdiff_t(i));
            return first;
        }
        const uint32_t first = end_;
        end_ += count;
        return first;
    }

    void release(uint32_t first, uint32_t count) {
        size_t at = 0;
        while (at < free_.size() && free_[at].first < first) ++at;
        free_.insert(free_.begin() + std::ptrdiff_t(at), {first, count});
        mergeWithNext(at);
        if (at > 0) mergeWithNext(at - 1);
    }

    uint32_t end() const { return end_; }  ///< one past the highest address ever handed out

private:
    struct Range {
        uint32_t first, count;
    };
    void mergeWithNext(size_t i) {
        if (i + 1 >= free_.size() || free_[i].first + free_[i].count != free_[i + 1].first) return;
        free_[i].count += free_[i + 1].count;
        free_.erase(free_.begin() + std::ptrdiff_t(i) + 1);
    }

    std::vector<Range> free_;
    uint32_t end_ = 0;
};

}  // namespace rushlight
