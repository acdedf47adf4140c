#pragma once
// Frames of a RayScene with one pass shown, and the rays of their pixels.

#include "renderer/geometry/view_math.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/ray_scene.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rushlight {

class ScreenFrames : public testing::Test {
protected:
    static constexpr uint32_t kWidth = 256, kHeight = 192;

    void SetUp() override {
        ASSERT_TRUE(context.valid()) << "no EGL surfaceless context";
        open(nullptr);
    }
    void TearDown() override {
        if (!renderer) return;
        for (const std::string& message : renderer->takeDebugMessages())
            ADD_FAILURE() << "OpenGL says: " << message;
    }
    void open(JobSystem* jobs) {
        RendererDesc desc;
        desc.cacheDirectory = cache.path();  // shaders are compiled once
        desc.loadGl = TestContext::load;
        desc.jobs = jobs;
        desc.debugOutput = true;
        desc.validateCommands = true;
        renderer = std::move(Renderer::create(desc).value());
        scene = std::make_unique<RayScene>(*renderer);
    }
    void look(vec3 eye, vec3 target) {
        input.view.viewFromWorld = glm::lookAt(
            eye, target,
            std::abs(glm::normalize(target - eye).y) > 0.99f ? vec3(0, 0, 1) : vec3(0, 1, 0));
    }
    CapturedImage render(CaptureKind kind) {
        input.instances = scene->instances();
        const auto ticket = renderer->renderOffscreen(input, kWidth, kHeight, kind);
        CapturedImage image;
        EXPECT_TRUE(ticket) << ticket.error().text();
        EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
        return image;
    }
    bool hasPass(const std::string& name) const {
        return std::ranges::any_of(renderer->report().passes,
                                   [&](const PassReport& pass) { return pass.name == name; });
    }
    CameraMatrices camera() const {
        return *makeCamera(input.view, float(kWidth) / float(kHeight));
    }
    struct Seen {
        vec3 position, normal, view;
        uint32_t object;
    };
    /// Of the pixel's centre; rows count from the top, as those of a CapturedImage.
    std::optional<Seen> seenAt(const CameraMatrices& view, uint32_t x, uint32_t y) const {
        const vec2 uv((float(x) + 0.5f) / float(kWidth), 1 - (float(y) + 0.5f) / float(kHeight));
        const vec3 nearBy = view.relativePosition(uv, 0);
        const vec3 direction = glm::normalize(view.relativePosition(uv, 1) - nearBy);
        const auto hit = scene->cast(view.position + nearBy, direction);
        if (!hit) return {};
        return Seen{view.position + nearBy + direction * hit->distance, hit->normal, -direction,
                    hit->object};
    }

    TestContext context;
    TemporaryDirectory cache;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<RayScene> scene;
    FrameInput input;
};

}  // namespace rushlight
