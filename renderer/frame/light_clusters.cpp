#include "renderer/frame/light_clusters.h"

#include "shaders/interop/frame_uniforms.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

constexpr float kNegligibleLux = 1e-3f;

GpuLight toGpu(const PunctualLight& light, const vec3& cameraPosition) {
    GpuLight gpu;
    gpu.position = light.position - cameraPosition;
    gpu.inverseRangeSq = light.range > 0 ? 1 / (light.range * light.range) : 0;
    gpu.intensity = light.intensity;
    gpu.direction = light.direction;
    gpu.spotScale = 0;
    gpu.spotOffset = 1;
    if (light.outerConeAngle >= 0) {
        // KHR_lights_punctual, "Inner and Outer Cone Angles"
        const float cosOuter = std::cos(light.outerConeAngle);
        const float cosInner = std::cos(std::min(light.innerConeAngle, light.outerConeAngle));
        gpu.spotScale = 1 / std::max(0.001f, cosInner - cosOuter);
        gpu.spotOffset = -cosOuter * gpu.spotScale;
    }
    return gpu;
}

float squaredDistanceToInterval(float x, float low, float high) {
    const float d = x < low ? low - x : x > high ? x - high : 0;
    return d * d;
}

}  // namespace

float effectiveRange(const PunctualLight& light) {
    if (light.range > 0) return light.range;
    const float peak = std::max({light.intensity.x, light.intensity.y, light.intensity.z, 0.0f});
    return std::sqrt(peak / kNegligibleLux);
}

void LightClusters::build(const CameraMatrices& camera, uint32_t width, uint32_t height,
                          const ClusterInputs& inputs) {
    width_ = width;
    height_ = height;
    tilesX = (width + RL_CLUSTER_PIXELS - 1) / RL_CLUSTER_PIXELS;
    tilesY = (height + RL_CLUSTER_PIXELS - 1) / RL_CLUSTER_PIXELS;
    lights.clear();
    indices.clear();
    references_.clear();
    visible_.clear();
    visibleOfClass = {};
    visibleLights = 0;
    droppedReferences = 0;

    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    for (uint32_t i = 0; i < inputs.punctual.size(); ++i) {
        const PunctualLight& light = inputs.punctual[i];
        const float range = effectiveRange(light);
        if (!intersects(camera.frustum, light.position, vec3(range))) continue;
        const float depth = glm::dot(light.position - camera.position, camera.forward);
        if (depth + range < camera.nearPlane) continue;
        nearest = std::min(nearest, depth - range);
        farthest = std::max(farthest, depth + range);
        const bool shadowed = !inputs.shadowRecords.empty() && inputs.shadowRecords[i] >= 0;
        visible_.push_back({i, range, shadowed ? LightClass::modulated : LightClass::plain});
        ++visibleOfClass[size_t(visible_.back().lightClass)];
    }
    visibleLights = uint32_t(visible_.size());
    recordWords = visibleOfClass[size_t(LightClass::plain)] == visibleLights ? 1 : 2;
    clusters.assign(size_t(tilesX) * tilesY * kSlices * recordWords, 0);
    if (visible_.empty()) return;
    chooseSlices(camera, nearest, farthest);

    for (uint32_t c = 0; c < kLightClasses; ++c)
        for (const VisibleLight& light : visible_)
            if (uint32_t(light.lightClass) == c) addLight(camera, inputs, light);
    writeLists();
}

// Slices span the lights alone; what is nearer or farther falls into the first or the last.
void LightClusters::chooseSlices(const CameraMatrices& camera, float nearest, float farthest) {
    nearest = std::max({nearest, camera.nearPlane, 0.01f});
    farthest = std::max(farthest, nearest * 1.01f);
    sliceScale = float(kSlices) / std::log2(farthest / nearest);
    sliceBias = -std::log2(nearest) * sliceScale;
    sliceEdges_.resize(kSlices + 1);
    for (uint32_t s = 0; s <= kSlices; ++s)
        sliceEdges_[s] = nearest * std::pow(farthest / nearest, float(s) / kSlices);
    sliceEdges_[0] = std::min(camera.nearPlane, 0.0f);  // an orthographic view may begin behind the eye
    sliceEdges_[kSlices] = std::numeric_limits<float>::max();
}

void LightClusters::addLight(const CameraMatrices& camera, const ClusterInputs& inputs,
                             const VisibleLight& light) {
    const PunctualLight& from = inputs.punctual[light.index];
    const uint16_t slot = uint16_t(lights.size());
    lights.push_back(toGpu(from, camera.position));
    const vec3 p = lights.back().position;
    if (light.lightClass == LightClass::modulated) {
        GpuLightModulation modulation;
        modulation.shadowRecord = float(inputs.shadowRecords[light.index]);
        modulation.radius = from.radius;
        lights.push_back(std::bit_cast<GpuLight>(modulation));
    }
    const vec3 view(glm::dot(p, camera.right), glm::dot(p, camera.up), glm::dot(p, camera.forward));
    addReferences(camera, light.lightClass, slot, view, light.range);
}

// A counting sort by froxel and class; within one, lights stay in order.
void LightClusters::writeLists() {
    const uint32_t froxels = tilesX * tilesY * kSlices;
    lists_.assign(size_t(froxels) * kLightClasses, 0);
    for (const Reference& r : references_)
        if (lists_[r.list] < kMaxPerCluster) ++lists_[r.list];
        else ++droppedReferences;
    const uint32_t fair = fairListLength();
    uint32_t first = 0;
    for (uint32_t f = 0; f < froxels; ++f) {
        uint32_t* record = &clusters[size_t(f) * recordWords];
        record[0] = first << kCountBits;
        for (uint32_t c = 0; c < kLightClasses; ++c) {
            uint32_t& list = lists_[f * kLightClasses + c];
            const uint32_t count = std::min(list, fair);
            droppedReferences += list - count;
            if (c < recordWords) record[c] |= count;
            list = first;
            first += count;
        }
    }
    indices.resize(first);
    for (const Reference& r : references_) {
        const uint32_t next = lists_[r.list];
        const uint32_t f = r.list / kLightClasses, c = r.list % kLightClasses;
        const uint32_t* record = &clusters[size_t(f) * recordWords];
        uint32_t end = record[0] >> kCountBits;
        for (uint32_t i = 0; i <= c; ++i) end += record[i] & kMaxPerCluster;
        if (next == end) continue;
        indices[next] = r.slot;
        ++lists_[r.list];
    }
}

// The longest that lists may be so that the first indices of all fit their bits: every froxel loses its last lights
// before any loses all.
uint32_t LightClusters::fairListLength() const {
    const auto total = [&](uint32_t longest) {
        uint64_t sum = 0;
        for (uint32_t count : lists_) sum += std::min(count, longest);
        return sum;
    };
    if (references_.size() < kMaxReferences) return kMaxPerCluster;
    uint32_t fits = 0, tooLong = kMaxPerCluster + 1;
    while (tooLong - fits > 1) {
        const uint32_t middle = (fits + tooLong) / 2;
        (total(middle) < kMaxReferences ? fits : tooLong) = middle;
    }
    return fits;
}

void LightClusters::addReferences(const CameraMatrices& camera, LightClass lightClass,
                                  uint16_t slot, const vec3& p, float range) {
    const float tileX = 2.0f * RL_CLUSTER_PIXELS / float(width_);
    const float tileY = 2.0f * RL_CLUSTER_PIXELS / float(height_);
    const float scaleX = camera.perspective ? camera.tanHalfX : camera.halfWidth;
    const float scaleY = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    for (uint32_t s = 0; s < kSlices; ++s) {
        const float low = sliceEdges_[s], high = std::min(sliceEdges_[s + 1], p.z + range);
        if (low > p.z + range || sliceEdges_[s + 1] < p.z - range) continue;
        const float dz = squaredDistanceToInterval(p.z, low, sliceEdges_[s + 1]);
        const float radiusSq = range * range - dz;
        if (radiusSq <= 0) continue;
        const float radius = std::sqrt(radiusSq);
        // A tile's side edges at the slice's two ends bound its box.
        const float nearScale = camera.perspective ? std::max(low, camera.nearPlane) : 1;
        const float farScale = camera.perspective ? std::max(high, nearScale) : 1;
        const auto edges = [&](float ndc, float scale, float& least, float& most) {
            const float a = ndc * scale * nearScale, b = ndc * scale * farScale;
            least = std::min(a, b);
            most = std::max(a, b);
        };
        for (uint32_t ty = 0; ty < tilesY; ++ty) {
            float bottom, top, unused;
            edges(float(ty) * tileY - 1, scaleY, bottom, unused);
            edges(float(ty + 1) * tileY - 1, scaleY, unused, top);
            const float dy = squaredDistanceToInterval(p.y, bottom, top);
            if (dy >= radius * radius) continue;
            for (uint32_t tx = 0; tx < tilesX; ++tx) {
                float left, right;
                edges(float(tx) * tileX - 1, scaleX, left, unused);
                edges(float(tx + 1) * tileX - 1, scaleX, unused, right);
                const float dx = squaredDistanceToInterval(p.x, left, right);
                if (dx + dy >= radius * radius) continue;
                const uint32_t froxel = (s * tilesY + ty) * tilesX + tx;
                references_.push_back({froxel * kLightClasses + uint32_t(lightClass), slot});
            }
        }
    }
}

}  // namespace rushlight
