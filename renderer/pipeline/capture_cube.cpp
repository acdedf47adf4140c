#include "renderer/pipeline/capture_cube.h"

#include "renderer/lighting/environment/equirect.h"

namespace rushlight {

// Seen from within, the columns of GL's faces run against the camera's right.
FrameInput captureInput(const FrameInput& input, const vec3& position, uint32_t face,
                        const CaptureDesc& desc) {
    const vec3 forward = cubeDirection(face, 0, 0);
    const vec3 up = forward - cubeDirection(face, 0, 1);
    FrameInput seen = input;
    const ViewHandle state = seen.view.state;
    seen.view = {};
    seen.view.state = state;
    seen.view.viewFromWorld = glm::lookAt(position, position + forward, up);
    seen.view.verticalFov = kPi / 2;
    seen.view.aspect = 1;
    seen.view.nearPlane = desc.nearPlane;
    seen.view.farPlane = desc.farPlane;
    seen.settings.reflections = false;
    seen.settings.debugView = DebugView::none;
    seen.overlay = {};
    seen.lighting.sunDisk.radiance = vec3(0);
    if (seen.lighting.environment) seen.lighting.background = Background::environment;
    return seen;
}

Result<CubeLevel> captureCube(const FrameInput& input, const vec3& position,
                              const CaptureDesc& desc, const FaceRenderer& render) {
    if (auto ok = checkCapture(position, desc); !ok) return tl::unexpected(ok.error());
    const uint32_t size = desc.size;
    CubeLevel cube(size);
    CapturedImage image;
    for (uint32_t face = 0; face < 6; ++face) {
        if (auto ok = render(captureInput(input, position, face, desc), size, image); !ok)
            return tl::unexpected(ok.error());
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const float* texel = &image.rgba32f[(size_t(y) * size + (size - 1 - x)) * 4];
                cube.at(face, x, y) = vec4(cleanRadiance({texel[0], texel[1], texel[2]}), 1);
            }
    }
    cube.fillBorders();
    return cube;
}

}  // namespace rushlight
