// LightingUniforms read from the uniform block: for forward surfaces, whose triangles are too many for flat varyings.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

layout(std140, binding = RL_UNIFORMS_LIGHTING) uniform LightingBlock { LightingUniforms lighting; };

#define L_SHADOW_SETTINGS lighting.shadowSettings
#define L_SHADOW_SOFTNESS lighting.shadowSoftness
#define L_SHADOW_ROW(i) lighting.shadowRows[i]
#define L_SHADOW_CASCADE(i) lighting.shadowCascades[i]
#define L_DIRECTION(i) lighting.directionalDirections[i]
#define L_ILLUMINANCE(i) lighting.directionalIlluminances[i]
#define L_CLUSTER_MAPPING lighting.clusterMapping
#define L_CLUSTER_COUNTS lighting.clusterCounts
#define L_ENVIRONMENT lighting.environment
#define L_AMBIENT_SKY lighting.ambientSky
#define L_AMBIENT_GROUND lighting.ambientGround
#define L_VOLUME_ORIGIN lighting.volumeOrigin
#define L_VOLUME_SCALE lighting.volumeScale
#define L_VOLUME_LAST lighting.volumeLast
#define L_VOLUME_OUTER(i) lighting.volumeOuter[i]
#define L_VOLUME_OUTER_LUMINANCE lighting.volumeOuterLuminance
#define L_FOG_MEDIUM lighting.fogMedium
#define L_FOG_ALBEDO lighting.fogAlbedo
#define L_FOG_MAPPING lighting.fogMapping
#define L_FOG_GRID lighting.fogGrid
