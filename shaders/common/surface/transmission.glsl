// What goes through a surface (KHR_materials_transmission), for those that are seen and those that cast.

struct Transmission {
    float share;     // of the light that is not mirrored
    vec3 color;      // times the base colour
    float coverage;  // of the surface; the rest is a hole
};

Transmission loadTransmission(Material material, float alpha) {
    uvec4 texel = texelFetch(materialTexels, int(surfaceMaterial) + RL_MATERIAL_TEXELS);
    vec2 x = unpackHalf2x16(texel.x);
    Transmission t;
    t.share = x.x;
    t.color = vec3(unpackHalf2x16(texel.y), unpackHalf2x16(texel.z).x);
    t.coverage = mix(1.0, alpha, x.y);
#if defined(TRANSMISSION_TEXTURE)
    t.share *= texture(transmissionTextures,
                       textureCoordinate(material, RL_MATERIAL_SLOT_TRANSMISSION, texel.w)).r;
#endif
    return t;
}

#if defined(DEPTH_ONLY)
// The share of light that goes on, by colour, whichever way it comes: what is mirrored is not taken off.
vec3 lightThrough(Material material) {
    vec4 base = materialBaseColor(material);
    Transmission t = loadTransmission(material, base.a);
    float metallic = unpackUnorm2x16(material.texel0.z).x;
#if defined(METALLIC_ROUGHNESS_TEXTURE)
    metallic *= texture(metallicRoughnessTextures,
                        textureCoordinate(material, RL_TEXTURE_METALLIC_ROUGHNESS,
                                          material.texel1.z >> 10)).z;
#endif
    vec3 through = clamp(base.rgb, 0.0, 1.0) * t.color * (t.share * (1.0 - metallic));
    return mix(vec3(1.0), through, clamp(t.coverage, 0.0, 1.0));
}
#endif
