#include "renderer/resources/reflection_store.h"

#include "interop/reflection_probe.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

/// Of the world's axes, what a box reaches along each.
vec3 reachOf(const ReflectionProbe& probe) {
    const mat3 axes = glm::mat3_cast(probe.rotation);
    return glm::abs(axes[0]) * probe.halfSize.x + glm::abs(axes[1]) * probe.halfSize.y +
           glm::abs(axes[2]) * probe.halfSize.z + interop::kReflectionSkin;
}

float distanceTo(const ReflectionProbe& probe, const vec3& point) {
    const vec3 place = glm::abs(glm::inverse(probe.rotation) * (point - probe.center));
    return glm::length(glm::max(place - probe.halfSize, vec3(0)));
}

float volumeOf(const ReflectionProbe& p) { return p.halfSize.x * p.halfSize.y * p.halfSize.z; }

}  // namespace

void chooseReflectionProbes(std::span<const ReflectionProbe> probes, const CameraMatrices& camera,
                            std::vector<uint32_t>& chosen) {
    chosen.clear();
    for (uint32_t i = 0; i < probes.size(); ++i)
        if (intersects(camera.frustum, probes[i].center, reachOf(probes[i]))) chosen.push_back(i);
    const auto sortBy = [&](auto&& key) {
        std::ranges::sort(chosen, [&](uint32_t a, uint32_t b) {
            const float left = key(probes[a]), right = key(probes[b]);
            return left != right ? left < right : a < b;
        });
    };
    if (chosen.size() > kMaxShownReflectionProbes) {
        sortBy([&](const ReflectionProbe& p) { return distanceTo(p, camera.position); });
        chosen.resize(kMaxShownReflectionProbes);
    }
    sortBy(volumeOf);
}

void writeReflectionRecords(std::span<const ReflectionProbe> probes,
                            std::span<const uint32_t> chosen, std::span<const uint32_t> layers,
                            const vec3& eye, std::vector<vec4>& records) {
    records.clear();
    records.push_back(vec4(float(chosen.size()), 0, 0, 0));
    for (size_t i = 0; i < chosen.size(); ++i) {
        const ReflectionProbe& p = probes[chosen[i]];
        const mat3 axes = glm::mat3_cast(p.rotation);
        for (int axis = 0; axis < 3; ++axis) {
            const vec3 row = axes[axis] / p.halfSize[axis];
            records.push_back(vec4(row, glm::dot(row, eye - p.center)));
        }
        const interop::ReflectionRamp ramp = interop::reflectionRamp(p.halfSize, p.blend);
        records.push_back(vec4(p.position - eye, float(layers[i])));
        records.push_back(vec4(ramp.scale, p.intensity));
        records.push_back(vec4(ramp.offset, 0));
    }
}

ReflectionStore::~ReflectionStore() { release(); }

void ReflectionStore::release() {
    if (cubes_) device_.destroy(cubes_);
    if (irradiance_) device_.destroy(irradiance_);
    cubes_ = irradiance_ = {};
    capacity_ = 0;
    layers_ = {};
}

Result<TextureHandle> ReflectionStore::makeArray(const char* label, uint32_t size, uint32_t levels,
                                                 uint32_t cubes) {
    TextureDesc desc;
    desc.label = label;
    desc.kind = TextureKind::cubeArray;
    desc.format = Format::rgba16f;
    desc.width = desc.height = size;
    desc.layers = 6 * cubes;
    desc.mipLevels = levels;
    return device_.createTexture(desc);
}

Result<void> ReflectionStore::grow(uint32_t count) {
    if (count <= capacity_) return {};
    const uint32_t capacity = std::bit_ceil(count);
    release();
    const auto cubes = makeArray("reflection-probes", kEnvironmentSize, kEnvironmentLevels,
                                 capacity);
    if (!cubes) return tl::unexpected(cubes.error());
    cubes_ = *cubes;
    const auto irradiance = makeArray("reflection-irradiance", kIrradianceSize, 1, capacity);
    if (!irradiance) return tl::unexpected(irradiance.error());
    irradiance_ = *irradiance;
    capacity_ = capacity;
    return {};
}

// The only way between two textures that a Device has is through the host; it is taken when a probe
// comes into view for the first time, and when it was captured again.
void ReflectionStore::copyCube(TextureHandle from, TextureHandle to, uint32_t layer, uint32_t size,
                               uint32_t levels) {
    for (uint32_t level = 0; level < levels; ++level) {
        const uint32_t side = size >> level;
        scratch_.resize(size_t(side) * side * bytesPerTexel(Format::rgba16f));
        for (uint32_t face = 0; face < 6; ++face) {
            device_.read(from, level, face, scratch_);
            device_.write(to, {level, 6 * layer + face, 1, side, side}, scratch_);
        }
    }
}

void ReflectionStore::copyInto(uint32_t layer, const GpuEnvironment& environment) {
    copyCube(environment.specular, cubes_, layer, kEnvironmentSize, kEnvironmentLevels);
    copyCube(environment.irradiance, irradiance_, layer, kIrradianceSize, 1);
}

uint32_t ReflectionStore::layerOf(const GpuEnvironment& environment) {
    const auto layers = std::span(layers_).first(capacity_);
    auto found = std::ranges::find(layers, environment.content, &Layer::content);
    if (found == layers.end()) {
        found = std::ranges::min_element(layers, {}, &Layer::lastUse);
        found->content = environment.content;
        copyInto(uint32_t(found - layers.begin()), environment);
    }
    found->lastUse = use_;
    return uint32_t(found - layers.begin());
}

Result<void> ReflectionStore::prepare(std::span<const ReflectionProbe> probes,
                                      const CameraMatrices& camera) {
    chosen_.clear();
    records_.clear();
    if (probes.empty()) return {};
    chooseReflectionProbes(probes, camera, chosen_);
    // Where none is in view the shaders are the same and find a count of 0.
    if (auto ok = grow(std::max(1u, uint32_t(chosen_.size()))); !ok) return ok;
    ++use_;
    // First what is there already, so that what is new does not take its place.
    for (const uint32_t i : chosen_)
        for (Layer& layer : layers_)
            if (layer.content == environments_.find(probes[i].environment)->content)
                layer.lastUse = use_;
    chosenLayers_.clear();
    for (const uint32_t i : chosen_)
        chosenLayers_.push_back(layerOf(*environments_.find(probes[i].environment)));
    writeReflectionRecords(probes, chosen_, chosenLayers_, camera.position, records_);
    return {};
}

}  // namespace rushlight
