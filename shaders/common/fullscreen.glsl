// The varyings of common/fullscreen.vert. Constants come as flat varyings, not from the block: on llvmpipe fragments
// read those three times as fast.
#include "interop/bindings.h"
#include "interop/uniforms.h"

#if defined(VERTEX_STAGE)
#define FULLSCREEN_VARYING out
#else
#define FULLSCREEN_VARYING in
#endif

layout(location = 0) FULLSCREEN_VARYING vec2 uv;
layout(location = 1) flat FULLSCREEN_VARYING vec4 flatSourceTexel;
layout(location = 2) flat FULLSCREEN_VARYING vec4 flatSettings;
layout(location = 3) flat FULLSCREEN_VARYING vec4 flatCounts;
