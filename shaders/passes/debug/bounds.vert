// Boxes as lines: 24 vertices each, from centres and half extents.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

layout(binding = RL_TEXTURE_LIGHTS) uniform samplerBuffer boxes;
layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

void main() {
    int box = gl_VertexID / 24;
    int edge = gl_VertexID % 24 / 2;
    int axis = edge / 4;
    // Along its axis the edge runs from -1 to 1; the other two coordinates are the bits of its number.
    float along = float(gl_VertexID & 1) * 2.0 - 1.0;
    float a = float(edge & 1) * 2.0 - 1.0;
    float b = float(edge >> 1 & 1) * 2.0 - 1.0;
    vec3 corner = axis == 0 ? vec3(along, a, b) : axis == 1 ? vec3(a, along, b) : vec3(a, b, along);
    vec3 world = texelFetch(boxes, box * 2).xyz + corner * texelFetch(boxes, box * 2 + 1).xyz;
    gl_Position = view.clipFromWorld * vec4(world, 1.0);
}
