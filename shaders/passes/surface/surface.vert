// Vertices of every surface pass: G-buffer, forward, and alpha-masked casters (DEPTH_ONLY).
#define VERTEX_STAGE
#include "common/surface/surface_inputs.glsl"
#include "interop/encode.h"

layout(location = RL_ATTRIBUTE_POSITION) in vec3 position;
layout(location = RL_ATTRIBUTE_FRAME) in vec4 frame;
layout(location = RL_ATTRIBUTE_UV0) in vec2 uv0;
layout(location = RL_ATTRIBUTE_UV1) in vec2 uv1;
layout(location = RL_ATTRIBUTE_COLOR) in vec4 color;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW0) in vec4 row0;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW1) in vec4 row1;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW2) in vec4 row2;
layout(location = RL_ATTRIBUTE_INSTANCE_INDICES) in uvec4 indices;
#if defined(MOVING)
layout(location = RL_ATTRIBUTE_PREVIOUS_ROW0) in vec4 previousRow0;
layout(location = RL_ATTRIBUTE_PREVIOUS_ROW1) in vec4 previousRow1;
layout(location = RL_ATTRIBUTE_PREVIOUS_ROW2) in vec4 previousRow2;
#endif

layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

// The forward pass draws the emission of moving surfaces where the depth is equal.
invariant gl_Position;

vec3 transform(vec4 a, vec4 b, vec4 c, vec4 p) { return vec3(dot(a, p), dot(b, p), dot(c, p)); }

void main() {
    vec4 local = vec4(position, 1.0);
    vec3 world = transform(row0, row1, row2, local);
    gl_Position = view.clipFromWorld * vec4(world, 1.0);
    surfaceMaterial = indices.x;
#if defined(ANY_TEXTURE)
#if defined(SECOND_UV)
    surfaceUv = vec4(uv0, uv1);
#else
    surfaceUv = uv0;
#endif
#endif
#if !defined(DEPTH_ONLY)
    // The cofactor matrix turns normals right under any scale, up to a sign that follows the determinant's.
    vec3 n = decodeFrameNormal(frame);
    vec3 cofactor0 = cross(row1.xyz, row2.xyz);
    vec3 cofactor1 = cross(row2.xyz, row0.xyz);
    vec3 cofactor2 = cross(row0.xyz, row1.xyz);
    vec3 normal = vec3(dot(cofactor0, n), dot(cofactor1, n), dot(cofactor2, n));
#if defined(MIRRORED)
    normal = -normal;
#endif
    surfaceNormal = normalize(normal);
#if defined(NORMAL_TEXTURE)
    vec4 tangent = decodeFrameTangent(frame);
    vec3 turned = normalize(transform(row0, row1, row2, vec4(tangent.xyz, 0.0)));
#if defined(MIRRORED)
    surfaceTangent = vec4(turned, -tangent.w);
#else
    surfaceTangent = vec4(turned, tangent.w);
#endif
#endif
#endif
#if defined(EXTENDED)
    surfaceColor = color;
#endif
#if defined(MOVING)
    surfaceClip = gl_Position;
    vec3 previousWorld = transform(previousRow0, previousRow1, previousRow2, local);
    surfacePreviousClip = view.previousClipFromWorld * vec4(previousWorld, 1.0);
#endif
#if defined(FORWARD) || defined(DECALS)
    surfacePosition = world - view.cameraPosition.xyz;
#endif
}
