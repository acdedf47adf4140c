// The varyings between surface.vert and the fragment shaders of surfaces.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"
#include "interop/surface_flags.h"

#if defined(VERTEX_STAGE)
#define SURFACE_VARYING out
#else
#define SURFACE_VARYING in
#endif

#if defined(BASE_COLOR_TEXTURE) || defined(METALLIC_ROUGHNESS_TEXTURE) || defined(NORMAL_TEXTURE) || \
    defined(OCCLUSION_TEXTURE) || defined(EMISSIVE_TEXTURE) || defined(TRANSMISSION_TEXTURE)
#define ANY_TEXTURE
#endif

layout(location = 0) flat SURFACE_VARYING uint surfaceMaterial;
#if defined(ANY_TEXTURE)
#if defined(SECOND_UV)
layout(location = 1) SURFACE_VARYING vec4 surfaceUv;
#else
layout(location = 1) SURFACE_VARYING vec2 surfaceUv;
#endif
#endif
#if !defined(DEPTH_ONLY)
layout(location = 2) SURFACE_VARYING vec3 surfaceNormal;
#if defined(NORMAL_TEXTURE)
layout(location = 3) SURFACE_VARYING vec4 surfaceTangent;
#endif
#endif
#if defined(EXTENDED)
layout(location = 4) SURFACE_VARYING vec4 surfaceColor;
#endif
#if defined(MOVING)
layout(location = 5) SURFACE_VARYING vec4 surfaceClip;
layout(location = 6) SURFACE_VARYING vec4 surfacePreviousClip;
#endif
#if defined(FORWARD) || defined(DECALS)
layout(location = 7) SURFACE_VARYING vec3 surfacePosition;  // relative to the camera
#endif
