#include "renderer/visibility/occlusion_culling.h"

#include "renderer/materials/surface_variant.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kFewestItems = 16;        // with fewer there is hardly anything to be hidden
constexpr uint32_t kTriangleBudget = 2048;   // about half a millisecond on one thread
constexpr float kSmallestOccluder = 0.005f;  // of the target's area
constexpr float kMarkedArea = 1e12f;         // before all that are not marked
constexpr uint32_t kBoxesPerJob = 256;

}  // namespace

void OcclusionCulling::addOccluders(const Inputs& in, std::span<const VisibleItem> opaque) {
    const float smallest = kSmallestOccluder * float(in.width) * float(in.height);
    candidates_.assign(opaque.size(), {});
    for (size_t i = 0; i < opaque.size(); ++i) {
        const VisibleItem& item = opaque[i];
        if (item.flags & kAlphaMask) continue;
        const InstanceRecord& r = in.worlds.record(item.object);
        const float pixels = r.radius * in.scale.at(r.center(), r.radius);
        const float area = kPi * pixels * pixels;
        const bool marked = r.instanceFlags & kInstanceOccluder;
        if (r.instanceFlags & kInstanceNoOccluder || (area < smallest && !marked)) continue;
        const CpuMesh* mesh = in.geometry->cpuMesh(r.mesh);
        if (!mesh || item.lod < mesh->firstLod) continue;
        // What fills the screen many times over is not worth as much more.
        candidates_[i] = {marked ? kMarkedArea : std::min(area, float(in.width) * float(in.height)),
                          mesh->lods[item.lod].indexCount / 3};
    }
    pickOccluders(candidates_, kTriangleBudget, picked_);
    for (uint32_t i : picked_) {
        const InstanceRecord& r = in.worlds.record(opaque[i].object);
        const OccluderMesh* mesh = occluders_.get(r.mesh, opaque[i].lod, *in.geometry);
        if (!mesh) continue;
        buffer_.addOccluder({mesh, r.worldFromLocal, bool(opaque[i].flags & kDoubleSided)});
        ++occluderCount_;
    }
}

uint32_t OcclusionCulling::removeHidden(const Inputs& in, JobSystem& jobs,
                                        std::vector<VisibleItem>& items) {
    boxes_.resize(items.size());
    visible_.resize(items.size());
    jobs.forRanges(uint32_t(items.size()), kBoxesPerJob, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            in.worlds.prefetch(items, i);
            const Aabb& box = in.worlds.record(items[i].object).box;
            boxes_[i] = {box.center(), box.halfExtent()};
        }
        buffer_.test(std::span(boxes_).subspan(begin, end - begin), &visible_[begin]);
    });
    uint32_t kept = 0;
    for (size_t i = 0; i < items.size(); ++i)
        if (visible_[i]) items[kept++] = items[i];
    const uint32_t removed = uint32_t(items.size()) - kept;
    items.resize(kept);
    return removed;
}

uint32_t OcclusionCulling::cull(const Inputs& in, JobSystem& jobs, std::vector<VisibleItem>& opaque,
                                std::vector<VisibleItem>& blended) {
    if (opaque.size() + blended.size() < kFewestItems) return 0;
    occluderCount_ = 0;
    buffer_.begin(in.width, in.height, in.camera->clipFromWorld);
    addOccluders(in, opaque);
    if (occluderCount_ == 0) return 0;
    buffer_.rasterize(jobs);
    return removeHidden(in, jobs, opaque) + removeHidden(in, jobs, blended);
}

}  // namespace rushlight
