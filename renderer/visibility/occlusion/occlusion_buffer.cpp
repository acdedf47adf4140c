#include "renderer/visibility/occlusion/occlusion_buffer.h"

#include "engine/core/check.h"
#include "engine/core/hash.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

template <class T>
void growTo(std::vector<T>& values, size_t size) {
    if (values.size() < size) values.resize(size);
}

}  // namespace

void OcclusionBuffer::begin(uint32_t width, uint32_t height, const mat4& clipFromWorld) {
    view_ = OcclusionView::make(clipFromWorld, width, height);
    occluders_.clear();
    usable_ = false;
    triangleCount_ = 0;
    tiles_ = {};
}

void OcclusionBuffer::rasterize(JobSystem& jobs) {
    const uint32_t width = view_.width, height = view_.height;
    if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide ||
        uint64_t(width) * height > kMaxPixels || occluders_.empty())
        return;
    makeRoom();
    jobs.forRanges(uint32_t(occluders_.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i)
            lists_[i] = setUpOccluder(view_, occluders_[i], memoryOf(slices_[i]));
    });
    for (const FillList& list : lists_) triangleCount_ += uint32_t(list.triangles.size());
    const uint32_t bands = (height + kBandRows - 1) / kBandRows;
    jobs.forRanges(bands, 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t band = begin; band < end; ++band) fillBand(tiles_, lists_, band);
    });
    usable_ = true;
}

void OcclusionBuffer::makeRoom() {
    tiles_.width = view_.width;
    tiles_.height = view_.height;
    tiles_.columns = (view_.width + kTileWidth - 1) / kTileWidth;
    tiles_.rows = (view_.height + kTileHeight - 1) / kTileHeight;
    tiles_.stride = uint32_t(paddedToLanes(tiles_.columns)) + kMaxLanes;
    const size_t tileCount = size_t(tiles_.rows) * tiles_.stride;
    growTo(depths_, 2 * tileCount);
    growTo(masks_, 2 * tileCount);
    tiles_.full = depths_.data();
    tiles_.partial = depths_.data() + tileCount;
    tiles_.mask = masks_.data();
    tiles_.cut = masks_.data() + tileCount;

    Slice end{};
    slices_.clear();
    for (const Occluder& occluder : occluders_) {
        RL_CHECK(occluder.mesh, "an occluder has a mesh");
        slices_.push_back(end);
        const OccluderRoom room = occluderRoom(*occluder.mesh);
        end.vertices += room.vertices;
        end.meshTriangles += room.meshTriangles;
        end.triangles += room.triangles;
        end.outline += room.outline;
    }
    growTo(vertices_, end.vertices);
    growTo(vertexErrors_, end.vertices);
    growTo(facings_, end.meshTriangles);
    growTo(triangles_, end.triangles);
    growTo(triangleRows_, end.triangles);
    growTo(sources_, end.triangles);
    growTo(outline_, end.outline);
    lists_.assign(occluders_.size(), FillList{});
}

SetupMemory OcclusionBuffer::memoryOf(const Slice& slice) {
    return {vertices_.data() + slice.vertices,      vertexErrors_.data() + slice.vertices,
            facings_.data() + slice.meshTriangles,  triangles_.data() + slice.triangles,
            triangleRows_.data() + slice.triangles, sources_.data() + slice.triangles,
            outline_.data() + slice.outline};
}

void OcclusionBuffer::test(std::span<const OcclusionBox> boxes, uint8_t* visible) const {
    if (!usable_) {
        std::fill_n(visible, boxes.size(), uint8_t(1));
        return;
    }
    testBoxes(tiles_, view_.clipFromWorld, boxes, visible);
}

bool OcclusionBuffer::isVisible(const vec3& center, const vec3& halfExtent) const {
    const OcclusionBox box{center, halfExtent};
    uint8_t visible = 1;
    test({&box, 1}, &visible);
    return visible != 0;
}

float OcclusionBuffer::depthAt(uint32_t x, uint32_t y) const {
    if (!usable_ || x >= tiles_.width || y >= tiles_.height) return 0;
    const size_t at = size_t(y / kTileHeight) * tiles_.stride + x / kTileWidth;
    const bool masked = tiles_.mask[at] >> (y % kTileHeight * kTileWidth + x % kTileWidth) & 1;
    return masked ? std::max(tiles_.full[at], tiles_.partial[at]) : tiles_.full[at];
}

uint64_t OcclusionBuffer::hash() const {
    uint64_t h = usable_;
    for (uint32_t row = 0; usable_ && row < tiles_.rows; ++row)
        for (uint32_t column = 0; column < tiles_.columns; ++column) {
            const size_t at = size_t(row) * tiles_.stride + column;
            h = mixBits(h ^ std::bit_cast<uint32_t>(tiles_.full[at]));
            // A layer that is behind is of no effect, and it depends on the vector length when it
            // is dropped.
            if (tiles_.mask[at] && tiles_.partial[at] > tiles_.full[at])
                h = mixBits(h ^ (uint64_t(std::bit_cast<uint32_t>(tiles_.partial[at])) << 32 |
                                 tiles_.mask[at]));
        }
    return h;
}

}  // namespace rushlight
