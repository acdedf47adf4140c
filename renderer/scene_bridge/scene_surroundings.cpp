#include "renderer/scene_bridge/scene_surroundings.h"

#include "renderer/lighting/environment/cube_image.h"
#include "renderer/lighting/environment/equirect.h"

#include <algorithm>

namespace rushlight {

PrefilteredEnvironmentDesc environmentOf(const assets::ImageBasedLight& light) {
    PrefilteredEnvironmentDesc desc;
    desc.label = light.name.empty() ? std::string_view("image-based light") : light.name;
    desc.size = light.size;
    desc.levels = light.levels;
    desc.texels = light.texels;
    desc.irradiance = light.irradiance;
    desc.rotation = light.rotation;
    return desc;
}

std::vector<vec3> equirectOf(const assets::ImageBasedLight& light, uint32_t maxWidth, uvec2& size) {
    CubeLevel cube(light.size);
    const vec3* texel = light.texels.data();
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < light.size; ++y)
            for (uint32_t x = 0; x < light.size; ++x) cube.at(face, x, y) = vec4(*texel++, 1);
    cube.fillBorders();
    const uint32_t width = std::min(4 * light.size, maxWidth);
    size = {width, width / 2};
    std::vector<vec3> pixels;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const vec3 d = equirectDirection((float(x) + 0.5f) / float(size.x),
                                             (float(y) + 0.5f) / float(size.y));
            pixels.push_back(vec3(cube.sample(glm::conjugate(light.rotation) * d)));
        }
    return pixels;
}

std::vector<ReflectionProbe> reflectionProbesOf(const assets::Model& model,
                                                const std::vector<int>& nodes,
                                                const std::vector<mat4>& world,
                                                std::vector<CaptureDesc>& captures,
                                                std::vector<std::string>& notes) {
    std::vector<ReflectionProbe> probes;
    captures.clear();
    for (const assets::ReflectionProbe& from : model.reflectionProbes) {
        if (std::ranges::find(nodes, from.node) == nodes.end()) continue;
        const mat4& place = world[size_t(from.node)];
        mat3 axes(place);
        vec3 scale;
        for (int i = 0; i < 3; ++i) {
            scale[i] = glm::length(axes[i]);
            axes[i] /= std::max(scale[i], 1e-20f);
        }
        if (glm::determinant(axes) < 0) axes[0] = -axes[0];  // a box is its own mirror image
        ReflectionProbe probe;
        probe.position = vec3(place[3]);
        probe.center = vec3(place * vec4(from.offset, 1));
        probe.halfSize = from.size * scale * 0.5f;
        probe.rotation = glm::normalize(glm::quat_cast(axes));
        probe.blend = from.blend * scale;
        probe.intensity = from.intensity;
        const bool sheared = std::abs(glm::determinant(axes) - 1) > 1e-3f;
        if (sheared || probes.size() == kMaxReflectionProbes ||
            !checkReflectionProbes({&probe, 1})) {
            notes.push_back(
                "The reflection probe of node " + std::to_string(from.node) +
                " is left out: its box is sheared or has no size, or there are over 256.");
            continue;
        }
        CaptureDesc capture;
        capture.size = from.resolution;
        captures.push_back(capture);
        probes.push_back(probe);
    }
    return probes;
}

}  // namespace rushlight
