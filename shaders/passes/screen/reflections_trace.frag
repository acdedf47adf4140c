// What mirrors see of the image itself, one of four pixels: a march through the pyramid of nearest depths that leaps over
// empty cells (Uludag 2014, "Hi-Z Screen-Space Cone-Traced Reflections", GPU Pro 5), along the ray's own line on the screen,
// where device depth is linear (McGuire and Mara 2014, "Efficient GPU Screen-Space Ray Tracing", JCGT 3(4)). A rougher
// surface looks at a coarser level of the radiance where the ray ends. All distances along the line are in texels of
// level 0, half the frame's.
//
// rgb: the radiance that was hit; a: device depth and how sure it is, packed as an occlusion texel
#include "common/screen/screen_space.glsl"
#include "common/screen/pyramid.glsl"
#include "common/screen/occlusion_texel.glsl"
#include "interop/encode.h"

layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;
layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D radiancePyramid;  // linear
layout(binding = RL_TEXTURE_SOURCE1) uniform sampler2D nearestPyramid;

layout(location = 0) out vec4 reflection;

const int kMostSteps = 64;
const float kSkipped = 2.0;          // the ray's first texels: the cells there are of the mirror itself
const float kFadeFrom = 0.4;         // roughness at which reflections begin to give way to the environment
const float kFadeTo = 0.6;           // and are gone
const float kThickness = 0.03;       // of the distance: how far behind a surface a ray still hits it
const float kEdge = 0.08;            // share of the picture over which hits fade towards its edges
const float kLongest = 30.0;         // rays end at so many times the mirror's distance

// xy: in texels of level 0; z: device depth.
vec3 project(vec3 position) {
    float viewDepth = -position.z;
#if defined(ORTHOGRAPHIC)
    vec2 xy = position.xy;
    float linear = viewDepth;
#else
    vec2 xy = position.xy / viewDepth;
    float linear = 1.0 / viewDepth;
#endif
    vec2 texel = (xy - flatViewFromTexel.zw) / flatViewFromTexel.xy;
    return vec3(texel * 0.5, (linear - flatDepthDecode.y) / flatDepthDecode.x);
}

// The point where the line from `start` meets a surface, w: 1 where it does.
vec4 march(vec3 start, vec3 end) {
    vec3 step_ = end - start;
    float length_ = max(abs(step_.x), abs(step_.y));
    if (length_ <= kSkipped) return vec4(0.0);
    step_ /= length_;
    vec2 slope = vec2(abs(step_.x) < 1e-6 ? 1e-6 : step_.x, abs(step_.y) < 1e-6 ? 1e-6 : step_.y);
    vec2 perTexel = 1.0 / slope;
    vec2 ahead = vec2(greaterThan(slope, vec2(0.0)));
    vec2 size = vec2(flatRight.w, flatUp.w);
    float t = kSkipped;
    int level = 0;
    for (int i = 0; i < kMostSteps; ++i) {
        vec3 at = start + step_ * t;
        if (t > length_ || at.x < 0.0 || at.y < 0.0 || at.x >= size.x || at.y >= size.y)
            return vec4(0.0);
        float cellSize = float(1 << level);
        vec2 cell = floor(at.xy / cellSize);
        vec2 exits = ((cell + ahead) * cellSize - start.xy) * perTexel;
        float exit = max(min(exits.x, exits.y), t) + 0.02;
        float nearest = texelFetch(nearestPyramid, pyramidOrigin(level) + ivec2(cell), 0).x;
        bool before = at.z > nearest;
        float meets = step_.z < 0.0 ? (nearest - start.z) / step_.z : 1e9;
        if (before && meets >= exit) {  // nothing in this cell: on, and look further ahead
            t = exit;
            level = min(level + 1, PYRAMID_LEVELS - 1);
        } else if (level > 0) {
            t = before ? meets : t;
            --level;
        } else {
            float behind = viewDepthOf(at.z) / viewDepthOf(nearest) - 1.0;
            if (before || behind < kThickness) return vec4(start + step_ * (before ? meets : t), 1.0);
            t = exit;  // it passes behind
        }
    }
    return vec4(0.0);
}

vec3 radianceAt(vec2 at, float level) {
    vec3 sum = vec3(0.0);
    float low = floor(level);
    for (int i = 0; i < 2; ++i) {
        int l = min(int(low) + i, PYRAMID_LEVELS - 1);
        float scale = 1.0 / float(1 << l);
        vec2 size = vec2(flatRight.w, flatUp.w) * scale;
        vec2 inside = clamp(at * scale, vec2(0.5), max(size - 0.5, vec2(0.5)));
        vec2 texel = vec2(pyramidOrigin(l)) + inside;
        float share = i == 0 ? 1.0 - (level - low) : level - low;
        sum += textureLod(radiancePyramid, texel / vec2(textureSize(radiancePyramid, 0)), 0.0).rgb * share;
    }
    return sum;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) * 2;
    float depth = texelFetch(depthMap, texel, 0).x;
    vec4 surface = texelFetch(gbuffer1, texel, 0);
    reflection = vec4(0.0, 0.0, 0.0, packOcclusion(depth, 0.0));
    if (depth <= 0.0 || surface.a >= kFadeTo) return;

    float viewDepth = viewDepthOf(depth);
    vec3 position = viewPosition(vec2(texel) + 0.5, viewDepth);
    vec3 normal = viewFromWorld(unpackNormal(surface.rgb));
#if defined(ORTHOGRAPHIC)
    vec3 incoming = vec3(0.0, 0.0, -1.0);
    float span = flatSize.x / flatSize.z;  // metres across the picture: the mirror's distance says nothing here
    float farthest = span;
#else
    vec3 incoming = normalize(position);
    float farthest = kLongest * viewDepth;
#endif
    vec3 direction = reflect(incoming, normal);
#if !defined(ORTHOGRAPHIC)
    // Never to the eye's own plane, where the projection ends.
    if (direction.z > 0.0) farthest = min(farthest, 0.95 * viewDepth / direction.z);
#endif
    vec3 start = project(position);
    vec4 hit = march(start, project(position + direction * farthest));
    if (hit.w == 0.0) return;

    vec2 size = vec2(flatRight.w, flatUp.w);
    vec3 hitNormal = viewFromWorld(unpackNormal(
        texelFetch(gbuffer1, ivec2(clamp(hit.xy * 2.0, vec2(0.0), flatSize.xy - 1.0)), 0).rgb));
    float facing = clamp(-dot(hitNormal, direction) * 10.0, 0.0, 1.0);  // the back of things is not in the image
    vec2 edge = clamp(min(hit.xy, size - hit.xy) / (size * kEdge), 0.0, 1.0);
    float rough = 1.0 - smoothstep(kFadeFrom, kFadeTo, surface.a);
    float sure = facing * edge.x * edge.y * rough;
    // The lobe's width where it ends: an isosceles triangle along the line, its angle about alpha.
    float width = distance(start.xy, hit.xy) * surface.a * surface.a;
    float level = clamp(log2(max(width, 1.0)), 0.0, float(PYRAMID_LEVELS - 1));
    reflection = vec4(radianceAt(hit.xy, level), packOcclusion(depth, sure));
}
