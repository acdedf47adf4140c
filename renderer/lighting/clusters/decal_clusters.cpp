#include "renderer/lighting/clusters/decal_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rushlight {
namespace {

bool isFinite(const mat4x3& m) {
    float sum = 0;
    for (int c = 0; c < 4; ++c) sum += glm::dot(m[c], m[c]);
    return std::isfinite(sum);
}

/// Whether a decal can be drawn, and how.
bool toGpu(const Decal& decal, const DecalStore& store, const vec3& camera, GpuDecal& gpu) {
    const uint32_t* layer = store.find(decal.material);
    const mat3 axes(decal.worldFromDecal);
    const float volume = glm::determinant(axes);
    const float size = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
    if (!layer || !isFinite(decal.worldFromDecal) || !(std::abs(volume) > 1e-6f * size))
        return false;
    const mat3 inverse = glm::inverse(axes);
    const vec3 offset = inverse * (camera - decal.worldFromDecal[3]);
    for (int row = 0; row < 3; ++row)
        gpu.rows[row] = {inverse[0][row], inverse[1][row], inverse[2][row], offset[row]};
    gpu.baseColor = decal.baseColor;
    gpu.layer = float(*layer);
    gpu.roughness = decal.roughness;
    gpu.metallic = decal.metallic;
    gpu.baseColorShare = std::clamp(decal.baseColorShare, 0.0f, 1.0f);
    gpu.normalShare = std::clamp(decal.normalShare, 0.0f, 1.0f);
    gpu.roughnessShare = std::clamp(decal.roughnessShare, 0.0f, 1.0f);
    // The picture spans two units of the box; the coarser of both axes decides, lest it flickers.
    gpu.texelsPerMetre = 0.5f * float(kDecalSide) *
                         std::max(glm::length(vec3(gpu.rows[0])), glm::length(vec3(gpu.rows[1])));
    return true;
}

}  // namespace

void DecalClusters::build(const CameraMatrices& camera, uint32_t width, uint32_t height,
                          std::span<const Decal> all, const DecalStore& store) {
    width_ = width;
    height_ = height;
    tilesX = (width + RL_DECAL_PIXELS - 1) / RL_DECAL_PIXELS;
    tilesY = (height + RL_DECAL_PIXELS - 1) / RL_DECAL_PIXELS;
    decals.clear();
    boxes_.clear();
    references_.clear();
    for (const Decal& decal : all) {
        GpuDecal gpu;
        if (!toGpu(decal, store, camera.position, gpu)) continue;
        const mat4x3& m = decal.worldFromDecal;
        const vec3 half = glm::abs(m[0]) + glm::abs(m[1]) + glm::abs(m[2]);
        if (!intersects(camera.frustum, m[3], half)) continue;
        const vec3 to = m[3] - camera.position;
        const auto along = [&](const vec3& axis) {
            return std::abs(glm::dot(axis, m[0])) + std::abs(glm::dot(axis, m[1])) +
                   std::abs(glm::dot(axis, m[2]));
        };
        const vec3 center(glm::dot(to, camera.right), glm::dot(to, camera.up),
                          glm::dot(to, camera.forward));
        const vec3 extent(along(camera.right), along(camera.up), along(camera.forward));
        decals.push_back(gpu);
        boxes_.push_back({center - extent, center + extent});
    }
    lists.assign(size_t(tilesX) * tilesY * kSlices, 0);
    if (decals.empty()) return;
    setSlices(camera);
    for (uint32_t i = 0; i < boxes_.size(); ++i) addReferences(camera, i, boxes_[i]);

    // Counting sort by froxel; within one, decals stay in order, and the last are left out where
    // there are too many.
    const uint32_t clusters = uint32_t(lists.size());
    for (const Reference& r : references_)
        if (lists[r.cluster] < kMaxPerCluster) ++lists[r.cluster];
    uint32_t first = clusters;
    for (uint32_t i = 0; i < clusters; ++i) {
        const uint32_t count = lists[i];
        lists[i] = first << 8;
        first += count;
    }
    lists.resize(first);
    for (const Reference& r : references_) {
        uint32_t& record = lists[r.cluster];
        const uint32_t count = record & 255, entry = (record >> 8) + count;
        if (count == kMaxPerCluster) continue;
        lists[entry] = r.decal;
        ++record;
    }
}

void DecalClusters::setSlices(const CameraMatrices& camera) {
    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    for (const Box& box : boxes_) {
        nearest = std::min(nearest, box.low.z);
        farthest = std::max(farthest, box.high.z);
    }
    nearest = std::max({nearest, camera.nearPlane, 0.01f});
    farthest = std::max(farthest, nearest * 1.01f);
    sliceScale = float(kSlices) / std::log2(farthest / nearest);
    sliceBias = -std::log2(nearest) * sliceScale;
    for (uint32_t s = 0; s <= kSlices; ++s)
        sliceEdges_[s] = nearest * std::pow(farthest / nearest, float(s) / kSlices);
    // What is nearer or farther falls into the first or the last.
    sliceEdges_[0] = std::min(camera.nearPlane, 0.0f);
    sliceEdges_[kSlices] = std::numeric_limits<float>::max();
}

void DecalClusters::addReferences(const CameraMatrices& camera, uint32_t decal, const Box& box) {
    const float scaleX = camera.perspective ? camera.tanHalfX : camera.halfWidth;
    const float scaleY = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    for (uint32_t s = 0; s < kSlices; ++s) {
        const float low = std::max(sliceEdges_[s], box.low.z);
        const float high = std::min(sliceEdges_[s + 1], box.high.z);
        if (low > high) continue;
        const float nearScale = camera.perspective ? std::max(low, camera.nearPlane) : 1;
        const float farScale = camera.perspective ? std::max(high, nearScale) : 1;
        const auto tiles = [&](float least, float most, float center, float scale, uint32_t pixels,
                               uint32_t count, uint32_t& begin, uint32_t& end) {
            const float a = (std::min(least / nearScale, least / farScale) - center) / scale;
            const float b = (std::max(most / nearScale, most / farScale) - center) / scale;
            const float perNdc = 0.5f * float(pixels) / RL_DECAL_PIXELS;
            begin = uint32_t(std::clamp(std::floor((a + 1) * perNdc), 0.0f, float(count)));
            end = uint32_t(std::clamp(std::floor((b + 1) * perNdc) + 1, 0.0f, float(count)));
        };
        uint32_t x0, x1, y0, y1;
        tiles(box.low.x, box.high.x, camera.center.x, scaleX, width_, tilesX, x0, x1);
        tiles(box.low.y, box.high.y, camera.center.y, scaleY, height_, tilesY, y0, y1);
        for (uint32_t y = y0; y < y1; ++y)
            for (uint32_t x = x0; x < x1; ++x)
                references_.push_back({(s * tilesY + y) * tilesX + x, decal});
    }
}

}  // namespace rushlight
