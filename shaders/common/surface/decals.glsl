// Decals over a surface, from the list of its froxel (renderer/lighting/clusters/decal_clusters.h). Needs the block `view`.
layout(binding = RL_TEXTURE_DECAL_COLOR) uniform sampler2DArray decalColors;
layout(binding = RL_TEXTURE_DECAL_DETAIL) uniform sampler2DArray decalDetails;
layout(binding = RL_TEXTURE_DECALS) uniform samplerBuffer decalTexels;
layout(binding = RL_TEXTURE_DECAL_LISTS) uniform usamplerBuffer decalLists;

int decalCluster(vec2 pixel, float viewDepth) {
    vec4 mapping = view.decalMapping;
    float slice = floor(log2(max(viewDepth, 1e-6)) * mapping.x + mapping.y);
    vec2 tile = floor(pixel * (1.0 / float(RL_DECAL_PIXELS)));
    return int(clamp(slice, 0.0, float(RL_DECAL_SLICES - 1)) * mapping.w + tile.y * mapping.z + tile.x);
}

/// `position` is relative to the camera; `normal` is unit.
void applyDecals(vec3 position, vec2 pixel, inout vec3 baseColor, inout vec3 normal,
                 inout float roughness, inout float metallic) {
    float viewDepth = dot(position, view.cameraForward.xyz);
    uint record = texelFetch(decalLists, decalCluster(pixel, viewDepth)).x;
    int first = int(record >> 8);
    int count = int(record & 255u);
    vec3 surface = normal;
    // Metres of a pixel
    float spread = view.decalScale.x * (view.cameraPosition.w > 0.5 ? viewDepth : 1.0);
    for (int i = 0; i < count; ++i) {
        int texel = int(texelFetch(decalLists, first + i).x) * 6;
        vec4 row0 = texelFetch(decalTexels, texel);
        vec4 row1 = texelFetch(decalTexels, texel + 1);
        vec4 row2 = texelFetch(decalTexels, texel + 2);
        vec4 tint = texelFetch(decalTexels, texel + 3);
        vec4 a = texelFetch(decalTexels, texel + 4);  // layer, roughness, metallic, base colour's share
        vec4 b = texelFetch(decalTexels, texel + 5);  // shares of normal and roughness, texels a metre
        vec3 local = vec3(dot(row0.xyz, position) + row0.w, dot(row1.xyz, position) + row1.w,
                          dot(row2.xyz, position) + row2.w);
        vec3 inside = step(abs(local), vec3(1.0));
        // Fades out between 60 and 80 degrees off the decal's axis, where the picture would be drawn out.
        float facing = dot(surface, row2.xyz) * inversesqrt(dot(row2.xyz, row2.xyz));
        float level = log2(max(b.z * spread / max(facing, 0.2), 1.0));
        vec3 place = vec3(local.x * 0.5 + 0.5, 0.5 - local.y * 0.5, a.x);
        vec4 color = textureLod(decalColors, place, level) * tint;
        vec4 detail = textureLod(decalDetails, place, level);
        float cover = color.a * inside.x * inside.y * inside.z * smoothstep(0.17, 0.5, facing);
        baseColor = mix(baseColor, color.rgb, cover * a.w);
        roughness = mix(roughness, detail.z * a.y, cover * b.y);
        metallic = mix(metallic, detail.w * a.z, cover * b.y);
        vec2 slope = (detail.xy * (255.0 / 127.0) - 128.0 / 127.0) * (cover * b.x);
        vec3 right = row0.xyz - surface * dot(surface, row0.xyz);
        vec3 up = row1.xyz - surface * dot(surface, row1.xyz);
        normal += right * (slope.x * inversesqrt(max(dot(right, right), 1e-12))) +
                  up * (slope.y * inversesqrt(max(dot(up, up), 1e-12)));
    }
    normal = normalize(normal);
}
