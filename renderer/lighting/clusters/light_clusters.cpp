#include "renderer/lighting/clusters/light_clusters.h"

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

bool hasPattern(const PunctualLight& light) { return light.profile || light.cookie; }

/// As shaders/common/light/light_patterns.glsl reads it.
void addPatterns(const PunctualLight& light, const LightPatternStore& patterns,
                 GpuLightModulation& modulation) {
    const LightPatternFrame frame = patternFrameOf(light);
    modulation.right = frame.right;
    modulation.up = frame.up;
    modulation.cotangent = frame.cotangent;
    if (const auto* profile = patterns.find(light.profile)) {
        modulation.profile = float(profile->layer + 1);
        modulation.perRadian = profile->perRadian;
    }
    if (const auto* cookie = patterns.find(light.cookie))
        modulation.cookie = float(cookie->layer + 1);
}

/// How far a light without bounds reaches with `candela`.
float reachOf(float candela) { return std::sqrt(std::max(candela, 0.0f) / kNegligibleLux); }

float peak(const vec3& v) { return std::max({v.x, v.y, v.z, 0.0f}); }

bool isFlat(const AreaLight& light) {
    return light.shape == AreaShape::rectangle || light.shape == AreaShape::disk;
}

/// Of the middle to the farthest point.
float extentOf(const AreaLight& light) {
    switch (light.shape) {
        case AreaShape::rectangle: return glm::length(light.halfX) + glm::length(light.halfY);
        case AreaShape::disk: return std::max(glm::length(light.halfX), glm::length(light.halfY));
        case AreaShape::sphere: return light.radius;
        case AreaShape::tube: break;
    }
    return glm::length(light.halfX) + light.radius;
}

/// As shaders/common/light/area_lights.glsl reads it.
GpuAreaLight toGpu(const AreaLight& light, const vec3& cameraPosition, int32_t shadowRecord) {
    GpuAreaLight gpu;
    gpu.position = light.position - cameraPosition;
    gpu.inverseRangeSq = light.range > 0 ? 1 / (light.range * light.range) : 0;
    gpu.luminance = light.luminance;
    gpu.shape = float(light.shape);
    gpu.halfX = light.halfX;
    gpu.radius = light.radius;
    gpu.halfY = light.halfY;
    gpu.twoSided = light.twoSided ? 1 : 0;
    gpu.shadowRecord = float(shadowRecord);
    gpu.extent = extentOf(light);
    return gpu;
}

// Of a spot, the least sphere around the piece of the ball that its cone holds (Wronski, "Cull that
// cone", 2017).
LightVolume volumeOf(const PunctualLight& light) {
    LightVolume volume;
    const float range = effectiveRange(light);
    volume.center = volume.apex = light.position;
    volume.radius = range;
    const float angle = light.outerConeAngle, length = glm::length(light.direction);
    if (angle < 0 || angle >= kPi / 2 || !(length > 0)) return volume;
    volume.axis = light.direction / length;
    volume.cosine = std::cos(angle);
    const bool narrow = angle < kPi / 4;
    const float ahead = narrow ? range / (2 * volume.cosine) : range * volume.cosine;
    volume.center += volume.axis * ahead;
    volume.radius = narrow ? ahead : range * std::sin(angle);
    return volume;
}

// A one-sided light reaches what is before its plane: a cone of 90 degrees.
LightVolume volumeOf(const AreaLight& light) {
    LightVolume volume;
    volume.center = volume.apex = light.position;
    volume.radius = effectiveRange(light);
    if (isFlat(light) && !light.twoSided) {
        volume.axis = glm::normalize(glm::cross(light.halfX, light.halfY));
        volume.cosine = 0;
    }
    return volume;
}

bool isVisible(const CameraMatrices& camera, const LightVolume& volume) {
    for (const Plane& plane : camera.frustum.planes)
        if (glm::dot(plane.normal, volume.center) + plane.offset < -volume.radius) return false;
    return true;
}

}  // namespace

float shownArea(const AreaLight& light) {
    const float sides = glm::length(light.halfX) * glm::length(light.halfY);
    switch (light.shape) {
        case AreaShape::rectangle: return 4 * sides;
        case AreaShape::disk: return kPi * sides;
        case AreaShape::sphere: return kPi * light.radius * light.radius;
        case AreaShape::tube: break;
    }
    return light.radius * (4 * glm::length(light.halfX) + kPi * light.radius);
}

float effectiveRange(const PunctualLight& light) {
    return light.range > 0 ? light.range : reachOf(peak(light.intensity));
}

float effectiveRange(const AreaLight& light) {
    if (light.range > 0) return light.range;
    return reachOf(peak(light.luminance) * shownArea(light)) + extentOf(light);
}

void LightClusters::build(const CameraMatrices& camera, uint32_t width, uint32_t height,
                          const ClusterInputs& inputs, JobSystem& jobs) {
    lights.clear();
    indices.clear();
    volumes_.clear();
    droppedReferences = 0;
    gather(camera, inputs);
    const bool onlyPlain = !hasClass[size_t(LightClass::modulated)] &&
                           !hasClass[size_t(LightClass::area)];
    recordWords = onlyPlain ? 1 : 2;
    chooseResolution(camera, width, height);
    clusters.assign(size_t(tilesX) * tilesY * slices * recordWords, 0);
    if (visible_.empty()) return;
    chooseGrid(camera, width, height);
    for (uint32_t c = 0; c < kLightClasses; ++c)
        for (VisibleLight& light : visible_)
            if (uint32_t(light.lightClass) == c) addLight(camera, inputs, light);
    volumes_.finish();
    writeLists(jobs);
}

void LightClusters::gather(const CameraMatrices& camera, const ClusterInputs& inputs) {
    visible_.clear();
    visibleOfClass = {};
    hasClass = {};
    hasPatterns = false;
    nearest_ = std::numeric_limits<float>::max();
    farthest_ = 0;
    for (uint32_t i = 0; i < inputs.punctual.size(); ++i) {
        const PunctualLight& light = inputs.punctual[i];
        const bool shadowed = (inputs.shadowed && light.castsShadow) ||
                              (!inputs.shadowRecords.empty() && inputs.shadowRecords[i] >= 0);
        const bool pattern = inputs.patterns && hasPattern(light);
        const LightClass own = shadowed || pattern ? LightClass::modulated : LightClass::plain;
        hasClass[size_t(own)] = true;
        hasPatterns |= pattern;
        addIfVisible(camera, i, own, volumeOf(light));
    }
    hasClass[size_t(LightClass::area)] = !inputs.area.empty();
    for (uint32_t i = 0; i < inputs.area.size(); ++i)
        addIfVisible(camera, i, LightClass::area, volumeOf(inputs.area[i]));
    visibleLights = uint32_t(visible_.size());
}

bool LightClusters::addIfVisible(const CameraMatrices& camera, uint32_t index,
                                 LightClass lightClass, LightVolume volume) {
    if (!isVisible(camera, volume)) return false;
    const auto toView = [&](const vec3& v) {
        return vec3(glm::dot(v, camera.right), glm::dot(v, camera.up), glm::dot(v, camera.forward));
    };
    volume.center = toView(volume.center - camera.position);
    volume.apex = toView(volume.apex - camera.position);
    volume.axis = toView(volume.axis);
    volume.lightClass = uint8_t(lightClass);
    nearest_ = std::min(nearest_, volume.center.z - volume.radius);
    farthest_ = std::max(farthest_, volume.center.z + volume.radius);
    visible_.push_back({index, lightClass, volume});
    ++visibleOfClass[size_t(lightClass)];
    return true;
}

// Froxels about a third as wide as a light looks from side to side: smaller ones cost more to fill
// than they save in shading. Measured with 64 to 4,096 lights on one level
// (tests/bench/lights_bench.cpp).
void LightClusters::chooseResolution(const CameraMatrices& camera, uint32_t width,
                                     uint32_t height) {
    constexpr float kSmall = 40, kMedium = 160;
    float sum = 0;
    for (const VisibleLight& light : visible_) {
        const float distance = std::max(glm::length(light.volume.center), light.volume.radius);
        sum += camera.perspective ? light.volume.radius / (distance * camera.tanHalfY)
                                  : light.volume.radius / camera.halfHeight;
    }
    const float radius = visible_.empty() ? float(height)
                                          : 0.5f * float(height) * sum / float(visible_.size());
    tilePixels = radius < kSmall ? 16 : radius < kMedium ? 32 : 64;
    slices = 32;
    tilesX = (width + tilePixels - 1) / tilePixels;
    tilesY = (height + tilePixels - 1) / tilePixels;
}

// Slices span the lights alone; what is nearer or farther falls into the first or the last.
void LightClusters::chooseGrid(const CameraMatrices& camera, uint32_t width, uint32_t height) {
    const float nearest = std::max({nearest_, camera.nearPlane, 0.01f});
    const float farthest = std::max(farthest_, nearest * 1.01f);
    sliceScale = float(slices) / std::log2(farthest / nearest);
    sliceBias = -std::log2(nearest) * sliceScale;
    grid_.perspective = camera.perspective;
    grid_.tilesX = tilesX;
    grid_.tilesY = tilesY;
    grid_.slices = slices;
    grid_.depths.resize(slices + 1);
    for (uint32_t s = 0; s <= slices; ++s)
        grid_.depths[s] = nearest * std::pow(farthest / nearest, float(s) / slices);
    grid_.depths[0] = std::min(camera.nearPlane, nearest);  // an orthographic view may begin behind
                                                            // the eye
    grid_.depths[slices] = std::numeric_limits<float>::max();
    const float scaleX = camera.perspective ? camera.tanHalfX : camera.halfWidth;
    const float scaleY = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    grid_.setTiles(scaleX - camera.center.x, scaleY - camera.center.y,
                   2 * float(tilePixels) * scaleX / float(width),
                   2 * float(tilePixels) * scaleY / float(height));
}

void LightClusters::addLight(const CameraMatrices& camera, const ClusterInputs& inputs,
                             VisibleLight& light) {
    light.volume.slot = uint16_t(lights.size());
    volumes_.items.push_back(light.volume);
    if (light.lightClass == LightClass::area) {
        const auto slots = std::bit_cast<std::array<GpuLight, 2>>(
            toGpu(inputs.area[light.index], camera.position,
                  inputs.areaShadowRecords.empty() ? -1 : inputs.areaShadowRecords[light.index]));
        lights.insert(lights.end(), slots.begin(), slots.end());
        return;
    }
    const PunctualLight& from = inputs.punctual[light.index];
    lights.push_back(toGpu(from, camera.position));
    if (light.lightClass == LightClass::modulated) {
        GpuLightModulation modulation;
        if (!inputs.shadowRecords.empty())
            modulation.shadowRecord = float(inputs.shadowRecords[light.index]);
        modulation.radius = from.radius;
        if (inputs.patterns && hasPattern(from)) {
            addPatterns(from, *inputs.patterns, modulation);
            lights.back().direction = patternFrameOf(from).forward;
        }
        lights.push_back(std::bit_cast<GpuLight>(modulation));
    }
}

// Two passes over bands of froxels, the same tests in both: the first counts, the second writes.
void LightClusters::writeLists(JobSystem& jobs) {
    constexpr uint32_t kRows = 12;
    const uint32_t bandsInSlice = (tilesY + kRows - 1) / kRows;
    const auto forBands = [&](auto&& work) {
        jobs.forRanges(bandsInSlice * slices, 1, [&](uint32_t begin, uint32_t end) {
            for (uint32_t band = begin; band < end; ++band) {
                const uint32_t firstRow = band % bandsInSlice * kRows;
                work(FroxelBand{band / bandsInSlice, firstRow, std::min(firstRow + kRows, tilesY)});
            }
        });
    };
    counts_.assign(size_t(tilesX) * tilesY * slices * listsOfFroxel(), 0);
    forBands([&](const FroxelBand& band) {
        countLights(grid_, volumes_, band, listsOfFroxel(), counts_.data());
    });
    layOutLists();
    forBands([&](const FroxelBand& band) {
        writeLights(grid_, volumes_, band, listsOfFroxel(), next_.data(), counts_.data(),
                    indices.data());
    });
}

// Gives each list its place, and makes records of the counts.
void LightClusters::layOutLists() {
    const uint32_t fair = fairListLength();
    next_.resize(counts_.size());
    const uint32_t lists = listsOfFroxel();
    uint32_t first = 0;
    for (size_t f = 0; f < counts_.size() / lists; ++f) {
        uint32_t* record = &clusters[f * recordWords];
        record[0] = first << kCountBits;
        for (uint32_t c = 0; c < lists; ++c) {
            uint32_t& list = counts_[f * lists + c];
            const uint32_t count = std::min(list, fair);
            droppedReferences += list - count;
            record[c > 0] |= count << (c == uint32_t(LightClass::area) ? kCountBits : 0);
            next_[f * lists + c] = first;
            first += count;
            list = first;
        }
    }
    indices.resize(first);
}

// The longest that lists may be so that the first indices of all fit their bits: every froxel loses
// its last lights before any loses all.
uint32_t LightClusters::fairListLength() const {
    const auto total = [&](uint32_t longest) {
        uint64_t sum = 0;
        for (uint32_t count : counts_) sum += std::min(count, longest);
        return sum;
    };
    if (total(kMaxPerCluster) < kMaxReferences) return kMaxPerCluster;
    uint32_t fits = 0, tooLong = kMaxPerCluster + 1;
    while (tooLong - fits > 1) {
        const uint32_t middle = (fits + tooLong) / 2;
        (total(middle) < kMaxReferences ? fits : tooLong) = middle;
    }
    return fits;
}

}  // namespace rushlight
