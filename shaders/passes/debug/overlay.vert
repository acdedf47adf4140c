// User-interface triangles; positions in pixels from the top left.
#include "interop/bindings.h"
#include "interop/uniforms.h"

layout(location = RL_ATTRIBUTE_POSITION) in vec2 position;
layout(location = RL_ATTRIBUTE_UV0) in vec2 uv0;
layout(location = RL_ATTRIBUTE_COLOR) in vec4 color;

layout(std140, binding = RL_UNIFORMS_PASS) uniform PassBlock { PassUniforms pass; };

layout(location = 0) out vec3 overlayUv;
layout(location = 1) out vec4 overlayColor;

void main() {
    overlayUv = vec3(uv0, pass.settings.y);
    overlayColor = color;
    vec2 clip = position * pass.sourceTexel.xy - 1.0;
    gl_Position = vec4(clip.x, pass.settings.x > 0.5 ? clip.y : -clip.y, 0.5, 1.0);
}
