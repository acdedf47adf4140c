// Sums the fog's slices from the eye: the rows before, whose last slices hold all of each, and this one's.
#include "common/light/lighting_block.glsl"
#include "common/screen/fog.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D blocks;

layout(location = 0) out vec4 fog;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 grid = ivec2(L_FOG_GRID.xy);
    int last = at.x % grid.x + (RL_FOG_COLUMNS - 1) * grid.x;
    fog = vec4(0.0);
    for (int y = at.y % grid.y; y < at.y; y += grid.y)
        fog = fogBefore(fog, texelFetch(blocks, ivec2(last, y), 0));
    fog = fogBefore(fog, texelFetch(blocks, at, 0));
}
