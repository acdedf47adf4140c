#include "renderer/visibility/instance_world.h"

#include "renderer/materials/surface_variant.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kInstancesPerJob = 512;
constexpr uint32_t kComparisonsPerJob = 4096;

bool isFinite(const mat4x3& m) {
    const vec3 sum = m[0] + m[1] + m[2] + m[3];
    return std::isfinite(sum.x + sum.y + sum.z);
}

bool isFinite(const Aabb& box) {
    const vec3 sum = box.low + box.high;
    return std::isfinite(sum.x + sum.y + sum.z);
}

// Bit by bit: NaN equals itself, 0 and -0 differ.
bool sameTransform(const mat4x3& a, const mat4x3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool differs(const InstanceRecord& record, const Instance& instance) {
    return !sameTransform(record.worldFromLocal, instance.worldFromLocal) ||
           record.mesh != instance.mesh || record.material != instance.material ||
           record.id != instance.id || record.instanceFlags != instance.flags ||
           record.previousTransform != instance.previousTransform;
}

float largestScale(const mat4x3& m) {
    const float squared = std::max(
        {glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2])});
    return std::sqrt(squared);
}

/// Which handle indices are in a list, as bits.
class HandleSet {
public:
    template <class Handle>
    explicit HandleSet(std::span<const Handle> handles) {
        for (Handle handle : handles) {
            if (bits_.size() <= handle.index()) bits_.resize(handle.index() + 1);
            bits_[handle.index()] = true;
        }
    }
    bool has(uint32_t index) const { return index < bits_.size() && bits_[index]; }

private:
    std::vector<bool> bits_;
};

}  // namespace

void InstanceWorld::resize(uint32_t slots) {
    records_.resize(slots);
    meshes_.resize(slots);
    materials_.resize(slots);
    places_.resize(slots, kNowhere);
    changing_.resize(slots, 0);
    alive_.resize(slots, 0);
}

void InstanceWorld::mark(uint32_t slot) {
    if (changing_[slot]) return;
    changing_[slot] = 1;
    changes_.push_back({slot, false});
}

void InstanceWorld::copyFields(InstanceRecord& record, const Instance& instance) {
    record.worldFromLocal = instance.worldFromLocal;
    record.mesh = instance.mesh;
    record.material = instance.material;
    record.id = instance.id;
    record.instanceFlags = instance.flags;
    record.previousTransform = instance.previousTransform;
}

void InstanceWorld::assign(std::span<const Instance> instances, JobSystem& jobs) {
    const uint32_t count = uint32_t(instances.size());
    for (uint32_t slot = count; slot < count_; ++slot) {
        alive_[slot] = 0;
        mark(slot);
    }
    if (records_.size() < count) resize(count);
    const uint32_t known = std::min(count, count_);
    count_ = count;
    constexpr uint8_t kDiffers = 2;
    jobs.forRanges(count, kComparisonsPerJob, [&](uint32_t begin, uint32_t end) {
        for (uint32_t slot = begin; slot < end; ++slot) {
            if (slot < known && !differs(records_[slot], instances[slot])) continue;
            copyFields(records_[slot], instances[slot]);
            meshes_[slot] = instances[slot].mesh.index();
            materials_[slot] = instances[slot].material.index();
            alive_[slot] = 1;
            changing_[slot] |= kDiffers;
        }
    });
    for (uint32_t slot = 0; slot < count; ++slot)
        if (changing_[slot] & kDiffers) {
            changing_[slot] &= uint8_t(~kDiffers);
            mark(slot);
        }
}

uint32_t InstanceWorld::add(const Instance& instance) {
    uint32_t slot = uint32_t(records_.size());
    if (free_.empty()) {
        resize(slot + 1);
    } else {
        slot = free_.back();
        free_.pop_back();
        noteMove({slot, true, mat4x3(1.0f)});
    }
    ++count_;
    alive_[slot] = 1;
    copyFields(records_[slot], instance);
    records_[slot].instanceFlags &= ~uint32_t(kInstanceMoving);
    meshes_[slot] = instance.mesh.index();
    materials_[slot] = instance.material.index();
    mark(slot);
    return slot;
}

void InstanceWorld::set(uint32_t slot, const Instance& instance) {
    InstanceRecord& record = records_[slot];
    if (!sameTransform(record.worldFromLocal, instance.worldFromLocal))
        noteMove({slot, false, record.worldFromLocal});
    copyFields(record, instance);
    record.instanceFlags &= ~uint32_t(kInstanceMoving);
    meshes_[slot] = instance.mesh.index();
    materials_[slot] = instance.material.index();
    mark(slot);
}

// A view that is not rendered any more may not make the list grow without end: one that misses so
// many moves finds everything standing.
void InstanceWorld::noteMove(const InstanceMove& move) {
    const size_t most = 4096 + 4 * records_.size();
    if (moves_.size() >= most) forgetMoves(forgottenMoves_ + moves_.size() / 2);
    moves_.push_back(move);
}

std::span<const InstanceMove> InstanceWorld::movesSince(uint64_t count) const {
    if (count < forgottenMoves_ || count > moveCount()) return {};
    return std::span(moves_).subspan(size_t(count - forgottenMoves_));
}

void InstanceWorld::forgetMoves(uint64_t before) {
    const uint64_t end = std::min(before, moveCount());
    if (end <= forgottenMoves_) return;
    moves_.erase(moves_.begin(), moves_.begin() + std::ptrdiff_t(end - forgottenMoves_));
    forgottenMoves_ = end;
}

void InstanceWorld::remove(uint32_t slot) {
    --count_;
    alive_[slot] = 0;
    free_.push_back(slot);
    mark(slot);
}

void InstanceWorld::noteChanges(std::span<const MeshHandle> meshes,
                                std::span<const MaterialHandle> materials) {
    if (!meshes.empty()) {
        const HandleSet changed(meshes);
        for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
            if (alive_[slot] && changed.has(meshes_[slot])) mark(slot);
    }
    if (!materials.empty()) {
        const HandleSet changed(materials);
        for (uint32_t slot = 0; slot < materials_.size(); ++slot)
            if (alive_[slot] && changed.has(materials_[slot])) mark(slot);
    }
}

// Answers whether the box is another than before.
bool InstanceWorld::resolve(InstanceRecord& record, const GeometryStore& geometry,
                            const MaterialStore& materials) const {
    record.valid = false;
    const GpuMesh* mesh = geometry.find(record.mesh);
    const GpuMaterial* material = materials.find(record.material);
    const bool moving = record.instanceFlags & kInstanceMoving;
    if (!mesh || !material || !isFinite(record.worldFromLocal)) return true;
    if (moving && record.previousTransform >= previous_.size()) return true;
    const Aabb box = transformAabb(record.worldFromLocal, mesh->bounds);
    if (!isFinite(box)) return true;

    record.valid = true;
    const bool changed = std::memcmp(&box, &record.box, sizeof box) != 0;
    record.box = box;
    record.radius = glm::length(box.halfExtent());
    record.scale = largestScale(record.worldFromLocal);
    record.materialTexel = material->texel;
    record.textureSet = uint16_t(material->textureSet);
    uint32_t flags = material->surfaceFlags;
    if (mesh->extended)
        flags |= kExtended;
    else
        flags &= ~uint32_t(kSecondUv);
    if (!mesh->hasTangents) flags &= ~uint32_t(kNormalTexture);
    if (glm::determinant(mat3(record.worldFromLocal)) < 0) flags |= kMirrored;
    if (moving) flags |= kMoving;
    if (mesh->closed) flags |= kClosedMesh;
    if (record.instanceFlags & kInstanceCastsShadow) flags |= kCasts;
    record.surfaceFlags = flags;
    return changed;
}

void InstanceWorld::prepare(const GeometryStore& geometry, const MaterialStore& materials,
                            std::span<const mat4x3> givenPrevious, JobSystem& jobs) {
    previous_ = givenPrevious;
    // An index that was good may be none now, and the reverse.
    if (previous_.size() != lastPreviousCount_)
        for (uint32_t slot = 0; slot < records_.size(); ++slot)
            if (alive_[slot] && records_[slot].instanceFlags & kInstanceMoving) mark(slot);
    lastPreviousCount_ = previous_.size();
    if (changes_.empty()) return;

    const uint32_t firstStamp = lastStamp_ + 1;
    lastStamp_ += uint32_t(changes_.size());
    jobs.forRanges(uint32_t(changes_.size()), kInstancesPerJob, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            Change& change = changes_[i];
            InstanceRecord& record = records_[change.slot];
            record.stamp = firstStamp + i;
            if (alive_[change.slot])
                change.boxChanged = resolve(record, geometry, materials);
            else
                record.valid = false;
            const uint32_t at = places_[change.slot];
            if (record.valid && change.boxChanged && at != kNowhere && at & kMovingBit)
                indices_[kMovingIndex].setBox(at & ~kMovingBit, record.box);
        }
    });
    place();
}

void InstanceWorld::place() {
    fresh_.clear();
    movers_.clear();
    for (const Change& change : changes_) {
        uint32_t& at = places_[change.slot];
        changing_[change.slot] = 0;
        const bool valid = records_[change.slot].valid;
        if (valid) noteVariant(records_[change.slot]);
        if (at == kNowhere) {
            if (valid) fresh_.push_back(change.slot);
            continue;
        }
        const bool inMoving = at & kMovingBit;
        ++versions_[inMoving];
        if (valid && (inMoving || !change.boxChanged)) continue;
        indices_[inMoving].remove(at & ~kMovingBit);
        at = kNowhere;
        if (valid) movers_.push_back(change.slot);
    }
    changes_.clear();

    // Few newcomers join what moves; many are worth building the large index again.
    SpatialIndex& still = indices_[kStillIndex];
    const bool many = fresh_.size() > 16 + still.size() / 4;
    if (many) ++versions_[kStillIndex];
    if (many || still.positionCount() > 256 + 2 * still.size()) {
        for (uint32_t slot : fresh_) places_[slot] = kArriving;
        rebuild(kStillIndex);
    } else {
        movers_.insert(movers_.end(), fresh_.begin(), fresh_.end());
        still.refit();
    }
    SpatialIndex& moving = indices_[kMovingIndex];
    if (!movers_.empty()) ++versions_[kMovingIndex];
    for (uint32_t slot : movers_)
        places_[slot] = moving.append({slot, records_[slot].box}) | kMovingBit;
    moving.refit();
    if (moving.isWorn() || moving.positionCount() > 256 + 2 * moving.size()) rebuild(kMovingIndex);
}

void InstanceWorld::noteVariant(const InstanceRecord& record) {
    if (std::ranges::find(variants_, record.surfaceFlags) == variants_.end())
        variants_.push_back(record.surfaceFlags);
}

void InstanceWorld::rebuild(Index which) {
    SpatialIndex& index = indices_[which];
    objects_.clear();  // by slot, whatever happened before: what is drawn must not depend on
                       // history
    for (uint32_t slot = 0; slot < places_.size(); ++slot) {
        const uint32_t at = places_[slot];
        if (at == kNowhere) continue;
        const bool arrives = at == kArriving;
        if (arrives ? which == kStillIndex : bool(at & kMovingBit) == (which == kMovingIndex))
            objects_.push_back({slot, records_[slot].box});
    }
    index.build(objects_);
    for (uint32_t position = 0; position < index.size(); ++position)
        places_[index.slotAt(position)] = position | (which == kMovingIndex ? kMovingBit : 0);
}

Aabb InstanceWorld::bounds() const {
    Aabb all;
    for (const SpatialIndex& index : indices_)
        if (const Aabb box = index.bounds(); !box.isEmpty()) all.grow(box);
    return all;
}

uint64_t InstanceWorld::bytes() const {
    const auto held = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return held(records_) + held(meshes_) + held(materials_) + held(places_) + held(changing_) +
           held(alive_) + held(free_) + held(changes_) + held(fresh_) + held(movers_) +
           held(moves_) + held(objects_) + indices_[0].bytes() + indices_[1].bytes();
}

}  // namespace rushlight
