// Point and spot lights, from the list of the pixel's froxel (renderer/frame/light_clusters.h).
layout(binding = RL_TEXTURE_LIGHTS) uniform samplerBuffer lightTexels;
layout(binding = RL_TEXTURE_CLUSTERS) uniform usamplerBuffer clusterTexels;
layout(binding = RL_TEXTURE_LIGHT_INDICES) uniform usamplerBuffer lightIndexTexels;

int clusterAt(vec2 pixel, float viewDepth) {
    float slice = floor(log2(max(viewDepth, 1e-6)) * L_CLUSTER_MAPPING.x + L_CLUSTER_MAPPING.y);
    slice = clamp(slice, 0.0, L_CLUSTER_COUNTS.z - 1.0);
    vec2 tile = floor(pixel * (1.0 / float(RL_CLUSTER_PIXELS)));
    return int(slice * L_CLUSTER_MAPPING.w + tile.y * L_CLUSTER_MAPPING.z + tile.x);
}

vec3 clusteredLight(LitSurface s, vec2 pixel) {
    uint cluster = texelFetch(clusterTexels, clusterAt(pixel, s.viewDepth)).x;
    int first = int(cluster >> 10);
    int count = int(cluster & 1023u);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        int light = int(texelFetch(lightIndexTexels, first + i).x) * 3;
        vec4 a = texelFetch(lightTexels, light);
        vec4 b = texelFetch(lightTexels, light + 1);
        vec4 c = texelFetch(lightTexels, light + 2);
        vec3 to = a.xyz - s.position;
        float distanceSquared = dot(to, to);
        vec3 l = to * inversesqrt(max(distanceSquared, 1e-8));
        float attenuation = distanceAttenuation(distanceSquared, a.w) *
                            spotAttenuation(-dot(l, c.xyz), vec2(b.w, c.w));
        sum += evaluateBrdf(s.point, l) * b.rgb * attenuation;
    }
    return sum;
}
