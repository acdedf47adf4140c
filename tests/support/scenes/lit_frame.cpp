#include "tests/support/scenes/lit_frame.h"

#include <algorithm>

namespace rushlight {

vec3 pixelOf(const CapturedImage& image, uint32_t x, uint32_t y) {
    const float* p = &image.rgba32f[(size_t(y) * image.width + x) * 4];
    return {p[0], p[1], p[2]};
}

void LitFrame::SetUp() {
    ASSERT_TRUE(context.valid()) << "no EGL surfaceless context";
    RendererDesc desc;
    desc.cacheDirectory = cache.path();
    desc.loadGl = TestContext::load;
    desc.debugOutput = true;
    desc.validateCommands = true;
    renderer = std::move(Renderer::create(desc).value());
    input.settings.bloom = false;
    input.settings.smallObjectPixels = 0;
}

void LitFrame::TearDown() {
    if (!renderer) return;
    for (const std::string& message : renderer->takeDebugMessages())
        ADD_FAILURE() << "OpenGL says: " << message;
}

CapturedImage LitFrame::render(CaptureKind kind) {
    if (!instances.empty()) input.instances = instances;
    CapturedImage image;
    const auto ticket = renderer->renderOffscreen(input, width, height, kind);
    EXPECT_TRUE(ticket) << ticket.error().text();
    EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
    return image;
}

bool LitFrame::hasPass(std::string_view name) const {
    return std::ranges::any_of(renderer->report().passes, [&](const PassReport& pass) {
        return std::string_view(pass.name).starts_with(name);
    });
}

Instance& LitFrame::addBox(const vec3& center, const vec3& halfSize, MaterialHandle material) {
    if (!cube_) cube_ = *renderer->createMesh(makeCube().desc("box"));
    Instance box;
    box.mesh = cube_;
    box.material = material;
    for (int c = 0; c < 3; ++c) box.worldFromLocal[c] *= halfSize[c];
    box.worldFromLocal[3] = center;
    return instances.emplace_back(box);
}

MaterialHandle LitFrame::glowing(const vec3& radiance) {
    MaterialDesc desc;
    desc.baseColor = vec4(radiance, 1);
    desc.unlit = true;
    return *renderer->createMaterial(desc);
}

void LitFrame::lookDown(float half, float eyeHeight) {
    input.view.viewFromWorld = glm::lookAt(vec3(0, eyeHeight, 0), vec3(0), vec3(0, 0, -1));
    input.view.perspective = false;
    input.view.orthoHalfHeight = half;
    input.view.farPlane = 20;
}

}  // namespace rushlight
