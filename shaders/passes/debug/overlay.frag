// Coverage from the image's alpha times the vertex colour; sRGB in and out, blended premultiplied.
#include "interop/bindings.h"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2DArray coverage;

layout(location = 0) in vec3 overlayUv;
layout(location = 1) in vec4 overlayColor;

layout(location = 0) out vec4 display;

void main() {
    float alpha = overlayColor.a * textureLod(coverage, overlayUv, 0.0).a;
    display = vec4(overlayColor.rgb * alpha, alpha);
}
