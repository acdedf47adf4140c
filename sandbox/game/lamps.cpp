#include "sandbox/game/lamps.h"

#include "engine/core/hash.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr float kPilotLight = 0.015f;  // of a lamp that does not burn: a last glow to find it by

/// A random number in [-1, 1] for each whole `at`.
float noiseAt(uint32_t seed, int64_t at) {
    const uint64_t bits = mixBits(mixBits(uint64_t(at)) ^
                                  (uint64_t(seed) + 1) * 0x9e3779b97f4a7c15ull);
    return float(double(bits >> 11) / double(1ull << 52)) - 1;
}

/// Value noise with a continuous slope.
float smoothNoise(uint32_t seed, double at) {
    const double whole = std::floor(at);
    const auto t = float(at - whole);
    const float blend = t * t * (3 - 2 * t);
    const auto cell = int64_t(whole);
    return glm::mix(noiseAt(seed, cell), noiseAt(seed, cell + 1), blend);
}

bool isLamp(std::string_view name) { return name.starts_with("lamp"); }

}  // namespace

float flicker(uint32_t seed, double time) {
    return 1 + 0.05f * smoothNoise(2 * seed, 2.3 * time) +
           0.03f * smoothNoise(2 * seed + 1, 9.1 * time);
}

void Lamps::gather(std::span<const PunctualLight> lights, std::span<const std::string> names) {
    std::vector<Lamp> found;
    for (size_t i = 0; i < lights.size(); ++i) {
        if (!isLamp(names[i])) continue;
        Lamp lamp{names[i], i, lights[i].position, false, 0};
        for (const Lamp& known : lamps_) {
            if (known.name != lamp.name) continue;
            lamp.lit = known.lit;
            lamp.litAt = known.litAt;
        }
        found.push_back(std::move(lamp));
    }
    lamps_ = std::move(found);
}

bool Lamps::isOutWithin(const Lamp& lamp, const vec3& eyes, float reach) {
    return !lamp.lit && std::hypot(lamp.position.x - eyes.x, lamp.position.z - eyes.z) < reach;
}

bool Lamps::canLightAt(const vec3& eyes) const {
    return std::any_of(lamps_.begin(), lamps_.end(),
                       [&](const Lamp& lamp) { return isOutWithin(lamp, eyes, kReach); });
}

void Lamps::lightAround(const vec3& eyes, double time) {
    if (!canLightAt(eyes)) return;
    for (Lamp& lamp : lamps_) {
        if (!isOutWithin(lamp, eyes, kReach + kTogether)) continue;
        lamp.lit = true;
        lamp.litAt = time;
    }
}

void Lamps::lightAll(double time) {
    for (Lamp& lamp : lamps_) {
        lamp.lit = true;
        lamp.litAt = time;
    }
}

void Lamps::apply(std::span<PunctualLight> lights, double time) const {
    for (size_t i = 0; i < lamps_.size(); ++i) {
        const Lamp& lamp = lamps_[i];
        const float kindled = lamp.lit
                                  ? std::clamp(float(time - lamp.litAt) / kKindleTime, 0.0f, 1.0f)
                                  : 0.0f;
        const float glow = std::max(kPilotLight, kindled * kindled) * flicker(uint32_t(i), time);
        lights[lamp.light].intensity *= glow;
    }
}

size_t Lamps::litCount() const {
    return size_t(std::count_if(lamps_.begin(), lamps_.end(), [](const Lamp& l) { return l.lit; }));
}

}  // namespace rushlight
