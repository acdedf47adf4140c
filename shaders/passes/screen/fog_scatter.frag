// Light that one froxel of fog scatters to the eye, and the share that it covers of what is behind: Hillaire 2015, "Physically
// Based and Unified Volumetric Rendering in Frostbite".
#include "common/light/lighting_block.glsl"
#include "common/screen/fog.glsl"
#include "common/light/lighting.glsl"
#if defined(IRRADIANCE_VOLUME)
#include "common/light/irradiance_probes.glsl"
#endif

layout(location = 4) flat in vec3 flatAmbient;

layout(location = 0) out vec4 fog;

const float kPi = 3.14159265;

/// What one sample of a froxel stands for, in metres.
struct Piece {
    float halfLength;  // along the ray
    float width;       // half of it
};

/// Henyey and Greenstein 1941; `cosine` between the way of the light and the way to the eye.
float phase(float cosine) {
    float g = L_FOG_MEDIUM.z;
    float base = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * kPi * base * sqrt(base));
}

#if defined(CLUSTERED_LIGHTS)
/// Light of one lamp that a piece of a froxel scatters. Between lamp and ray, 1 / distance² is not sampled but averaged over
/// the piece, in closed form along the ray (Lecocq et al. 2000, "Accurate Rendering of Light Effects in Participating
/// Media") and softened by its width: near a lamp a sample would be as bright as it happens to be near.
vec3 lampScattering(LightSample light, LitSurface s, Piece piece) {
    float along = -dot(light.direction, s.point.view) * sqrt(light.distanceSquared);
    float away = sqrt(max(light.distanceSquared - along * along, 0.0) + piece.width * piece.width);
    float mean = (atan((piece.halfLength - along) / away) + atan((piece.halfLength + along) / away)) /
                 (2.0 * piece.halfLength * away);
    return light.intensity * (light.attenuation * light.distanceSquared * mean *
                              phase(-dot(light.direction, s.point.view)));
}

#if defined(AREA_LIGHTS)
#include "common/light/area_scatter.glsl"
#endif

vec3 clusteredScattering(LitSurface s, Piece piece, vec2 pixel) {
    int cluster = clusterAt(pixel, s.viewDepth);
    uint record = texelFetch(clusterTexels, cluster * CLUSTER_WORDS).x;
    int first = int(record >> 10);
    int count = int(record & 1023u);
    vec3 sum = vec3(0.0);
#if defined(PLAIN_LIGHTS)
    for (int i = 0; i < count; ++i) {
        LightSample light = sampleLight(first + i, s);
        sum += lampScattering(light, s, piece);
    }
#endif
#if defined(MODULATED_LIGHTS)
    first += count;
    count = int(texelFetch(clusterTexels, cluster * CLUSTER_WORDS + 1).x & 1023u);
    for (int i = 0; i < count; ++i) {
        LightSample light = sampleLight(first + i, s);
        s.facing = vec4(light.direction, 0.0);
        vec4 modulation = texelFetch(lightTexels, light.texel + 3);
#if defined(PUNCTUAL_SHADOW)
        if (modulation.x >= 0.0)
            shadowLight(light, punctualVisibility(int(modulation.x), s, light.direction,
                                                  sqrt(light.distanceSquared)));
#endif
#if defined(LIGHT_PATTERNS)
        light.intensity *= lightPattern(light, modulation, 2.0 * piece.width);
#endif
        sum += lampScattering(light, s, piece);
    }
#endif
#if defined(AREA_LIGHTS)
    uint others = texelFetch(clusterTexels, cluster * CLUSTER_WORDS + 1).x;
    first = int(record >> 10) + int(record & 1023u) + int(others & 1023u);
    count = int(others >> 10);
    for (int i = 0; i < count; ++i)
        sum += areaScattering(int(texelFetch(lightIndexTexels, first + i).x) * 3, s, piece);
#endif
    return sum;
}
#endif

vec3 lightAt(vec3 position, float viewDepth, vec3 view, Piece piece, vec2 pixel) {
    LitSurface s;
    s.position = position;
    s.viewDepth = viewDepth;
    s.point.view = view;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) {
        vec3 towards = L_DIRECTION(i).xyz;
        vec3 light = L_ILLUMINANCE(i).rgb * phase(-dot(towards, view));
#if defined(SUN_SHADOW)
        // A point of air faces every light.
        s.facing = vec4(towards, 0.0);
        if (i == 0) light *= sunVisibility(s, towards);
#endif
#if defined(SHADOWED_SUNS)
        if (i > 0 && i < SHADOWED_SUNS) light *= secondSunVisibility(i - 1, s, towards);
#endif
        sum += light;
    }
#if defined(CLUSTERED_LIGHTS)
    sum += clusteredScattering(s, piece, pixel);
#endif
    return sum;
}

void main() {
    vec2 grid = L_FOG_GRID.xy;
    vec2 cell = floor(gl_FragCoord.xy / grid);
    vec2 tile = gl_FragCoord.xy - cell * grid;
    float slice = cell.y * float(RL_FOG_COLUMNS) + cell.x;
    vec2 pixel = tile * float(RL_FOG_PIXELS);
    vec2 uv = pixel * L_FOG_GRID.zw;
    vec3 base = lighting.baseCorner.xyz + lighting.baseRight.xyz * uv.x + lighting.baseUp.xyz * uv.y;
    vec3 ray = lighting.rayCorner.xyz + lighting.rayRight.xyz * uv.x + lighting.rayUp.xyz * uv.y;
    vec3 view = -normalize(ray);

    float near = fogSliceDepth(slice), far = fogSliceDepth(slice + 1.0);
    vec3 light = vec3(0.0);
    Piece piece;
    piece.halfLength = length(ray) * (far - near) * (0.5 / float(FOG_SAMPLES));
    float wide = float(RL_FOG_PIXELS) * L_FOG_GRID.z * 0.5;
    for (int i = 0; i < FOG_SAMPLES; ++i) {
        float depth = mix(near, far, (float(i) + 0.5) / float(FOG_SAMPLES));
        piece.width = wide * length(lighting.baseRight.xyz + lighting.rayRight.xyz * depth);
        light += lightAt(base + ray * depth, depth, view, piece, pixel);
    }
#if defined(IRRADIANCE_VOLUME)
    LightAround around = lightAround(base + ray * (near + far) * 0.5, vec3(0.0));
    vec3 ambient = vec3(around.red.x, around.green.x, around.blue.x);
#else
    vec3 ambient = flatAmbient;
#endif
    light = (light / float(FOG_SAMPLES) + ambient) * L_FOG_ALBEDO.rgb;
    float covered = fogCover(fogOpticalDepth(base.y + ray.y * near, base.y + ray.y * far,
                                             length(ray) * (far - near)));
    fog = vec4(min(light * covered, RL_MAX_RADIANCE), covered);
}
