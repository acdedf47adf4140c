// Frames in flight, and the render-thread mode, on OpenGL.
#include "renderer/backend/gl/gl_device.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/random_scene.h"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <string_view>
#include <thread>

namespace rushlight {
namespace {

// ---- a driver that answers what the test wants
// -------------------------------------------------------------------

struct Driver {
    GLenum reset = GL_NO_ERROR;
    bool maps = true;
    bool slow = false;  ///< a fence is not signalled when asked the first time
    std::vector<GLsync> made, waited;
} driver;

template <class F>
F real(const char* name) {
    return reinterpret_cast<F>(TestContext::load(name));
}

GLenum APIENTRY resetStatus() { return driver.reset; }
void* APIENTRY mapRange(GLuint buffer, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    if (!driver.maps) return nullptr;
    return real<PFNGLMAPNAMEDBUFFERRANGEPROC>("glMapNamedBufferRange")(buffer, offset, size,
                                                                       access);
}
GLsync APIENTRY fenceSync(GLenum condition, GLbitfield flags) {
    driver.made.push_back(real<PFNGLFENCESYNCPROC>("glFenceSync")(condition, flags));
    return driver.made.back();
}
GLenum APIENTRY clientWait(GLsync fence, GLbitfield flags, GLuint64 timeout) {
    if (timeout == 0) driver.waited.push_back(fence);
    if (driver.slow && timeout == 0) return GL_TIMEOUT_EXPIRED;
    return real<PFNGLCLIENTWAITSYNCPROC>("glClientWaitSync")(fence, flags, 10'000'000'000);
}

void* loadDriver(const char* name) {
    const std::string_view text = name;
    if (text == "glGetGraphicsResetStatus") return reinterpret_cast<void*>(&resetStatus);
    if (text == "glMapNamedBufferRange") return reinterpret_cast<void*>(&mapRange);
    if (text == "glFenceSync") return reinterpret_cast<void*>(&fenceSync);
    if (text == "glClientWaitSync") return reinterpret_cast<void*>(&clientWait);
    return TestContext::load(name);
}

class FramesGl : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
        driver = {};
    }
    static std::unique_ptr<Renderer> renderer(uint32_t inFlight, bool thread,
                                              GlLoadFunction load = TestContext::load) {
        RendererDesc desc;
        desc.loadGl = load;
        desc.framesInFlight = inFlight;
        desc.renderThread = thread;
        desc.debugOutput = true;
        return std::move(Renderer::create(desc).value());
    }

private:
    TestContext context_;
};

// ---- the fences
// --------------------------------------------------------------------------------------------------

TEST_F(FramesGl, ASlotWaitsForTheFrameThatUsedItLast) {
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight)
        for (const bool slow : {false, true}) {
            driver = {};
            driver.slow = slow;
            const auto device = std::move(
                createGlDevice({.load = &loadDriver, .framesInFlight = inFlight}).value());
            CommandBuffer commands;
            commands.allocate(1000);
            ExecutionReport report;
            for (uint32_t frame = 0; frame < 10; ++frame) {
                driver.waited.clear();
                if (frame == 5)
                    commands.allocate(3 << 20);  // a larger ring, whose slots nothing uses yet
                device->execute(commands, {}, report);
                ASSERT_EQ(driver.made.size(), frame + 1);
                const bool first = frame < inFlight || (frame >= 5 && frame < 5 + inFlight);
                if (first) {
                    EXPECT_TRUE(driver.waited.empty()) << frame;
                    EXPECT_EQ(report.waits, 0u) << frame;
                } else {
                    EXPECT_EQ(driver.waited, std::vector{driver.made[frame - inFlight]}) << frame;
                    EXPECT_EQ(report.waits, slow ? 1u : 0u) << frame;
                }
            }
            device->finish();
        }
}

// ---- the same pictures
// -------------------------------------------------------------------------------------------

struct Step {
    uint32_t frame, width, height;
    CaptureKind kind = CaptureKind::display;
};

/// Renders all steps, then takes the pictures: as many frames are under way as may be.
std::vector<CapturedImage> capture(Renderer& renderer, const std::vector<Step>& steps) {
    RandomScene scene(renderer, 2);
    std::vector<CaptureTicket> tickets;
    for (const Step& step : steps) {
        const auto ticket = renderer.renderOffscreen(scene.frame(step.frame), step.width,
                                                     step.height, step.kind);
        EXPECT_TRUE(ticket) << ticket.error().text();
        tickets.push_back(ticket.value_or(CaptureTicket{}));
        EXPECT_TRUE(renderer.render(scene.frame(step.frame), {0, 0, 0})) << "minimised in between";
    }
    std::vector<CapturedImage> images(steps.size());
    for (size_t i = 0; i < steps.size(); ++i)
        EXPECT_TRUE(renderer.takeCapture(tickets[i], true, images[i])) << i;
    EXPECT_EQ(renderer.takeDebugMessages(), std::vector<std::string>{});
    return images;
}

/// The same with this thread serving.
std::vector<CapturedImage> captureThreaded(Renderer& renderer, const std::vector<Step>& steps) {
    std::vector<CapturedImage> images;
    std::thread game([&] {
        images = capture(renderer, steps);
        renderer.stopServing();
    });
    EXPECT_TRUE(renderer.serve());
    game.join();
    return images;
}

void expectSame(const std::vector<CapturedImage>& a, const std::vector<CapturedImage>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].width, b[i].width) << i;
        EXPECT_TRUE(a[i].rgba8 == b[i].rgba8) << i;
        EXPECT_TRUE(a[i].rgba32f == b[i].rgba32f) << i;
    }
}

TEST_F(FramesGl, PicturesAreTheSameInBothModesForAnyNumberOfFrames) {
    const std::vector<Step> steps = {{0, 160, 90}, {1, 160, 90}, {2, 160, 90, CaptureKind::hdr},
                                     {3, 160, 90}, {4, 160, 90}, {5, 160, 90}};
    const auto expected = capture(*renderer(2, false), steps);
    EXPECT_FALSE(expected[0].rgba8 == expected[1].rgba8) << "the frames are all alike";
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight) {
        SCOPED_TRACE(inFlight);
        expectSame(capture(*renderer(inFlight, false), steps), expected);
        expectSame(capture(*renderer(inFlight, true), steps), expected);  // nobody serves: direct
        expectSame(captureThreaded(*renderer(inFlight, true), steps), expected);
    }
}

TEST_F(FramesGl, SizesMayChangeFromFrameToFrame) {
    std::vector<Step> steps;
    for (uint32_t i = 0; i < 12; ++i) steps.push_back({0, 40 + 37 * (i % 5), 30 + 11 * (i % 3)});
    steps.push_back(steps[0]);
    const auto direct = capture(*renderer(2, false), steps);
    EXPECT_TRUE(direct.front().rgba8 == direct.back().rgba8)
        << "what a frame shows depends on earlier sizes";
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight)
        expectSame(captureThreaded(*renderer(inFlight, true), steps), direct);
}

// ---- the context is lost
// -----------------------------------------------------------------------------------------

TEST_F(FramesGl, ALostDeviceExecutesNothing) {
    const auto device = std::move(createGlDevice({.load = &loadDriver}).value());
    CommandBuffer commands;
    ExecutionReport report;
    device->execute(commands, {}, report);
    EXPECT_TRUE(device->status());
    EXPECT_GT(report.glCalls, 10u);
    const size_t fences = driver.made.size();
    driver.reset = GL_GUILTY_CONTEXT_RESET;
    device->execute(commands, {}, report);
    EXPECT_EQ(driver.made.size(), fences);
    EXPECT_EQ(report.glCalls, 0u);
    EXPECT_FALSE(device->status());
    driver.reset = GL_NO_ERROR;
    EXPECT_FALSE(device->status()) << "it stays lost";
}

void loseContext(Renderer& renderer) {
    RandomScene scene(renderer, 2);
    const auto before = renderer.renderOffscreen(scene.frame(0), 64, 36, CaptureKind::display);
    ASSERT_TRUE(before);
    renderer.finish();
    driver.reset = GL_INNOCENT_CONTEXT_RESET;
    driver.maps = false;
    CapturedImage image;
    EXPECT_FALSE(renderer.takeCapture(*before, true, image));
    (void)renderer.renderOffscreen(scene.frame(1), 64, 36, CaptureKind::display);  // may be the one
                                                                                   // that finds out
    renderer.finish();
    driver.reset = GL_NO_ERROR;  // the reset is over
    for (int i = 0; i < 5; ++i) {
        const auto after = renderer.renderOffscreen(scene.frame(2), 64, 36, CaptureKind::display);
        ASSERT_FALSE(after);
        EXPECT_EQ(after.error().kind, ErrorKind::noContext);
        EXPECT_NE(after.error().message.find("reset"), std::string::npos) << after.error().message;
    }
    EnvironmentDesc environment;
    const std::vector<vec3> sky(32 * 16, vec3(1));
    environment.width = 32, environment.height = 16, environment.pixels = sky;
    EXPECT_FALSE(renderer.createEnvironment(environment)) << "it makes textures";
    (void)renderer.report();
}

TEST_F(FramesGl, ALostContextIsAnErrorAndNoCrash) { loseContext(*renderer(2, false, loadDriver)); }

TEST_F(FramesGl, ALostContextIsAnErrorWithARenderThreadToo) {
    const auto lost = renderer(2, true, loadDriver);
    std::thread game([&] {
        loseContext(*lost);
        lost->stopServing();
    });
    EXPECT_TRUE(lost->serve());
    game.join();
}

}  // namespace
}  // namespace rushlight
