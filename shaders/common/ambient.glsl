// Light from everywhere: an environment, or a hemisphere.
#if defined(ENVIRONMENT)
layout(binding = RL_TEXTURE_ENVIRONMENT) uniform samplerCube environmentMap;
layout(binding = RL_TEXTURE_IRRADIANCE) uniform samplerCube irradianceMap;
#endif

vec3 ambientLight(LitSurface s) {
    vec3 n = s.point.normal;
    vec3 albedo = s.baseColor * (1.0 - s.metallic);
#if defined(ENVIRONMENT)
    vec3 r = reflect(-s.point.view, n);
    vec2 turn = L_ENVIRONMENT.xy;
    vec3 nt = vec3(turn.x * n.x - turn.y * n.z, n.y, turn.y * n.x + turn.x * n.z);
    vec3 rt = vec3(turn.x * r.x - turn.y * r.z, r.y, turn.y * r.x + turn.x * r.z);
    EnvironmentWeights w = environmentWeights(albedo, s.point.f0, s.table);
    vec3 specular =
        textureLod(environmentMap, rt, environmentLevel(s.roughness, L_ENVIRONMENT.w)).rgb;
    vec3 irradiance = textureLod(irradianceMap, nt, 0.0).rgb;
    vec3 light = w.diffuse * irradiance + w.specular * specular;
    return light * (L_ENVIRONMENT.z * s.occlusion);
#elif defined(HEMISPHERE)
    // The specular lobe of a hemisphere, without a table: Karis 2014, "Physically Based Shading on Mobile".
    vec4 k = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(k.x * k.x, exp2(-9.28 * s.point.nDotV)) * k.x + k.y;
    vec2 table = vec2(-1.04, 1.04) * a + k.zw;
    vec3 r = reflect(-s.point.view, n);
    vec3 diffuse = mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, n.y * 0.5 + 0.5);
    vec3 specular = mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, r.y * 0.5 + 0.5);
    return (albedo * diffuse + specularAlbedo(s.point.f0, table) * specular) * s.occlusion;
#else
    return vec3(0.0);
#endif
}
