// RL_UNIFORMS_PASS of the passes that look things up in the image of the scene: ambient occlusion,
// reflections. C++ fills it, common/screen/screen_space.glsl hands it on as flat varyings.
// std140-safe: vec4 alone.
#ifndef RL_INTEROP_SCREEN_UNIFORMS_H
#define RL_INTEROP_SCREEN_UNIFORMS_H

#include "interop/interop.h"

#ifndef GLSL
#include <cstddef>
#endif

RL_INTEROP_BEGIN

/// View space: x to the right, y up, z towards the eye; the camera looks along -z. Texels are of
/// the full-size image.
struct ScreenUniforms {
    vec4 viewFromTexel;  ///< perspective: view xy = (texel * xy + zw) * view depth; orthographic:
                         ///< without the factor
    vec4 depthDecode;  ///< xy: as LightingUniforms; zw: device depths further apart than d * z + w
                       ///< are not one surface
    vec4 size;  ///< xy: width and height in texels; zw: texels that a metre spans, at 1 m from the
                ///< eye (or at all)
    vec4 right, up, back;  ///< xyz: the axes of view space in the world; w of right and up: width
                           ///< and height at half the size, of back: see the pass
    vec4 settings;         ///< see the pass
};

RL_INTEROP_END

#ifndef GLSL
static_assert(sizeof(rushlight::interop::ScreenUniforms) == 112);
static_assert(offsetof(rushlight::interop::ScreenUniforms, settings) == 96);
#endif

#endif
