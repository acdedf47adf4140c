#if defined(ALPHA_MASK)
#include "common/surface/material.glsl"
#endif

void main() {
#if defined(ALPHA_MASK)
    Material material = loadMaterial();
    cutAlpha(material);
#endif
}
