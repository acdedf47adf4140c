// The mean of the 3x3 pixels that hold all of gtao.frag's pattern, as far as they are one surface. Device depth is linear
// over a plane's picture, so that a plane seen at whatever angle is predicted exactly.
#include "common/screen/screen_space.glsl"
#include "common/screen/occlusion_texel.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out vec4 occlusion;

// The smaller step to either side: the other may leap over an edge.
float slope(float before, float here, float after) {
    float a = here - before;
    float b = after - here;
    return abs(a) < abs(b) ? a : b;
}

void main() {
    ivec2 last = textureSize(source, 0) - 1;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 texels[9];
    for (int i = 0; i < 9; ++i) {
        ivec2 at = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        texels[i] = texelFetch(source, at, 0);
    }
    float depth = texels[4].w;
    vec2 gradient = vec2(slope(texels[3].w, depth, texels[5].w), slope(texels[1].w, depth, texels[7].w));
    float perTolerance = 1.0 / (depth * flatDepthDecode.z + flatDepthDecode.w);
    vec3 missing = vec3(0.0);
    float visible = 0.0;
    float total = 0.0;
    for (int i = 0; i < 9; ++i) {
        vec2 offset = vec2(float(i % 3) - 1.0, float(i / 3) - 1.0);
        float error = abs(texels[i].w - depth - dot(gradient, offset)) * perTolerance;
        float weight = clamp(2.0 - error, 0.0, 1.0) * (texels[i].w > 0.0 ? 1.0 : 0.0);
        missing += texels[i].rgb * weight;
        visible += occlusionVisible(texels[i].w) * weight;
        total += weight;
    }
    float scale = 1.0 / max(total, 1e-4);
    occlusion = vec4(missing * scale, depth > 0.0 ? packOcclusion(depth, visible * scale) : 0.0);
}
