// Ambient occlusion by a search for horizons in the depth buffer, one of four pixels; interop/occlusion_arc.h has the
// integrals and the source. What it finds is counted as a loss against open sky, so that an open plane is exactly open,
// however few the slices.
//
// flatSettings: x: radius in metres; y, z: an occluder at distance d weighs y - z d^2; w: how thin edges are
// flatBack.w: the longest search in texels
#include "common/screen/screen_space.glsl"
#include "common/screen/occlusion_texel.glsl"
#include "interop/encode.h"

layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

layout(location = 0) out vec4 occlusion;

const float kNearest = 1.3;  // texels: the pixel itself is no occluder

// x: turn of the slices, y: shift of the steps, both in [0, 1): nine of each in every 3x3 pixels, which the denoiser
// averages, and no two neighbours alike in both.
vec2 pattern(ivec2 pixel) {
    int i = pixel.x % 3 + pixel.y % 3 * 3;
    return vec2(float(i * 2 % 9), float(i * 5 % 9)) * (1.0 / 9.0) + vec2(1.0 / 18.0);
}

struct Slice {
    vec3 tangent;    // unit, in the surface and the slice
    float cosN, sinN;
    float perHeight; // from height over the surface to height in the slice
};

// The cosine to the view vector of the horizon that the texel makes, no lower than `low`. The texel is not quite in the
// slice; the point with its height over the surface and its way along it is, and so a plane never hides itself.
float horizonAt(vec2 texel, vec3 position, vec3 normal, Slice slice, float low, float horizon) {
    vec2 at = clamp(floor(texel), vec2(0.0), flatSize.xy - 1.0);
    float depth = texelFetch(depthMap, ivec2(at), 0).x;
    vec3 offset = viewPosition(at + 0.5, viewDepthOf(depth)) - position;
    float distance2 = dot(offset, offset);
    float height = dot(offset, normal);
    float along = dot(offset, slice.tangent);
    float above = height * slice.perHeight;
    float cosine = (above * slice.cosN - along * slice.sinN) *
                   inversesqrt(max(along * along + above * above, 1e-20));
    float weight = clamp(flatSettings.y - distance2 * flatSettings.z, 0.0, 1.0);
    // Half a degree and less over the surface is the surface, as far as its normal and texels can tell.
    weight = height > 0.0 && height * height > 1e-4 * distance2 ? weight : 0.0;
    cosine = mix(low, cosine, weight);
    // What is behind an edge may be seen under it: horizons sink where depth falls back (section 4.2 of the paper).
    float lower = mix(horizon, max(cosine, low), flatSettings.w);
    bool onScreen = at == floor(texel);
    return onScreen ? (cosine > horizon ? cosine : lower) : horizon;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) * 2;
    float depth = texelFetch(depthMap, texel, 0).x;
    occlusion = vec4(0.0);
    if (depth <= 0.0) return;

    vec2 center = vec2(texel) + 0.5;
    float viewDepth = viewDepthOf(depth);
    vec3 position = viewPosition(center, viewDepth);
    vec3 normal = viewFromWorld(unpackNormal(texelFetch(gbuffer1, texel, 0).rgb));
#if defined(ORTHOGRAPHIC)
    vec3 view = vec3(0.0, 0.0, 1.0);
    float reach = flatSettings.x * flatSize.w;
#else
    vec3 view = -normalize(position);
    float reach = flatSettings.x * flatSize.w / viewDepth;
#endif
    reach = min(reach, flatBack.w) - kNearest;
    vec2 noise = pattern(ivec2(gl_FragCoord.xy));

    float lost = 0.0;
    vec3 missing = vec3(0.0);
    if (reach > 0.0) {
        const float turn = 2.0 * kHalfPi / float(OCCLUSION_SLICES);
        vec2 direction = vec2(cos(noise.x * turn), sin(noise.x * turn));
        for (int i = 0; i < OCCLUSION_SLICES; ++i) {
            vec3 axis = normalize(cross(vec3(direction, 0.0), view));
            vec3 across = cross(view, axis);
            vec3 projected = normal - axis * dot(normal, axis);
            float len = max(length(projected), 1e-4);
            Slice slice;
            // A shading normal may face away; what is seen is not of a surface that does.
            slice.cosN = clamp(dot(projected, view) / len, 0.0, 1.0);
            slice.sinN = sqrt(1.0 - slice.cosN * slice.cosN);
            slice.sinN = dot(projected, across) < 0.0 ? -slice.sinN : slice.sinN;
            slice.tangent = across * slice.cosN - view * slice.sinN;
            slice.perHeight = 1.0 / len;
            float low0 = slice.sinN;
            float low1 = -slice.sinN;
            float cosH0 = low0;
            float cosH1 = low1;
            for (int j = 0; j < OCCLUSION_STEPS; ++j) {
                float t = (float(j) + noise.y) * (1.0 / float(OCCLUSION_STEPS));
                vec2 offset = direction * (t * t * reach + kNearest);
                cosH0 = horizonAt(center - offset, position, normal, slice, low0, cosH0);
                cosH1 = horizonAt(center + offset, position, normal, slice, low1, cosH1);
            }
            vec3 arc = arcOccluded(cosH0, cosH1, slice.cosN, slice.sinN) * len;
            lost += arc.x;
            missing += across * arc.y + view * arc.z;
            direction = direction * cos(turn) + vec2(-direction.y, direction.x) * sin(turn);
        }
    }
    const float share = 1.0 / float(OCCLUSION_SLICES);
    occlusion = vec4(worldFromView(missing * share), packOcclusion(depth, 1.0 - lost * share));
}
