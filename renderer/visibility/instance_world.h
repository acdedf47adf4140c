#pragma once
// Instances that are kept from frame to frame, resolved and spatially indexed, so that a frame
// costs what changed and what is seen. Both a host's retained worlds and the spans of FrameInput
// are held this way. Used by one thread at a time; prepare() spreads its work over the jobs.

#include "engine/core/jobs.h"
#include "renderer/frame/frame_input.h"
#include "renderer/resources/geometry_store.h"
#include "renderer/resources/material_store.h"
#include "renderer/visibility/spatial_index.h"

#include <span>
#include <vector>

namespace rushlight {

/// An instance as the frame builder sees it: two cache lines, looked up for what is seen.
struct alignas(64) InstanceRecord {
    mat4x3 worldFromLocal{1.0f};
    Aabb box;          ///< world space
    float radius = 0;  ///< metres, of the sphere around the box
    float scale = 1;   ///< the largest that the transform does to a length
    MeshHandle mesh;
    MaterialHandle material;
    uint32_t id = 0;
    uint32_t instanceFlags = 0;
    uint32_t previousTransform = 0;
    uint32_t materialTexel = 0;
    uint32_t stamp = 0;         ///< another one whenever what is drawn changed
    uint32_t surfaceFlags = 0;  ///< of surface_variant.h
    uint16_t textureSet = 0;
    bool valid = false;  ///< false: left out, see FrameReport::rejected

    vec3 center() const { return box.center(); }
};
static_assert(sizeof(InstanceRecord) == 128);

/// A move by InstanceWorld::set(), for views that did not see it yet.
struct InstanceMove {
    uint32_t slot = 0;
    bool arrived = false;  ///< the slot has another instance since, which came from nowhere
    mat4x3 from{1.0f};
};

class InstanceWorld {
public:
    /// Makes the world hold these and nothing else; equal ones cost a comparison.
    void assign(std::span<const Instance> instances, JobSystem& jobs);

    // By slot, for worlds that the host keeps. Moves are noted for the views (ViewMotion):
    // kInstanceMoving and Instance::previousTransform are not looked at.
    uint32_t add(const Instance& instance);
    void set(uint32_t slot, const Instance& instance);
    void remove(uint32_t slot);
    uint32_t slotCount() const { return uint32_t(records_.size()); }

    /// Moves since the world was made.
    uint64_t moveCount() const { return forgottenMoves_ + moves_.size(); }
    /// The moves after the first `count`, in order; none where those are not kept any more.
    std::span<const InstanceMove> movesSince(uint64_t count) const;
    /// No view asks for those before this number any more.
    void forgetMoves(uint64_t before);

    /// Instances of these have to be resolved again.
    void noteChanges(std::span<const MeshHandle> meshes, std::span<const MaterialHandle> materials);

    /// Brings records and indices up to date. `givenPrevious`: the previous transforms of instances
    /// that assign() set.
    void prepare(const GeometryStore& geometry, const MaterialStore& materials,
                 std::span<const mat4x3> givenPrevious, JobSystem& jobs);

    // After prepare(), until the next change; from any thread.

    const InstanceRecord& record(uint32_t slot) const { return records_[slot]; }
    InstanceRecord& record(uint32_t slot) { return records_[slot]; }
    /// Asks the processor to fetch a record that is used soon.
    void prefetch(uint32_t slot) const {
        __builtin_prefetch(&records_[slot]);
        __builtin_prefetch(reinterpret_cast<const char*>(&records_[slot]) + 64);
    }
    /// Of what assign() set with kInstanceMoving.
    const mat4x3& previousTransform(const InstanceRecord& record) const {
        return previous_[record.previousTransform];
    }
    /// f(slot, record) of all that it holds, rejected ones too.
    template <class F>
    void forEach(F&& f) const {
        for (uint32_t slot = 0; slot < records_.size(); ++slot)
            if (alive_[slot]) f(slot, records_[slot]);
    }
    std::span<const SpatialIndex> indices() const { return indices_; }
    /// Another number whenever anything in that index changed: what it holds, where it is or how it
    /// is drawn.
    uint64_t version(uint32_t index) const { return versions_[index]; }
    uint32_t count() const { return count_; }
    uint32_t rejected() const {
        return count_ - indices_[kStillIndex].size() - indices_[kMovingIndex].size();
    }
    Aabb bounds() const;  ///< of all that are not rejected
    /// Every combination of surface flags, kClosedMesh and kCasts that an object has or had.
    std::span<const uint32_t> variants() const { return variants_; }
    uint64_t bytes() const;  ///< memory held

private:
    // Objects that have moved lie in an index of their own: it is refitted and built again as often
    // as it needs, the other, larger one almost never.
    enum Index : uint32_t { kStillIndex, kMovingIndex };
    static constexpr uint32_t kNowhere = ~0u;
    static constexpr uint32_t kArriving = ~0u - 1;  ///< into the index that is being built
    static constexpr uint32_t kMovingBit = 1u << 31;

    struct Change {
        uint32_t slot;
        bool boxChanged;
    };
    void resize(uint32_t slots);
    void mark(uint32_t slot);
    void copyFields(InstanceRecord& record, const Instance& instance);
    void noteMove(const InstanceMove& move);
    bool resolve(InstanceRecord& record, const GeometryStore&, const MaterialStore&) const;
    void place();
    void rebuild(Index index);
    void noteVariant(const InstanceRecord& record);

    std::vector<InstanceRecord> records_;
    std::vector<uint32_t> meshes_, materials_;  ///< handle indices by slot, to be searched quickly
    std::vector<uint32_t> places_;   ///< by slot: position in an index, kMovingBit: which
    std::vector<uint8_t> changing_;  ///< by slot: is in changes_
    std::vector<uint8_t> alive_;     ///< by slot
    std::vector<uint32_t> free_;
    std::vector<Change> changes_;
    std::vector<uint32_t> fresh_, movers_;
    std::vector<uint32_t> variants_;
    std::vector<InstanceMove> moves_;
    uint64_t forgottenMoves_ = 0;
    std::span<const mat4x3> previous_;  ///< of what assign() set, until prepare() is called again
    std::vector<SpatialIndex::Object> objects_;
    std::array<SpatialIndex, 2> indices_;
    std::array<uint64_t, 2> versions_{};
    uint32_t count_ = 0;
    uint32_t lastStamp_ = 0;
    size_t lastPreviousCount_ = 0;
};

}  // namespace rushlight
