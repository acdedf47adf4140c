#include "renderer/lighting/irradiance_volume.h"

#include "interop/irradiance_volume.h"
#include "renderer/geometry/half.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

uint32_t pack(float x, float y) { return uint32_t(toHalf(x)) | uint32_t(toHalf(y)) << 16; }
vec2 unpack(uint32_t bits) { return {fromHalf(uint16_t(bits)), fromHalf(uint16_t(bits >> 16))}; }

constexpr int kTexels = RL_PROBE_TEXELS;

/// A texel beyond the octahedral square's edge, by one: the one that lies there on the sphere.
ivec2 wrapOctahedral(ivec2 t) {
    if (t.x < 0 || t.x >= kTexels) t = {t.x < 0 ? 0 : kTexels - 1, kTexels - 1 - t.y};
    if (t.y < 0 || t.y >= kTexels) t = {kTexels - 1 - t.x, t.y < 0 ? 0 : kTexels - 1};
    return t;
}

/// Bilinear, as the sampler reads the atlas.
vec2 seenDistance(const IrradianceVolume& volume, uint32_t probe, const vec3& direction) {
    const vec2 at = (interop::encodeOctahedral(direction) * 0.5f + 0.5f) * float(kTexels) - 0.5f;
    const vec2 low = glm::floor(at), f = at - low;
    const auto texel = [&](int x, int y) {
        const ivec2 t = wrapOctahedral(ivec2(low) + ivec2(x, y));
        return volume.distance(probe, uint32_t(t.y * kTexels + t.x));
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x),
                    glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

}  // namespace

IrradianceProbe IrradianceVolume::probe(uint32_t index) const {
    const uvec4 a = records[size_t(index) * 2], b = records[size_t(index) * 2 + 1];
    const vec2 h[8] = {unpack(a.x), unpack(a.y), unpack(a.z), unpack(a.w),
                       unpack(b.x), unpack(b.y), unpack(b.z), unpack(b.w)};
    IrradianceProbe p;
    p.mean = {h[0].x, h[0].y, h[1].x};
    p.flow = mat3(h[1].y, h[2].x, h[2].y, h[3].x, h[3].y, h[4].x, h[4].y, h[5].x, h[5].y);
    p.offset = {h[6].x, h[6].y, h[7].x};
    p.weight = h[7].y;
    return p;
}

void IrradianceVolume::setProbe(uint32_t index, const IrradianceProbe& p) {
    const mat3& f = p.flow;
    records[size_t(index) * 2] = {pack(p.mean.x, p.mean.y), pack(p.mean.z, f[0].x),
                                  pack(f[0].y, f[0].z), pack(f[1].x, f[1].y)};
    records[size_t(index) * 2 + 1] = {pack(f[1].z, f[2].x), pack(f[2].y, f[2].z),
                                      pack(p.offset.x, p.offset.y), pack(p.offset.z, p.weight)};
}

vec2 IrradianceVolume::distance(uint32_t index, uint32_t texel) const {
    return unpack(distances[size_t(index) * kProbeDistances + texel]);
}

void IrradianceVolume::setDistance(uint32_t index, uint32_t texel, const vec2& seen) {
    distances[size_t(index) * kProbeDistances + texel] = pack(seen.x, seen.y);
}

IrradianceVolume makeIrradianceVolume(const ProbeGrid& grid) {
    IrradianceVolume volume;
    volume.grid = grid;
    volume.records.resize(size_t(grid.count()) * RL_PROBE_RECORD_TEXELS);
    volume.distances.resize(size_t(grid.count()) * kProbeDistances);
    return volume;
}

Result<void> checkIrradianceVolume(const IrradianceVolume& volume, const std::string& object) {
    const ProbeGrid& g = volume.grid;
    const vec3 sum = g.origin + g.spacing;
    if (!std::isfinite(sum.x + sum.y + sum.z) || !(g.smallestSpacing() > 0))
        return fail(object, "the grid of probes is not finite or has no spacing.");
    const glm::dvec3 counts(g.counts);
    const double count = counts.x * counts.y * counts.z;
    if (count < 1 || count > kMaxProbes)
        return fail(object, "there are " + std::to_string(g.counts.x) + " x " +
                                std::to_string(g.counts.y) + " x " + std::to_string(g.counts.z) +
                                " probes; 1 to 65,536 are possible.");
    if (volume.records.size() != size_t(g.count()) * RL_PROBE_RECORD_TEXELS ||
        volume.distances.size() != size_t(g.count()) * kProbeDistances)
        return fail(object, "its data does not fit its " + std::to_string(g.count()) + " probes.");
    const auto finite = [](uint32_t bits) {
        return (bits & 0x7c00u) != 0x7c00u && (bits & 0x7c000000u) != 0x7c000000u;
    };
    for (const uvec4& r : volume.records)
        if (!finite(r.x) || !finite(r.y) || !finite(r.z) || !finite(r.w))
            return fail(object, "a probe is not finite.");
    for (const uint32_t d : volume.distances)
        if (!finite(d)) return fail(object, "a probe's distance is not finite.");
    return {};
}

vec4 sampleIrradiance(const IrradianceVolume& volume, const vec3& position, const vec3& normal,
                      const vec3& towardsEye) {
    const ProbeGrid& g = volume.grid;
    const vec3 last = vec3(g.counts) - 1.0f;
    const vec3 place = (position - g.origin) / g.spacing;
    const float fade = interop::volumeFade(place, last);
    if (!(fade > 0)) return vec4(0);
    const vec3 inside = glm::clamp(place, vec3(0), last);
    const vec3 base = glm::min(glm::floor(inside), glm::max(last - 1.0f, vec3(0)));
    const interop::ProbeCorners corners = interop::probeCorners(inside - base);
    const vec3 biased = position + (normal + towardsEye * interop::kProbeEyeBias) *
                                       (interop::kProbeNormalBias * g.smallestSpacing());
    vec3 mean(0);
    mat3 flow(0);
    float total = 0;
    const auto add = [&](const vec3& corner, float share) {
        const vec3 cell = glm::min(base + corner, last);
        const uint32_t index = uint32_t(cell.x) +
                               g.counts.x * (uint32_t(cell.y) + g.counts.y * uint32_t(cell.z));
        const IrradianceProbe p = volume.probe(index);
        const vec3 at = g.origin + g.spacing * cell + p.offset;
        const vec3 from = biased - at;
        const vec2 seen = seenDistance(volume, index, from);
        const float visible = interop::probeVisibility(normal, at - position, glm::length(from),
                                                       seen);
        const float weight = share * (visible + 1e-7f) * p.weight;
        mean += p.mean * weight;
        flow += p.flow * weight;
        total += weight;
    };
    const vec3 tetrahedron[4] = {vec3(0), corners.second, corners.third, vec3(1)};
    for (int i = 0; i < 4; ++i) add(tetrahedron[i], corners.shares[i]);
    if (const float doubt = interop::probeDoubt(total); doubt > 0)
        for (int i = 0; i < 8; ++i) {
            const vec3 corner(i & 1, i >> 1 & 1, i >> 2);
            add(corner, doubt * interop::cornerShare(inside - base, corner));
        }
    vec3 out;
    for (int c = 0; c < 3; ++c)
        out[c] = mean[c] > 0 ? mean[c] / total * interop::irradianceShape(flow[c] / mean[c], normal)
                             : 0;
    return {out, fade};
}

ProbeAtlas makeProbeAtlas(const IrradianceVolume& volume) {
    constexpr uint32_t kTile = RL_PROBE_TILE, kRow = RL_PROBE_ATLAS_ROW;
    const uint32_t count = volume.grid.count();
    ProbeAtlas atlas;
    atlas.width = std::min(count, kRow) * kTile;
    atlas.height = (count + kRow - 1) / kRow * kTile;
    atlas.texels.resize(size_t(atlas.width) * atlas.height);
    for (uint32_t probe = 0; probe < count; ++probe)
        for (uint32_t y = 0; y < kTile; ++y)
            for (uint32_t x = 0; x < kTile; ++x) {
                const ivec2 from = wrapOctahedral(ivec2(int(x), int(y)) - 1);
                const size_t row = size_t(probe / kRow) * kTile + y;
                atlas.texels[row * atlas.width + probe % kRow * kTile + x] =
                    volume.distances[size_t(probe) * kProbeDistances +
                                     size_t(from.y * kTexels + from.x)];
            }
    return atlas;
}

}  // namespace rushlight
