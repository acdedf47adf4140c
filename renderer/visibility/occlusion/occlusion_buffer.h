#pragma once
// What large objects hide, known on the CPU before anything is drawn: a small software z-buffer
// with the samples of the frame itself. After Hasselgren, Andersson and Akenine-Moeller, "Masked
// Software Occlusion Culling", HPG 2016, with tiles of 8x4 samples, a depth that all have and one
// that some have.
//
// It never says "hidden" of a box when a GPU would show a pixel of what is inside, provided that
// the triangles of the occluders are those that are drawn (same vertices, same transform, opaque
// and not cut by alpha), with one sample in the middle of each pixel and a grid of 1/256 pixel or
// finer; occlusion_setup.cpp has the reasons.

#include "engine/core/jobs.h"
#include "renderer/visibility/occlusion/occlusion_setup.h"

#include <span>
#include <vector>

namespace rushlight {

class OcclusionBuffer {
public:
    /// Tiles take 16 bytes for 32 pixels; a larger target has no occlusion, and everything is
    /// visible.
    static constexpr uint64_t kMaxPixels = uint64_t(1) << 26;
    static constexpr uint32_t kMaxSide = 16384;

    /// Forgets everything. Clip z is in [0, w] and reversed; the far plane may be infinite.
    void begin(uint32_t width, uint32_t height, const mat4& clipFromWorld);

    /// Near ones first hide the most. One that has no finite transform hides nothing.
    void addOccluder(const Occluder& occluder) { occluders_.push_back(occluder); }

    /// On all threads; the same bits for any number of them and for any instruction set.
    void rasterize(JobSystem& jobs);

    /// `visible[i]` becomes 0 for a box whose pixels are all hidden or that has none in the target,
    /// else 1. A box that crosses the near plane or is not finite is visible. From any number of
    /// threads after rasterize(). Many at once cost a fraction of as many alone.
    void test(std::span<const OcclusionBox> boxes, uint8_t* visible) const;
    bool isVisible(const vec3& center, const vec3& halfExtent) const;

    /// Everything farther is hidden at this pixel, rows from the bottom; 0 where nothing is known
    /// to hide.
    float depthAt(uint32_t x, uint32_t y) const;

    /// Triangles that were filled, after culling and clipping.
    uint32_t triangleCount() const { return triangleCount_; }
    /// Of all depth tiles, to compare two buffers.
    uint64_t hash() const;

private:
    struct Slice {
        size_t vertices, meshTriangles, triangles, outline;
    };
    void makeRoom();
    SetupMemory memoryOf(const Slice& slice);

    OcclusionView view_;
    DepthTiles tiles_;
    bool usable_ = false;  ///< rasterize() has run on a target that is not too large
    std::vector<Occluder> occluders_;
    std::vector<Slice> slices_;
    std::vector<FillList> lists_;
    std::vector<ScreenVertex> vertices_;
    std::vector<float> vertexErrors_;
    std::vector<uint8_t> facings_;
    std::vector<FillTriangle> triangles_;
    std::vector<RowRange> triangleRows_;
    std::vector<uint32_t> sources_;
    std::vector<OutlineEdge> outline_;
    std::vector<float> depths_;
    std::vector<uint32_t> masks_;
    uint32_t triangleCount_ = 0;
};

}  // namespace rushlight
