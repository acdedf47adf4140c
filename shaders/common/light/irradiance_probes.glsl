// The light around a point, from the irradiance probes that see it, or from the surroundings beyond their grid.
#include "interop/irradiance_volume.h"

layout(binding = RL_TEXTURE_PROBE_DISTANCES) uniform sampler2D probeDistances;
layout(binding = RL_TEXTURE_PROBE_RECORDS) uniform usamplerBuffer probeRecords;

// By colour: x: mean radiance, yzw: mean of radiance times direction.
struct LightAround {
    vec4 red, green, blue;
};

// Which point asks: in metres from the first probe.
struct ProbeQuery {
    vec3 place;
    vec3 offSurface;
    vec3 normal;
    vec3 spacing;
    vec2 atlasTexel;
};

vec2 distanceSeen(ProbeQuery q, float index, vec3 direction) {
    float row = floor((index + 0.5) * (1.0 / float(RL_PROBE_ATLAS_ROW)));
    vec2 tile = vec2(index - row * float(RL_PROBE_ATLAS_ROW), row) * float(RL_PROBE_TILE);
    vec2 inside = (encodeOctahedral(direction) * 0.5 + 0.5) * float(RL_PROBE_TEXELS) + 1.0;
    return textureLod(probeDistances, (tile + inside) * q.atlasTexel, 0.0).xy;
}

// Adds the probe at `cell`, which weighs something even where it does not see the point, if nothing else does; red.x to
// blue.w are sums, and its weight is returned.
float addProbe(inout LightAround sum, ProbeQuery q, vec3 cell, float share) {
    cell = min(cell, L_VOLUME_LAST.xyz);
    vec2 counts = L_VOLUME_LAST.xy + 1.0;
    float index = cell.x + counts.x * (cell.y + counts.y * cell.z);
    int texel = int(index + 0.5) * RL_PROBE_RECORD_TEXELS;
    uvec4 a = texelFetch(probeRecords, texel);
    uvec4 b = texelFetch(probeRecords, texel + 1);
    vec2 a0 = unpackHalf2x16(a.x), a1 = unpackHalf2x16(a.y), a2 = unpackHalf2x16(a.z),
         a3 = unpackHalf2x16(a.w);
    vec2 b0 = unpackHalf2x16(b.x), b1 = unpackHalf2x16(b.y), b2 = unpackHalf2x16(b.z),
         b3 = unpackHalf2x16(b.w);
    vec3 at = cell * q.spacing + vec3(b2, b3.x);
    vec3 from = q.offSurface - at;
    float visible = probeVisibility(q.normal, at - q.place, length(from), distanceSeen(q, index, from));
    float weight = share * (visible + 1e-7) * b3.y;
    sum.red += weight * vec4(a0.x, a1.y, a2);
    sum.green += weight * vec4(a0.y, a3, b0.x);
    sum.blue += weight * vec4(a1.x, b0.y, b1);
    return weight;
}

// `position`: relative to the camera, on a surface with `normal`.
LightAround lightAround(vec3 position, vec3 normal) {
    ProbeQuery q;
    q.place = position - L_VOLUME_ORIGIN.xyz;
    vec3 towardsEye = position * -inversesqrt(max(dot(position, position), 1e-8));
    float onSurface = dot(normal, normal);  // air has no normal and stays in its place
    q.offSurface = q.place + (normal + towardsEye * (kProbeEyeBias * onSurface)) * L_VOLUME_ORIGIN.w;
    q.normal = normal;
    q.spacing = 1.0 / L_VOLUME_SCALE.xyz;
    q.atlasTexel = 1.0 / vec2(textureSize(probeDistances, 0));
    vec3 grid = q.place * L_VOLUME_SCALE.xyz;
    float inside = volumeFade(grid, L_VOLUME_LAST.xyz);
    grid = clamp(grid, vec3(0.0), L_VOLUME_LAST.xyz);
    vec3 base = min(floor(grid), max(L_VOLUME_LAST.xyz - 1.0, vec3(0.0)));
    ProbeCorners corners = probeCorners(grid - base);
    LightAround sum = LightAround(vec4(0.0), vec4(0.0), vec4(0.0));
    float total = addProbe(sum, q, base, corners.shares.x);
    total += addProbe(sum, q, base + corners.second, corners.shares.y);
    total += addProbe(sum, q, base + corners.third, corners.shares.z);
    total += addProbe(sum, q, base + 1.0, corners.shares.w);
    float doubt = probeDoubt(total);
    if (doubt > 0.0) {
        for (int i = 0; i < 8; ++i) {
            vec3 corner = vec3(ivec3(i, i >> 1, i >> 2) & 1);
            total += addProbe(sum, q, base + corner, doubt * cornerShare(grid - base, corner));
        }
    }
    float scale = inside / total, outside = 1.0 - inside;
    sum.red = sum.red * scale + L_VOLUME_OUTER(0) * outside;
    sum.green = sum.green * scale + L_VOLUME_OUTER(1) * outside;
    sum.blue = sum.blue * scale + L_VOLUME_OUTER(2) * outside;
    return sum;
}

// What neighbouring pixels can share: irradiance over pi at any normal n is about tint * irradianceShape(flow, n), and
// exactly so at `normal`.
void shareableLight(LightAround light, vec3 normal, out vec3 tint, out vec3 flow) {
    vec3 mean = vec3(light.red.x, light.green.x, light.blue.x);
    vec3 irradiance =
        mean * vec3(irradianceShape(light.red.yzw / max(mean.r, 1e-9), normal),
                    irradianceShape(light.green.yzw / max(mean.g, 1e-9), normal),
                    irradianceShape(light.blue.yzw / max(mean.b, 1e-9), normal));
    vec4 luminous = 0.2126 * light.red + 0.7152 * light.green + 0.0722 * light.blue;
    flow = luminous.yzw / max(luminous.x, 1e-9);
    tint = irradiance / max(irradianceShape(flow, normal), 1e-4);
}
