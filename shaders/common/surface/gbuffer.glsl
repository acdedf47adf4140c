// The G-buffer's one encoder and one decoder. 16 bytes a pixel with the depth.
//
//               r         g         b         a
//     target 0  base colour, square root      metallic          RGBA8
//     target 1  normal, octahedral 12 + 12    roughness         RGBA8
//     target 2  emissive or velocity, 24 bit  occlusion 6, kind 2 bits   RGBA8
//     depth     reversed z                                      D32F
//
// kind: at rest: the 24 bits are emissive radiance, velocity follows from the depth; moving: they are velocity, and
// what the surface emits is added by the forward pass; unlit: base colour is the radiance.
#include "interop/encode.h"
#include "interop/surface_flags.h"

struct GBufferTexels {
    vec4 target0, target1, target2;
};

struct GBufferSample {
    vec3 baseColor;
    float metallic;
    vec3 normal;
    float roughness;
    vec3 emissive;   // zero where the surface moves
    vec2 velocity;   // in uv; zero where the surface is at rest
    float occlusion;
    float unlit;     // 1 or 0
};

GBufferTexels encodeGBuffer(vec3 baseColor, float metallic, vec3 normal, float roughness,
                            vec3 packed24, float occlusion, int kind) {
    GBufferTexels t;
    t.target0 = vec4(sqrt(clamp(baseColor, 0.0, 1.0)), metallic);
    t.target1 = vec4(packNormal(normal), roughness);
    float bits = floor(clamp(occlusion, 0.0, 1.0) * 63.0 + 0.5) * 4.0 + float(kind);
    t.target2 = vec4(packed24, bits / 255.0);
    return t;
}

GBufferSample decodeGBuffer(GBufferTexels t) {
    GBufferSample s;
    s.baseColor = t.target0.rgb * t.target0.rgb;
    s.metallic = t.target0.a;
    s.normal = unpackNormal(t.target1.rgb);
    s.roughness = t.target1.a;
    float bits = floor(t.target2.a * 255.0 + 0.5);
    float occlusion = floor(bits * 0.25);
    float kind = bits - occlusion * 4.0;
    s.occlusion = occlusion / 63.0;
    s.unlit = kind == float(RL_SURFACE_UNLIT) ? 1.0 : 0.0;
    s.emissive = kind == float(RL_SURFACE_AT_REST) ? unpackEmissive(t.target2.rgb) : vec3(0.0);
    s.velocity = kind == float(RL_SURFACE_MOVING) ? unpackVelocity(t.target2.rgb) : vec2(0.0);
    return s;
}
