#pragma once
// Takes from the camera's items those that opaque objects before them hide.

#include "renderer/visibility/detail.h"
#include "renderer/visibility/draw_list.h"
#include "renderer/visibility/occluder_store.h"
#include "renderer/visibility/occlusion/occlusion_buffer.h"
#include "renderer/visibility/occlusion/occlusion_pick.h"

namespace rushlight {

class OcclusionCulling {
public:
    struct Inputs {
        FrameWorlds worlds;
        const GeometryStore* geometry = nullptr;
        const CameraMatrices* camera = nullptr;
        DetailScale scale;
        uint32_t width = 0, height = 0;  ///< pixels of the target
    };

    /// `opaque` also gives the occluders. Returns how many items were taken out; the others keep
    /// their order.
    uint32_t cull(const Inputs& inputs, JobSystem& jobs, std::vector<VisibleItem>& opaque,
                  std::vector<VisibleItem>& blended);
    void noteChanges(std::span<const MeshHandle> meshes) { occluders_.noteChanges(meshes); }

private:
    void addOccluders(const Inputs& inputs, std::span<const VisibleItem> opaque);
    uint32_t removeHidden(const Inputs& inputs, JobSystem& jobs, std::vector<VisibleItem>& items);

    OccluderStore occluders_;
    OcclusionBuffer buffer_;
    std::vector<OccluderCandidate> candidates_;  ///< as the opaque items
    std::vector<uint32_t> picked_;
    std::vector<OcclusionBox> boxes_;
    std::vector<uint8_t> visible_;
    uint32_t occluderCount_ = 0;
};

}  // namespace rushlight
