// A triangle over the fog's froxels, or over the screen, with the constants that each needs as flat varyings.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

layout(std140, binding = RL_UNIFORMS_LIGHTING) uniform LightingBlock { LightingUniforms lighting; };
#if defined(ENVIRONMENT) && !defined(IRRADIANCE_VOLUME)
layout(binding = RL_TEXTURE_IRRADIANCE) uniform samplerCube irradianceMap;
#endif

layout(location = 0) out vec2 screenUv;
layout(location = 1) out vec3 pixelRay;
layout(location = 2) out vec3 pixelBase;
layout(location = 3) flat out vec4 flatDepthDecode;
layout(location = 4) flat out vec3 flatAmbient;  // mean radiance from all around

void main() {
    screenUv = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID >> 1) * 2.0);
    pixelRay = lighting.rayCorner.xyz + lighting.rayRight.xyz * screenUv.x +
               lighting.rayUp.xyz * screenUv.y;
    pixelBase = lighting.baseCorner.xyz + lighting.baseRight.xyz * screenUv.x +
                lighting.baseUp.xyz * screenUv.y;
    flatDepthDecode = lighting.depthDecode;
#if defined(ENVIRONMENT) && !defined(IRRADIANCE_VOLUME)
    // Irradiance over pi averages over all normals to the mean radiance.
    vec3 sum = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side < 2; side += 2) {
            vec3 normal = vec3(0.0);
            normal[axis] = float(side);
            sum += textureLod(irradianceMap, normal, 0.0).rgb;
        }
    flatAmbient = sum * (lighting.environment.z / 6.0);
#else
    flatAmbient = (lighting.ambientSky.rgb + lighting.ambientGround.rgb) * 0.5;
#endif
    gl_Position = vec4(screenUv * 2.0 - 1.0, 0.0, 1.0);
}
