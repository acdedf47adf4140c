#include "renderer/raytrace/probe_distances.h"

#include "interop/irradiance_volume.h"
#include "renderer/raytrace/ray_random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rushlight {
namespace {

constexpr uint32_t kPlaceRays = 128;
constexpr uint32_t kPlaceSteps = 5;
constexpr float kMostBacks = 0.25f;   // share of rays that meet a back
constexpr float kClearance = 0.2f;    // of the smallest spacing, to the nearest front
constexpr float kMostOffset = 0.45f;  // of the spacing

struct Surroundings {
    float backs = 0;  // share
    float nearestBack = std::numeric_limits<float>::infinity();
    float nearestFront = std::numeric_limits<float>::infinity();
    vec3 towardsBack{0}, frontNormal{0};
};

Surroundings lookAround(const RayScene& scene, const vec3& position) {
    Surroundings s;
    for (uint32_t i = 0; i < kPlaceRays; ++i) {
        const vec3 d = fibonacciDirection(i, kPlaceRays, 0);
        RayHit hit;
        if (!scene.intersect({position, d}, hit)) continue;
        const bool back = !hit.front && !scene.surface(hit).doubleSided;
        if (back) {
            s.backs += 1.0f / float(kPlaceRays);
            if (hit.distance >= s.nearestBack) continue;
            s.nearestBack = hit.distance;
            s.towardsBack = d;
        } else if (hit.distance < s.nearestFront) {
            s.nearestFront = hit.distance;
            s.frontNormal = hit.front ? hit.geometricNormal : -hit.geometricNormal;
        }
    }
    return s;
}

/// The open place nearest to home of a few in the cell around it; none is open: where it was.
ProbePlace searchCell(const RayScene& scene, const vec3& home, const vec3& most, ProbePlace place) {
    constexpr int kSteps = 2;  // to each side of each axis
    float nearest = std::numeric_limits<float>::infinity();
    for (int z = -kSteps; z <= kSteps; ++z)
        for (int y = -kSteps; y <= kSteps; ++y)
            for (int x = -kSteps; x <= kSteps; ++x) {
                const vec3 offset = most * vec3(x, y, z) / float(kSteps);
                const float distance = glm::length(offset);
                if (distance >= nearest || lookAround(scene, home + offset).backs > kMostBacks)
                    continue;
                nearest = distance;
                place = {offset, true};
            }
    return place;
}

/// Out of what the probe is in, and off what it is close to.
ProbePlace stepOut(const RayScene& scene, const vec3& home, const vec3& most, float clearance,
                   ProbePlace place) {
    for (uint32_t step = 0;; ++step) {
        const Surroundings s = lookAround(scene, home + place.offset);
        place.open = s.backs <= kMostBacks;
        if (step == kPlaceSteps) return place;
        vec3 move(0);
        if (!place.open)
            move = s.towardsBack * (s.nearestBack + 0.5f * clearance);
        else if (s.nearestFront < clearance)
            move = s.frontNormal * (clearance - s.nearestFront + 1e-3f * clearance);
        else
            return place;
        const vec3 moved = glm::clamp(place.offset + move, -most, most);
        if (moved == place.offset) return place;
        place.offset = moved;
    }
}

}  // namespace

ProbePlace findProbePlace(const RayScene& scene, const ProbeGrid& grid, uint32_t probe) {
    const vec3 home = grid.position(probe);
    const float clearance = kClearance * grid.smallestSpacing();
    const vec3 most = kMostOffset * grid.spacing;
    ProbePlace place = stepOut(scene, home, most, clearance, {});
    if (place.open) return place;
    place = searchCell(scene, home, most, place);
    return place.open ? stepOut(scene, home, most, clearance, place) : place;
}

// The mean over a texel, of rays spread evenly in it: what is asked between texels is their
// bilinear mean.
void measureDistances(const RayScene& scene, IrradianceVolume& volume, uint32_t probe,
                      const vec3& position) {
    constexpr uint32_t kRays = 4;  // along each side of a texel
    const float farthest = 1.5f * glm::length(volume.grid.spacing);
    for (uint32_t texel = 0; texel < kProbeDistances; ++texel) {
        float sum = 0, squares = 0;
        for (uint32_t i = 0; i < kRays * kRays; ++i) {
            const vec2 corner(texel % RL_PROBE_TEXELS, texel / RL_PROBE_TEXELS);
            const vec2 inside = (vec2(i % kRays, i / kRays) + 0.5f) / float(kRays);
            const vec3 d = interop::decodeOctahedral((corner + inside) * (2.0f / RL_PROBE_TEXELS) -
                                                     1.0f);
            RayHit hit;
            const float distance = scene.intersect({position, d, 0, farthest}, hit) ? hit.distance
                                                                                    : farthest;
            sum += distance;
            squares += distance * distance;
        }
        const float mean = sum / float(kRays * kRays);
        const float variance = std::max(squares / float(kRays * kRays) - mean * mean, 0.0f);
        volume.setDistance(probe, texel, {mean, std::sqrt(variance)});
    }
}

}  // namespace rushlight
