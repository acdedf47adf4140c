// Depth alone, from positions alone: casters of shadows.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

layout(location = RL_ATTRIBUTE_POSITION) in vec3 position;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW0) in vec4 row0;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW1) in vec4 row1;
layout(location = RL_ATTRIBUTE_INSTANCE_ROW2) in vec4 row2;

layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

void main() {
    vec4 local = vec4(position, 1.0);
    vec3 world = vec3(dot(row0, local), dot(row1, local), dot(row2, local));
    gl_Position = view.clipFromWorld * vec4(world, 1.0);
}
