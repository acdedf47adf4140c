#include "renderer/raytrace/probe_bake.h"

#include "interop/irradiance_volume.h"
#include "renderer/lighting/brdf_table.h"
#include "renderer/raytrace/path_tracer.h"
#include "renderer/raytrace/probe_distances.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kProbesPerRound = 256;  // between two reports of progress
constexpr uint32_t kGatherPasses = 2;
constexpr float kMostRadiance = 65504;

Result<void> checkSamples(uint32_t samples) {
    if (samples >= 16 && samples <= 65536) return {};
    return fail(
        "baked light",
        "there are to be " + std::to_string(samples) + " paths a probe; 16 to 65,536 are possible.",
        ErrorKind::wrongUse);
}

/// Radiance around a point as two bands: half the paths' worth of evenly spread directions, each
/// path weighted against a quarter as many that aim at the bright parts of the sky.
IrradianceProbe gather(const PathTracer& tracer, const vec3& position, uint32_t samples,
                       uint64_t seed) {
    IrradianceProbe probe;
    const auto add = [&](const vec3& radiance, const vec3& direction, float weight) {
        for (int c = 0; c < 3; ++c) {
            if (!std::isfinite(radiance[c])) continue;
            probe.mean[c] += radiance[c] * weight;
            probe.flow[c] += direction * (radiance[c] * weight);
        }
    };
    RayRandom start(seed);
    const float turn = start.next();
    const uint32_t skySamples = samples / 4;
    const float density = float(samples) / (4 * kPi);
    for (uint32_t i = 0; i < samples; ++i) {
        RayRandom random(mixBits(seed) + i);
        const vec3 d = fibonacciDirection(i, samples, turn);
        add(tracer.radiance(position, d, density, float(skySamples), random), d,
            1 / float(samples));
    }
    for (uint32_t i = 0; i < skySamples; ++i) {
        RayRandom random(mixBits(seed) + samples + i);
        const SkySample sky = tracer.light().sampleSky(random);
        if (!(sky.density > 0)) continue;
        const vec3 share = tracer.scene().transmittance({position, sky.direction});
        if (share == vec3(0)) continue;
        add(sky.radiance * share, sky.direction,
            1 / (4 * kPi * (float(skySamples) * sky.density + density)));
    }
    return probe;
}

void limit(IrradianceProbe& probe) {
    for (int c = 0; c < 3; ++c) {
        if (probe.mean[c] <= kMostRadiance) continue;
        probe.flow[c] *= kMostRadiance / probe.mean[c];
        probe.mean[c] = kMostRadiance;
    }
}

/// New light for a probe that stays in its place; `share` of it.
void regather(const PathTracer& tracer, IrradianceVolume& volume, uint32_t index, uint32_t samples,
              uint64_t seed, float share) {
    const IrradianceProbe old = volume.probe(index);
    IrradianceProbe now = gather(tracer, volume.grid.position(index) + old.offset, samples, seed);
    limit(now);
    now.mean = glm::mix(old.mean, now.mean, share);
    for (int c = 0; c < 3; ++c) now.flow[c] = glm::mix(old.flow[c], now.flow[c], share);
    now.offset = old.offset;
    now.weight = old.weight;
    volume.setProbe(index, now);
}

/// Gives probes without a place of their own the mean of their neighbours, from the outermost
/// inwards.
void fillHidden(IrradianceVolume& volume, std::vector<uint8_t> has) {
    const ProbeGrid& g = volume.grid;
    for (bool more = true; more;) {
        more = false;
        std::vector<uint8_t> next = has;
        for (uint32_t i = 0; i < g.count(); ++i) {
            if (has[i]) continue;
            const uint32_t at[3] = {i % g.counts.x, i / g.counts.x % g.counts.y,
                                    i / (g.counts.x * g.counts.y)};
            const uint32_t stride[3] = {1, g.counts.x, g.counts.x * g.counts.y};
            IrradianceProbe sum;
            float count = 0;
            for (int axis = 0; axis < 3; ++axis)
                for (const bool up : {false, true}) {
                    if (up ? at[axis] + 1 >= g.counts[axis] : at[axis] == 0) continue;
                    const uint32_t other = up ? i + stride[axis] : i - stride[axis];
                    if (!has[other]) continue;
                    const IrradianceProbe p = volume.probe(other);
                    sum.mean += p.mean;
                    sum.flow += p.flow;
                    ++count;
                }
            if (count == 0) continue;
            sum.mean /= count;
            sum.flow /= count;
            sum.weight = interop::kFilledProbeWeight;
            volume.setProbe(i, sum);
            next[i] = 1;
            more = true;
        }
        has = std::move(next);
    }
}

}  // namespace

Result<ProbeGrid> placeProbes(const Aabb& bounds, float spacing) {
    const vec3 size = bounds.high - bounds.low;
    if (bounds.isEmpty() || !std::isfinite(glm::length(size)))
        return fail("baked light", "there is nothing to place probes in: the scene is empty.");
    if (!std::isfinite(spacing) || spacing < 0)
        return fail(
            "baked light",
            "the spacing of the probes is " + std::to_string(spacing) + " m; it must be positive.",
            ErrorKind::wrongUse);
    const glm::dvec3 extent = glm::max(glm::dvec3(size), glm::dvec3(1e-3));
    double step = spacing;
    const auto countsFor = [&](double s) {
        return glm::max(glm::ceil(extent / s - 1e-3), glm::dvec3(1));
    };
    if (spacing == 0)
        for (step = std::cbrt(extent.x * extent.y * extent.z / kAutoProbes);; step *= 1.02) {
            const glm::dvec3 n = countsFor(step);
            if (n.x * n.y * n.z <= kAutoProbes) break;
        }
    const glm::dvec3 counts = countsFor(step);
    if (!(counts.x * counts.y * counts.z <= kMaxProbes))
        return fail("baked light",
                    "probes every " + std::to_string(spacing) + " m would be " +
                        std::to_string(uint64_t(std::min(counts.x * counts.y * counts.z, 1e18))) +
                        "; at most 65,536 are possible.",
                    ErrorKind::wrongUse);
    ProbeGrid grid;
    grid.counts = glm::uvec3(counts);
    grid.spacing = vec3(extent / counts);
    grid.origin = bounds.low + 0.5f * grid.spacing;
    return grid;
}

Result<IrradianceVolume> bakeIrradiance(const RayScene& scene, const BakeLighting& lighting,
                                        const ProbeBakeDesc& desc, JobSystem& jobs) {
    if (auto ok = checkSamples(desc.samples); !ok) return tl::unexpected(ok.error());
    const auto grid = placeProbes(desc.bounds.isEmpty() ? scene.bounds() : desc.bounds,
                                  desc.spacing);
    if (!grid) return tl::unexpected(grid.error());
    const auto light = BakeLight::create(lighting, jobs);
    if (!light) return tl::unexpected(light.error());
    const BrdfTable table = makeBrdfTable(jobs);
    const PathTracer tracer(scene, *light, table, desc.bounces);
    IrradianceVolume volume = makeIrradianceVolume(*grid);
    std::vector<uint8_t> open(grid->count());
    const uint32_t steps = grid->count() * (1 + kGatherPasses);
    for (uint32_t first = 0; first < grid->count(); first += kProbesPerRound) {
        const uint32_t count = std::min(grid->count() - first, kProbesPerRound);
        jobs.forRanges(count, 1, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = first + begin; i < first + end; ++i) {
                const ProbePlace place = findProbePlace(scene, *grid, i);
                open[i] = place.open;
                if (!place.open) continue;
                const vec3 position = grid->position(i) + place.offset;
                IrradianceProbe probe = gather(tracer, position, desc.samples, i);
                limit(probe);
                probe.offset = place.offset;
                volume.setProbe(i, probe);
                measureDistances(scene, volume, i, position);
            }
        });
        if (desc.progress) desc.progress(desc.user, first + count, steps);
    }
    fillHidden(volume, open);
    for (uint32_t pass = 1; pass <= kGatherPasses; ++pass) {
        const IrradianceVolume known = volume;
        const PathTracer gatherer(scene, *light, table, desc.bounces, &known);
        for (uint32_t first = 0; first < grid->count(); first += kProbesPerRound) {
            const uint32_t count = std::min(grid->count() - first, kProbesPerRound);
            jobs.forRanges(count, 1, [&](uint32_t begin, uint32_t end) {
                for (uint32_t i = first + begin; i < first + end; ++i)
                    if (open[i])
                        regather(gatherer, volume, i, desc.samples, i + pass * kMaxProbes, 1);
            });
            if (desc.progress)
                desc.progress(desc.user, pass * grid->count() + first + count, steps);
        }
        fillHidden(volume, open);
    }
    volume.lightHash = hashOf(lighting);
    return volume;
}

ProbeUpdater::ProbeUpdater(const RayScene& scene, IrradianceVolume volume, JobSystem& jobs)
    : scene_(scene),
      jobs_(jobs),
      table_(std::make_unique<BrdfTable>(makeBrdfTable(jobs))),
      volume_(std::move(volume)) {}

ProbeUpdater::~ProbeUpdater() = default;

Result<void> ProbeUpdater::update(const BakeLighting& lighting, uint32_t count, uint32_t samples,
                                  float share) {
    if (auto ok = checkSamples(samples); !ok) return ok;
    if (!(share > 0 && share <= 1))
        return fail("baked light",
                    "the share of new light is " + std::to_string(share) +
                        "; it must be above 0 and at most 1.",
                    ErrorKind::wrongUse);
    const auto light = BakeLight::create(lighting, jobs_);
    if (!light) return tl::unexpected(light.error());
    const PathTracer tracer(scene_, *light, *table_, ProbeBakeDesc{}.bounces);
    const uint32_t all = volume_.grid.count();
    count = std::min(count, all);
    jobs_.forRanges(count, 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t k = begin; k < end; ++k) {
            const uint32_t i = (next_ + k) % all;
            if (volume_.probe(i).weight < 0.5f) continue;
            const uint64_t seed = i + (rounds_ + (next_ + k >= all)) * kMaxProbes;
            regather(tracer, volume_, i, samples, seed, share);
        }
    });
    const uint64_t hash = hashOf(lighting);
    updatedSince_ = hash == lightHash_ && share == 1 ? updatedSince_ + count : count;
    lightHash_ = hash;
    volume_.lightHash = updatedSince_ >= all && share == 1 ? hash : 0;
    next_ += count;
    if (next_ >= all) {
        next_ -= all;
        ++rounds_;
    }
    return {};
}

}  // namespace rushlight
