#pragma once
// The lamps of the square: which there are, which burn, and how they flicker.

#include "engine/core/math.h"
#include "renderer/frame/frame_input.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

struct Lamp {
    std::string name;
    size_t light = 0;  ///< which punctual light of the level
    vec3 position{0};
    bool lit = false;
    double litAt = 0;  ///< seconds
};

class Lamps {
public:
    static constexpr float kReach = 3.2f;       // metres from the eyes to the lamp, measured level
    static constexpr float kTogether = 1.3f;    // metres farther, for what goes on with a lamp in
                                                // reach
    static constexpr float kKindleTime = 0.8f;  // seconds until a lamp burns fully

    /// Keeps burning what burnt and is still there. Lights whose name begins with "lamp" are lamps.
    void gather(std::span<const PunctualLight> lights, std::span<const std::string> names);

    /// A lamp that does not burn is in reach.
    bool canLightAt(const vec3& eyes) const;
    /// Lights what is in reach and what hangs beside it: the two of a post go on together.
    void lightAround(const vec3& eyes, double time);
    void lightAll(double time);

    /// Scales the level's lights: dark, kindling or burning.
    void apply(std::span<PunctualLight> lights, double time) const;

    bool allLit() const { return litCount() == count(); }
    size_t count() const { return lamps_.size(); }
    size_t litCount() const;
    const std::vector<Lamp>& all() const { return lamps_; }

private:
    static bool isOutWithin(const Lamp& lamp, const vec3& eyes, float reach);

    std::vector<Lamp> lamps_;
};

/// How bright lamp number `seed` burns at `time`, around 1: smooth noise of the time alone, the
/// same in every run.
float flicker(uint32_t seed, double time);

}  // namespace rushlight
