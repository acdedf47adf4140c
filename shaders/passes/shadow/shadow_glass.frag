// What colours light, into a shadow map: the product of all that the light goes through before an opaque caster, and the depth
// where it first does.
#include "common/surface/material.glsl"
#include "common/shadow/glass_depth.glsl"

layout(location = 0) out vec4 passing;  // BlendMode::absorbing

void main() {
    Material material = loadMaterial();
#if defined(ALPHA_MASK)
    cutAlpha(material);
#endif
#if defined(PARALLEL_LIGHT)
    const bool parallel = true;
#else
    const bool parallel = false;
#endif
    passing = vec4(lightThrough(material), encodeGlassDepth(gl_FragCoord.z, parallel));
}
