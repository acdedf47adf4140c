#pragma once
// Which objects each view of a frame draws, and in which level of detail: one walk over the worlds'
// hierarchies for all views, then the objects of the blocks that were found, on all threads.

#include "renderer/visibility/detail.h"
#include "renderer/visibility/lod_memory.h"
#include "renderer/visibility/occlusion_culling.h"
#include "renderer/visibility/shadow_cascades.h"

namespace rushlight {

class Visibility {
public:
    struct Inputs {
        FrameWorlds worlds;  ///< prepared
        const GeometryStore* geometry = nullptr;
        const CameraMatrices* camera = nullptr;
        uint32_t targetWidth = 0, targetHeight = 0;  ///< pixels
        const FrameSettings* settings = nullptr;
        const ShadowCascades* cascades = nullptr;
        LodMemory* lods = nullptr;  ///< the camera's; what it is shown now is staged
    };
    /// Lists of the camera and the cascades, sorted.
    struct Lists {
        DrawList opaque, blended, movingEmission;
        std::array<DrawList, 4> casters;
        std::array<DrawList, 4> glass;  ///< casters that colour light and do not hide it
    };
    struct Counts {
        uint32_t visible = 0;  ///< to the camera
        uint32_t culledSmall = 0;
        uint32_t culledOcclusion = 0;
    };

    /// The same lists for any number of threads.
    Counts gather(const Inputs& inputs, JobSystem& jobs, Lists& lists);
    void noteChanges(std::span<const MeshHandle> meshes) { occlusion_.noteChanges(meshes); }

private:
    // Lists in the order of their items in a chunk.
    enum ListIndex : uint32_t {
        kOpaque,
        kBlended,
        kFirstCaster,
        kFirstGlass = kFirstCaster + 4,
        kListCount = kFirstGlass + 4
    };
    static DrawList& listOf(Lists& lists, uint32_t index);

    /// What a run of blocks gives; each is filled by one thread.
    struct Chunk {
        std::array<std::vector<VisibleItem>, kListCount> items;
        std::vector<LodMemory::Change> lods;
        uint32_t culledSmall = 0;
    };
    struct BlockVisit {
        SpatialIndex::Visit visit;
        uint8_t world;
        uint8_t index;
    };
    void makeVolumes(const Inputs&);
    void findBlocks(const Inputs&);
    void testBlock(const Inputs&, const BlockVisit&, Chunk&) const;
    void addToCamera(const Inputs&, uint32_t object, const InstanceRecord&, Chunk&) const;
    void addToCascade(const Inputs&, uint32_t cascade, uint32_t object, const InstanceRecord&,
                      Chunk&) const;
    void collect(uint32_t list, std::vector<VisibleItem>& items) const;

    std::vector<CullVolume> volumes_;  ///< the camera's, then the cascades'
    DetailScale cameraScale_;
    std::array<DetailScale, 4> cascadeScales_;
    std::vector<SpatialIndex::Visit> visits_;
    std::vector<BlockVisit> blocks_;
    OcclusionCulling occlusion_;
    std::vector<Chunk> chunks_;
    uint32_t chunkCount_ = 0;
};

}  // namespace rushlight
