#if defined(ALPHA_MASK)
#include "common/surface/material.glsl"
#endif

layout(location = 0) out vec4 count;

void main() {
#if defined(ALPHA_MASK)
    Material material = loadMaterial();
    cutAlpha(material);
#endif
    count = vec4(1.0);
}
