// RL_UNIFORMS_PASS of the passes after lighting: C++ fills them, GLSL reads them in the full-screen
// vertex shader (common/fullscreen.vert), which hands them on as flat varyings. std140-safe: vec4
// alone.
#ifndef RL_INTEROP_UNIFORMS_H
#define RL_INTEROP_UNIFORMS_H

#include "interop/interop.h"

#ifndef GLSL
#include <cstddef>
#endif

RL_INTEROP_BEGIN

/// For every pass after lighting; what each vector means to which:
///
///                  sourceTexel               settings                                 counts
///     bloom        xy: 1 / source size       x: share of the coarser level            -
///     luminance    xy: 1 / source size       -                                        -
///     exposure     -                         x: 1 - exp(-dt * speed), y: lowest and   -
///                                            z: highest factor, w: mean aimed at
///     tonemap      -                         x: bloom's share, y: exposure factor     -
///     fxaa         xy: 1 / source size       -                                        -
///     overlay      xy: 2 / target size       x: 1: rows from the top, y: array layer  -
///     debug view   xy: 1 / target size       depth: x: nearest, y: farthest shown     clusters:
///     clusterCounts
///                  zw: depthDecode           clusters: clusterMapping                 shadow: x:
///                  cells, y: cascades (of LightingUniforms)     shadow: x: a cell's width over
///                  height
///
/// counts.w of every full-screen pass: 1 turns the picture upside down, for hosts that read rows
/// from the top.
struct PassUniforms {
    vec4 sourceTexel;
    vec4 settings;
    vec4 counts;
};

RL_INTEROP_END

#ifndef GLSL
static_assert(sizeof(rushlight::interop::PassUniforms) == 48);
static_assert(offsetof(rushlight::interop::PassUniforms, counts) == 32);
#endif

#endif
