// What a square of the atlas holds before the casters that move: nothing, or (FROM_LAYER) those that stand still.
#if defined(FROM_LAYER)
#include "interop/bindings.h"
layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2DArray layerDepths;

void main() {
    gl_FragDepth = texelFetch(layerDepths, ivec3(ivec2(gl_FragCoord.xy), 0), 0).x;
}
#else
void main() {}
#endif
