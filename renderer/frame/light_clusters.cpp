#include "renderer/frame/light_clusters.h"

#include "shaders/interop/frame_uniforms.h"

#include <algorithm>
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
                          std::span<const PunctualLight> punctual) {
    width_ = width;
    height_ = height;
    tilesX = (width + RL_CLUSTER_PIXELS - 1) / RL_CLUSTER_PIXELS;
    tilesY = (height + RL_CLUSTER_PIXELS - 1) / RL_CLUSTER_PIXELS;
    lights.clear();
    indices.clear();
    references_.clear();
    ranges_.clear();
    clusters.assign(size_t(tilesX) * tilesY * kSlices, 0);
    visibleLights = 0;
    droppedReferences = 0;

    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    for (const PunctualLight& light : punctual) {
        const float range = effectiveRange(light);
        if (!intersects(camera.frustum, light.position, vec3(range))) continue;
        const float depth = glm::dot(light.position - camera.position, camera.forward);
        if (depth + range < camera.nearPlane) continue;
        nearest = std::min(nearest, depth - range);
        farthest = std::max(farthest, depth + range);
        lights.push_back(toGpu(light, camera.position));
        ranges_.push_back(range);
    }
    visibleLights = uint32_t(lights.size());
    if (lights.empty()) return;

    // Slices span the lights alone; what is nearer or farther falls into the first or the last.
    nearest = std::max({nearest, camera.nearPlane, 0.01f});
    farthest = std::max(farthest, nearest * 1.01f);
    sliceScale = float(kSlices) / std::log2(farthest / nearest);
    sliceBias = -std::log2(nearest) * sliceScale;
    sliceEdges_.resize(kSlices + 1);
    for (uint32_t s = 0; s <= kSlices; ++s)
        sliceEdges_[s] = nearest * std::pow(farthest / nearest, float(s) / kSlices);
    sliceEdges_[0] = std::min(camera.nearPlane, 0.0f);  // an orthographic view may begin behind the eye
    sliceEdges_[kSlices] = std::numeric_limits<float>::max();

    for (uint32_t i = 0; i < visibleLights; ++i) {
        const vec3 p = lights[i].position;
        const vec3 view(glm::dot(p, camera.right), glm::dot(p, camera.up),
                        glm::dot(p, camera.forward));
        addReferences(camera, uint16_t(i), view, ranges_[i]);
    }
    // Counting sort by froxel; within one, lights stay in order.
    for (const Reference& r : references_)
        if (clusters[r.cluster] < kMaxPerCluster) ++clusters[r.cluster];
        else ++droppedReferences;
    const uint32_t fair = fairListLength();
    uint32_t first = 0;
    for (uint32_t& cluster : clusters) {
        const uint32_t count = std::min(cluster, fair);
        droppedReferences += cluster - count;
        cluster = first << kCountBits;
        first += count;
    }
    indices.resize(first);
    for (const Reference& r : references_) {
        uint32_t& cluster = clusters[r.cluster];
        const uint32_t count = cluster & kMaxPerCluster;
        if (count == fair) continue;
        indices[(cluster >> kCountBits) + count] = r.light;
        ++cluster;
    }
}

// The longest that lists may be so that the first indices of all fit their bits: every froxel loses its last lights
// before any loses all.
uint32_t LightClusters::fairListLength() const {
    const auto total = [&](uint32_t longest) {
        uint64_t sum = 0;
        for (uint32_t count : clusters) sum += std::min(count, longest);
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

void LightClusters::addReferences(const CameraMatrices& camera, uint16_t light, const vec3& p,
                                  float range) {
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
                references_.push_back({(s * tilesY + ty) * tilesX + tx, light});
            }
        }
    }
}

}  // namespace rushlight
