// Reads a material and its textures. Layout: interop/surface_flags.h.
#include "common/surface/surface_inputs.glsl"

layout(binding = RL_TEXTURE_MATERIALS) uniform usamplerBuffer materialTexels;
#if defined(BASE_COLOR_TEXTURE)
layout(binding = RL_TEXTURE_BASE_COLOR) uniform sampler2DArray baseColorTextures;
#endif
#if defined(METALLIC_ROUGHNESS_TEXTURE)
layout(binding = RL_TEXTURE_METALLIC_ROUGHNESS) uniform sampler2DArray metallicRoughnessTextures;
#endif
#if defined(NORMAL_TEXTURE)
layout(binding = RL_TEXTURE_NORMAL) uniform sampler2DArray normalTextures;
#endif
#if defined(OCCLUSION_TEXTURE)
layout(binding = RL_TEXTURE_OCCLUSION) uniform sampler2DArray occlusionTextures;
#endif
#if defined(EMISSIVE_TEXTURE)
layout(binding = RL_TEXTURE_EMISSIVE) uniform sampler2DArray emissiveTextures;
#endif

#if defined(TRANSMISSION_TEXTURE)
layout(binding = RL_TEXTURE_TRANSMISSION) uniform sampler2DArray transmissionTextures;
#endif

struct Material {
    uvec4 texel0;
    uvec4 texel1;
};

Material loadMaterial() {
    return Material(texelFetch(materialTexels, int(surfaceMaterial)),
                    texelFetch(materialTexels, int(surfaceMaterial) + 1));
}

#if defined(ANY_TEXTURE)
vec3 textureCoordinate(Material material, int slot, uint layer) {
#if defined(SECOND_UV)
    bool second = (material.texel1.w >> (20 + slot) & 1u) != 0u;
    vec2 uv = second ? surfaceUv.zw : surfaceUv.xy;
#else
    vec2 uv = surfaceUv;
#endif
#if defined(UV_TRANSFORMS)
#if defined(TRANSMISSION)
    int at = int(surfaceMaterial) + RL_MATERIAL_TEXELS + 1 + 2 * slot;
#else
    int at = int(surfaceMaterial) + RL_MATERIAL_TEXELS + 2 * slot;
#endif
    vec4 columns = uintBitsToFloat(texelFetch(materialTexels, at));
    vec2 offset = uintBitsToFloat(texelFetch(materialTexels, at + 1)).xy;
    uv = columns.xy * uv.x + columns.zw * uv.y + offset;
#endif
    return vec3(uv, float(layer & 0x3ffu));
}
#endif

vec4 baseColorFactor(Material material) {
    vec4 color = vec4(unpackHalf2x16(material.texel0.x), unpackHalf2x16(material.texel0.y));
#if defined(EXTENDED)
    color *= surfaceColor;
#endif
    return color;
}

vec4 materialBaseColor(Material material) {
    vec4 color = baseColorFactor(material);
#if defined(BASE_COLOR_TEXTURE)
    color *= texture(baseColorTextures,
                     textureCoordinate(material, RL_TEXTURE_BASE_COLOR, material.texel1.z));
#endif
    return color;
}

#if defined(ALPHA_MASK)
// Mips blur outlines, and what is cut from them thins out: leaves that are few pixels wide would vanish, and their shadows
// fall from what is not seen.
const float kMaskBias = -1.5;

void cutAlpha(Material material) {
    float alpha = baseColorFactor(material).a;
#if defined(BASE_COLOR_TEXTURE)
    alpha *= texture(baseColorTextures,
                     textureCoordinate(material, RL_TEXTURE_BASE_COLOR, material.texel1.z), kMaskBias).a;
#endif
    if (alpha < unpackHalf2x16(material.texel1.y).y) discard;
}
#endif

#if defined(TRANSMISSION)
#include "common/surface/transmission.glsl"
#endif

#if !defined(DEPTH_ONLY)
struct SurfaceSample {
    vec4 baseColor;
    float metallic;
    float roughness;
    float occlusion;
    vec3 normal;  // facing the camera's side of the triangle; unit in forward passes
    vec3 emissive;
#if defined(TRANSMISSION)
    Transmission transmission;
#endif
};

vec3 shadedNormal(Material material) {
#if defined(FORWARD) || defined(NORMAL_TEXTURE)
    vec3 n = normalize(surfaceNormal);
#else
    vec3 n = surfaceNormal;  // the G-buffer's encoder takes any length
#endif
#if defined(NORMAL_TEXTURE)
    vec3 t = surfaceTangent.xyz;
    vec3 b = cross(n, t) * surfaceTangent.w;
    vec3 map = texture(normalTextures, textureCoordinate(material, RL_TEXTURE_NORMAL,
                                                         material.texel1.z >> 20)).xyz;
    vec3 local = map * (255.0 / 127.0) - 128.0 / 127.0;
    local.xy *= unpackHalf2x16(material.texel0.w).x;
    n = normalize(t * local.x + b * local.y + n * local.z);
#endif
#if defined(DOUBLE_SIDED)
#if defined(MIRRORED)
    n = gl_FrontFacing ? -n : n;
#else
    n = gl_FrontFacing ? n : -n;
#endif
#endif
    return n;
}

SurfaceSample sampleSurface() {
    Material material = loadMaterial();
    SurfaceSample s;
    s.baseColor = materialBaseColor(material);
#if defined(ALPHA_MASK)
    cutAlpha(material);
#endif
    vec2 factors = unpackUnorm2x16(material.texel0.z);
    s.metallic = factors.x;
    s.roughness = factors.y;
    s.occlusion = 1.0;
#if defined(METALLIC_ROUGHNESS_TEXTURE)
    vec3 orm = texture(metallicRoughnessTextures,
                       textureCoordinate(material, RL_TEXTURE_METALLIC_ROUGHNESS,
                                         material.texel1.z >> 10)).xyz;
    s.roughness *= orm.y;
    s.metallic *= orm.z;
#if defined(OCCLUSION_IN_METALLIC_ROUGHNESS)
    s.occlusion += unpackHalf2x16(material.texel0.w).y * (orm.x - 1.0);
#endif
#endif
#if defined(OCCLUSION_TEXTURE)
    float ao = texture(occlusionTextures, textureCoordinate(material, RL_TEXTURE_OCCLUSION,
                                                            material.texel1.w)).x;
    s.occlusion += unpackHalf2x16(material.texel0.w).y * (ao - 1.0);
#endif
    s.normal = shadedNormal(material);
#if defined(TRANSMISSION)
    s.transmission = loadTransmission(material, s.baseColor.a);
#endif
    s.emissive = vec3(0.0);
#if defined(EMISSIVE)
    s.emissive = vec3(unpackHalf2x16(material.texel1.x), unpackHalf2x16(material.texel1.y).x);
#if defined(EMISSIVE_TEXTURE)
    s.emissive *= texture(emissiveTextures, textureCoordinate(material, RL_TEXTURE_EMISSIVE,
                                                              material.texel1.w >> 10)).rgb;
#endif
#endif
    return s;
}
#endif
