#pragma once

#include "engine/core/check.h"

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace rushlight {

/// A typed generational name of an object in a Pool. Zero is "none".
///
///     31        20 19                  0
///     [generation ][       index       ]   generation starts at 1, so no live handle is zero
template <class Tag>
struct Handle {
    static constexpr uint32_t kIndexBits = 20;
    static constexpr uint32_t kMaxIndex = (1u << kIndexBits) - 1;
    static constexpr uint32_t kMaxGeneration = (1u << (32 - kIndexBits)) - 1;

    uint32_t value = 0;

    static Handle make(uint32_t index, uint32_t generation) {
        return {generation << kIndexBits | index};
    }
    uint32_t index() const { return value & kMaxIndex; }
    uint32_t generation() const { return value >> kIndexBits; }
    explicit operator bool() const { return value != 0; }
    auto operator<=>(const Handle&) const = default;
};

/// Slots of T addressed by Handle<Tag>; a stale handle is recognised. Not thread-safe.
template <class T, class Tag>
class Pool {
public:
    using HandleType = Handle<Tag>;

    HandleType insert(T object) {
        uint32_t index;
        if (free_.empty()) {
            index = uint32_t(slots_.size());
            RL_CHECK(index <= HandleType::kMaxIndex, "a pool holds at most 1,048,576 objects");
            slots_.push_back({});
        } else {
            index = free_.back();
            free_.pop_back();
        }
        Slot& slot = slots_[index];
        slot.object = std::move(object);
        slot.live = true;
        return HandleType::make(index, slot.generation);
    }

    /// Null when the handle is none, stale or foreign.
    T* find(HandleType handle) {
        if (!handle || handle.index() >= slots_.size()) return nullptr;
        Slot& slot = slots_[handle.index()];
        return slot.live && slot.generation == handle.generation() ? &slot.object : nullptr;
    }
    const T* find(HandleType handle) const { return const_cast<Pool*>(this)->find(handle); }

    /// Of an object that is looked up soon.
    void prefetch(HandleType handle) const {
        if (handle.index() >= slots_.size()) return;
        const char* bytes = reinterpret_cast<const char*>(&slots_[handle.index()]);
        for (std::size_t offset = 0; offset < sizeof(Slot); offset += 64)
            __builtin_prefetch(bytes + offset);
    }

    bool erase(HandleType handle) {
        if (!find(handle)) return false;
        Slot& slot = slots_[handle.index()];
        slot.object = T{};
        slot.live = false;
        slot.generation = slot.generation == HandleType::kMaxGeneration ? 1 : slot.generation + 1;
        free_.push_back(handle.index());
        return true;
    }

    uint32_t slotCount() const { return uint32_t(slots_.size()); }
    uint32_t liveCount() const { return uint32_t(slots_.size() - free_.size()); }

    template <class F>
    void forEach(F&& f) {
        for (uint32_t i = 0; i < slots_.size(); ++i)
            if (slots_[i].live) f(HandleType::make(i, slots_[i].generation), slots_[i].object);
    }

private:
    struct Slot {
        T object{};
        uint32_t generation = 1;
        bool live = false;
    };
    std::vector<Slot> slots_;
    std::vector<uint32_t> free_;
};

}  // namespace rushlight
