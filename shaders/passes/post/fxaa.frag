// Anti-aliasing of the displayed picture by its luma: Lottes 2009, "FXAA", with the search distances of version 3.11's
// quality preset 12. LUMA_IN_ALPHA: the tone map left the sRGB luma in alpha and the result is opaque; else green stands
// for luma and alpha is filtered like the colours.
//
// No branch skips work on llvmpipe, but a loop ends when no pixel of a group goes on: the search is one.
#include "common/fullscreen.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out vec4 display;

#if defined(LUMA_IN_ALPHA)
#define LUMA_CHANNEL 3
#else
#define LUMA_CHANNEL 1
#endif

float lumaAt(vec2 at) { return textureLod(source, at, 0.0)[LUMA_CHANNEL]; }

const float kEdgeThreshold = 0.166;     // of the brightest neighbour
const float kEdgeThresholdMin = 0.0833; // darker contrast is not seen
const float kSubpixel = 0.75;

void main() {
    vec2 texel = flatSourceTexel.xy;
    // Gathers of the 2x2 blocks to the lower left and upper right; order: (0,1) (1,1) (1,0) (0,0).
    vec4 low = textureGather(source, uv - 0.5 * texel, LUMA_CHANNEL);
    vec4 high = textureGather(source, uv + 0.5 * texel, LUMA_CHANNEL);
    float west = low.x, middle = low.y, south = low.z, southWest = low.w;
    float north = high.x, northEast = high.y, east = high.z;
    // A gather of which one value is used still costs less than a bilinear sample.
    float northWest = textureGather(source, uv + vec2(-0.5, 0.5) * texel, LUMA_CHANNEL).x;
    float southEast = textureGather(source, uv + vec2(0.5, -0.5) * texel, LUMA_CHANNEL).z;

    float brightest = max(max(max(north, south), max(east, west)), middle);
    float darkest = min(min(min(north, south), min(east, west)), middle);
    float contrast = brightest - darkest;
    bool isEdge = contrast >= max(kEdgeThresholdMin, brightest * kEdgeThreshold);

    // Second derivatives across rows and across columns tell the edge's direction.
    float acrossRows = 2.0 * abs(north + south - 2.0 * middle) +
                       abs(northEast + southEast - 2.0 * east) +
                       abs(northWest + southWest - 2.0 * west);
    float acrossColumns = 2.0 * abs(east + west - 2.0 * middle) +
                          abs(northEast + northWest - 2.0 * north) +
                          abs(southEast + southWest - 2.0 * south);
    bool isHorizontal = acrossRows >= acrossColumns;

    float before = isHorizontal ? south : west;
    float after = isHorizontal ? north : east;
    float slopeBefore = abs(before - middle);
    float slopeAfter = abs(after - middle);
    bool towardsAfter = slopeAfter >= slopeBefore;
    vec2 across = isHorizontal ? vec2(0.0, texel.y) : vec2(texel.x, 0.0);
    if (!towardsAfter) across = -across;
    vec2 along = isHorizontal ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);

    // Walk both ways between the two rows of pixels until the luma there leaves the edge's.
    float edgeLuma = 0.5 * (middle + (towardsAfter ? after : before));
    float leave = 0.25 * max(slopeBefore, slopeAfter);
    vec2 start = uv + 0.5 * across;
    float distanceBack = 1.0, distanceForth = 1.0;
    float endBack = 0.0, endForth = 0.0;
    bool goesBack = isEdge, goesForth = isEdge;
    for (int i = 0; i < 5 && (goesBack || goesForth); ++i) {
        float lumaBack = lumaAt(start - along * distanceBack) - edgeLuma;
        float lumaForth = lumaAt(start + along * distanceForth) - edgeLuma;
        if (goesBack) endBack = lumaBack;
        if (goesForth) endForth = lumaForth;
        goesBack = goesBack && abs(lumaBack) < leave;
        goesForth = goesForth && abs(lumaForth) < leave;
        float stride = i == 0 ? 1.5 : i == 1 ? 2.0 : i == 2 ? 4.0 : i == 3 ? 12.0 : 0.0;
        if (goesBack) distanceBack += stride;
        if (goesForth) distanceForth += stride;
    }

    // Nearer to one end, and that end bends the other way than this pixel: shift towards the neighbour row.
    float nearest = min(distanceBack, distanceForth);
    float end = distanceBack < distanceForth ? endBack : endForth;
    bool bends = (end < 0.0) != (middle < edgeLuma);
    float shift = bends ? 0.5 - nearest / (distanceBack + distanceForth) : 0.0;

    // Single pixels and thin lines: blur by how far the pixel is from its neighbourhood's mean.
    float mean = (2.0 * (north + south + east + west) + northEast + northWest + southEast + southWest) *
                 (1.0 / 12.0);
    float apart = clamp(abs(mean - middle) / max(contrast, 1e-4), 0.0, 1.0);
    float smoothApart = (3.0 - 2.0 * apart) * apart * apart;
    shift = isEdge ? max(shift, smoothApart * smoothApart * kSubpixel) : 0.0;

    display = textureLod(source, uv + across * shift, 0.0);
#if defined(LUMA_IN_ALPHA)
    display.a = 1.0;
#endif
}
