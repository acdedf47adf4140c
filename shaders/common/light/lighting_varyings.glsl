// LightingUniforms as flat varyings of a full-screen triangle, and the names by which lighting.glsl reads them.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

#if defined(VERTEX_STAGE)
#define LIGHTING_VARYING out
#else
#define LIGHTING_VARYING in
#endif

layout(location = 0) LIGHTING_VARYING vec2 screenUv;
layout(location = 1) LIGHTING_VARYING vec3 pixelRay;   // relative position = base + ray * view depth
layout(location = 2) LIGHTING_VARYING vec3 pixelBase;  // zero for a perspective view
layout(location = 3) flat LIGHTING_VARYING vec4 flatDepthDecode;
layout(location = 4) flat LIGHTING_VARYING vec4 flatViewDirection;
#if defined(BACKGROUND)
layout(location = 5) flat LIGHTING_VARYING vec4 flatBackground;
layout(location = 6) flat LIGHTING_VARYING vec4 flatSunDisk;
layout(location = 7) flat LIGHTING_VARYING vec4 flatSunDiskRadiance;
#endif
#if DIRECTIONAL_LIGHTS > 0
layout(location = 5) flat LIGHTING_VARYING vec4 flatDirections[DIRECTIONAL_LIGHTS];
layout(location = 9) flat LIGHTING_VARYING vec4 flatIlluminances[DIRECTIONAL_LIGHTS];
#endif
#if defined(SUN_SHADOW)
layout(location = 13) flat LIGHTING_VARYING vec4 flatShadowRows[3];
layout(location = 16) flat LIGHTING_VARYING vec4 flatShadowCascades[SHADOW_CASCADES];
layout(location = 20) flat LIGHTING_VARYING vec4 flatShadowSettings;
#if defined(SHADOW_SOFT)
layout(location = 26) flat LIGHTING_VARYING vec4 flatShadowSoftness;
#endif
#endif
#if defined(CLUSTERED_LIGHTS)
layout(location = 21) flat LIGHTING_VARYING vec4 flatClusterMapping;
layout(location = 22) flat LIGHTING_VARYING vec4 flatClusterCounts;
#endif
#if defined(ENVIRONMENT)
layout(location = 23) flat LIGHTING_VARYING vec4 flatEnvironment;
#elif defined(HEMISPHERE)
layout(location = 23) flat LIGHTING_VARYING vec4 flatAmbientSky;
layout(location = 24) flat LIGHTING_VARYING vec4 flatAmbientGround;
#endif
#if defined(IRRADIANCE_VOLUME)
layout(location = 25) flat LIGHTING_VARYING vec4 flatVolumeOuterLuminance;
#endif
#if defined(IRRADIANCE_LOOKUP)
layout(location = 5) flat LIGHTING_VARYING vec4 flatVolumeOrigin;
layout(location = 6) flat LIGHTING_VARYING vec4 flatVolumeScale;
layout(location = 7) flat LIGHTING_VARYING vec4 flatVolumeLast;
layout(location = 8) flat LIGHTING_VARYING vec4 flatVolumeOuter[3];
#endif

#if defined(VERTEX_STAGE)

layout(std140, binding = RL_UNIFORMS_LIGHTING) uniform LightingBlock { LightingUniforms lighting; };

void writeLightingVaryings(vec2 uv) {
    screenUv = uv;
    pixelRay = lighting.rayCorner.xyz + lighting.rayRight.xyz * uv.x + lighting.rayUp.xyz * uv.y;
    pixelBase =
        lighting.baseCorner.xyz + lighting.baseRight.xyz * uv.x + lighting.baseUp.xyz * uv.y;
    flatDepthDecode = lighting.depthDecode;
    flatViewDirection = lighting.viewDirection;
#if defined(BACKGROUND)
    flatBackground = lighting.background;
    flatSunDisk = lighting.sunDisk;
    flatSunDiskRadiance = lighting.sunDiskRadiance;
#endif
#if DIRECTIONAL_LIGHTS > 0
    for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) {
        flatDirections[i] = lighting.directionalDirections[i];
        flatIlluminances[i] = lighting.directionalIlluminances[i];
    }
#endif
#if defined(SUN_SHADOW)
    for (int i = 0; i < 3; ++i) flatShadowRows[i] = lighting.shadowRows[i];
    for (int i = 0; i < SHADOW_CASCADES; ++i) flatShadowCascades[i] = lighting.shadowCascades[i];
    flatShadowSettings = lighting.shadowSettings;
#if defined(SHADOW_SOFT)
    flatShadowSoftness = lighting.shadowSoftness;
#endif
#endif
#if defined(CLUSTERED_LIGHTS)
    flatClusterMapping = lighting.clusterMapping;
    flatClusterCounts = lighting.clusterCounts;
#endif
#if defined(ENVIRONMENT)
    flatEnvironment = lighting.environment;
#elif defined(HEMISPHERE)
    flatAmbientSky = lighting.ambientSky;
    flatAmbientGround = lighting.ambientGround;
#endif
#if defined(IRRADIANCE_VOLUME)
    flatVolumeOuterLuminance = lighting.volumeOuterLuminance;
#endif
#if defined(IRRADIANCE_LOOKUP)
    flatVolumeOrigin = lighting.volumeOrigin;
    flatVolumeScale = lighting.volumeScale;
    flatVolumeLast = lighting.volumeLast;
    for (int i = 0; i < 3; ++i) flatVolumeOuter[i] = lighting.volumeOuter[i];
#endif
}

#else

#define L_SHADOW_SETTINGS flatShadowSettings
#define L_SHADOW_SOFTNESS flatShadowSoftness
#define L_SHADOW_ROW(i) flatShadowRows[i]
#define L_SHADOW_CASCADE(i) flatShadowCascades[i]
#define L_CONTACT_LENGTH flatDepthDecode.z
#define L_VIEW_DIRECTION flatViewDirection.xyz
#define L_DIRECTION(i) flatDirections[i]
#define L_ILLUMINANCE(i) flatIlluminances[i]
#define L_CLUSTER_MAPPING flatClusterMapping
#define L_CLUSTER_COUNTS flatClusterCounts
#define L_ENVIRONMENT flatEnvironment
#define L_AMBIENT_SKY flatAmbientSky
#define L_AMBIENT_GROUND flatAmbientGround
#define L_VOLUME_ORIGIN flatVolumeOrigin
#define L_VOLUME_SCALE flatVolumeScale
#define L_VOLUME_LAST flatVolumeLast
#define L_VOLUME_OUTER(i) flatVolumeOuter[i]
#define L_VOLUME_OUTER_LUMINANCE flatVolumeOuterLuminance
#endif
