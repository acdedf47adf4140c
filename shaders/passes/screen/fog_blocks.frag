// Sums the fog's slices from the eye, first within each row of slices of the image.
#include "common/light/lighting_block.glsl"
#include "common/screen/fog.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D slices;

layout(location = 0) out vec4 fog;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int width = int(L_FOG_GRID.x);
    fog = vec4(0.0);
    for (int x = at.x % width; x <= at.x; x += width)
        fog = fogBefore(fog, texelFetch(slices, ivec2(x, at.y), 0));
}
