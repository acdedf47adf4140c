// What a driver may do that the one of these tests does not: a clock that is known, and names that
// come back at once.

#include "tests/support/gl/played_gl.h"
#include "renderer/backend/gl/gl_device.h"
#include "renderer/renderer.h"
#include "shaders/interop/bindings.h"
#include "tests/support/gl/test_context.h"

#include <gtest/gtest.h>

#include <cstring>

namespace rushlight {
namespace {

constexpr uint32_t kSize = 8;
constexpr uint64_t kSecond = 1'000'000'000;
constexpr uint64_t kBegan = 5'000'000'000'000;  // the GPU's clock counts from when it likes

class PlayedGlTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
        PlayedGl::reset();
        shaders_.write("place.vert",
                       "layout(location = 0) in vec3 position;\n"
                       "void main() { gl_Position = vec4(position.xy, 0.5, 1.0); }\n");
        shaders_.write(
            "white.frag",
            "layout(location = 0) out vec4 result;\nvoid main() { result = vec4(1.0); }\n");
        device_ = std::move(
            createGlDevice(
                {.load = &PlayedGl::load, .shaderDirectory = shaders_.path(), .debugOutput = true})
                .value());
        target_ = device_
                      ->createTexture(
                          {"target", TextureKind::texture2d, Format::rgba8, kSize, kSize, 1, 1})
                      .value();
    }
    void TearDown() override {
        if (device_) {
            EXPECT_EQ(device_->takeDebugMessages(), std::vector<std::string>{});
        }
    }

    void begin(uint32_t index, const char* name) {
        BeginPass pass;
        std::strcpy(pass.name, name);
        pass.passIndex = index;
        pass.width = pass.height = kSize;
        pass.colorCount = 1;
        pass.colors[0] = {target_, 0, 0, LoadOp::clear, {}, vec4(0)};
        commands_.push(pass);
    }
    void execute() {
        options_.frame = ++frame_;
        device_->execute(commands_, options_, report_);
        commands_.clear();
    }

    // ---- times ----
    void drawPasses(std::initializer_list<const char*> names) {
        uint32_t index = 0;
        for (const char* name : names) {
            begin(index, name);
            commands_.push(EndPass{index++});
        }
        execute();
    }
    std::vector<double> times() const {
        std::vector<double> all;
        for (const PassExecution& pass : report_.passes) all.push_back(pass.gpuMs);
        return all;
    }

    // ---- names ----
    template <class T>
    BufferHandle buffer(std::initializer_list<T> values, BufferUsage usage) {
        const BufferHandle made =
            device_->createBuffer({"given again", values.size() * sizeof(T), usage}).value();
        device_->write(made, 0, std::as_bytes(std::span(values.begin(), values.size())));
        return made;
    }
    BufferHandle triangle(float size) {
        return buffer<vec3>({{-size, -size, 0}, {3 * size, -size, 0}, {-size, 3 * size, 0}},
                            BufferUsage::vertex);
    }
    /// Is anything drawn in the middle?
    bool isSeen(BufferHandle vertices, BufferHandle indices) {
        PipelineDesc desc;
        desc.vertexShader = "place.vert";
        desc.fragmentShader = "white.frag";
        desc.layout = VertexLayout::position;
        if (!pipeline_) pipeline_ = device_->createPipeline(desc).value();
        const BufferRange instance = commands_.append(std::span<const InstanceData>(&instance_, 1));
        begin(0, "triangle");
        commands_.push(SetPipeline{pipeline_});
        commands_.push(SetVertexStream{RL_STREAM_POSITION, sizeof(vec3), {vertices, 0, 0, 36}});
        commands_.push(SetVertexStream{RL_STREAM_INSTANCE, sizeof(InstanceData), instance});
        commands_.push(SetIndexStream{{indices, 0, 0, 12}});
        commands_.push(DrawIndexed{{3, 1, 0, 0, 0}});
        commands_.push(EndPass{0});
        commands_.push(Readback{target_, 0, 0, ++ticket_});
        execute();
        ReadbackImage image;
        EXPECT_TRUE(device_->takeReadback(ticket_, true, image));
        return image.bytes[(kSize / 2 * kSize + kSize / 2) * 4] != std::byte{0};
    }

    TestContext context_;
    TemporaryDirectory shaders_;
    std::unique_ptr<Device> device_;
    TextureHandle target_;
    PipelineHandle pipeline_;
    InstanceData instance_{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, 0, 0, 0, 0};
    CommandBuffer commands_;
    ExecutionReport report_;
    ExecuteOptions options_;
    uint64_t frame_ = 0;
    uint32_t ticket_ = 0;
};

// Passes of 2.5, 0.25 and 12 ms with half a millisecond between them.
TEST_F(PlayedGlTest, EachPassTakesWhatTheClockSays) {
    PlayedGl::clock = [](uint32_t number) {
        constexpr uint64_t kMicroseconds[] = {0, 2500, 3000, 3250, 3750, 15750};
        return kBegan + kMicroseconds[number % 6] * 1000;
    };
    drawPasses({"first", "second", "third"});
    EXPECT_EQ(times(), (std::vector<double>{0, 0, 0})) << "no frame is finished";
    EXPECT_EQ(report_.gpuFrame, kNoFrame);
    drawPasses({"first", "second", "third"});
    EXPECT_EQ(times(), (std::vector<double>{2.5, 0.25, 12}));
    EXPECT_EQ(report_.gpuFrame, 1u);
    drawPasses({"third", "first", "second"});
    EXPECT_EQ(times(), (std::vector<double>{12, 2.5, 0.25})) << "times go by the passes' names";
}

TEST_F(PlayedGlTest, TimesAreOfTheNewestFrameThatIsFinished) {
    PlayedGl::clock = [](uint32_t number) {  // the n-th frame, from 1, takes n ms
        return kBegan + number / 2 * 100'000'000 + (number % 2) * (number / 2 + 1) * 1'000'000;
    };
    PlayedGl::timesAreThere = false;
    for (int frame = 0; frame < 3; ++frame) {
        drawPasses({"pass"});
        EXPECT_EQ(times(), std::vector<double>{0});
    }
    PlayedGl::timesAreThere = true;
    drawPasses({"pass"});
    EXPECT_EQ(times(), std::vector<double>{3});
    EXPECT_EQ(report_.gpuFrame, 3u);
    PlayedGl::timesAreThere = false;
    drawPasses({"pass"});
    EXPECT_EQ(times(), std::vector<double>{3});
    EXPECT_EQ(report_.gpuFrame, 3u);
}

// A pass that begins an hour after the frame: on a CPU the two clocks are compared some
// microseconds after it began.
TEST_F(PlayedGlTest, PassesBeginOnTheCpusClock) {
    PlayedGl::now = int64_t(kBegan);
    PlayedGl::clock = [](uint32_t number) { return kBegan + (3600 + number) * kSecond; };
    for (int frame = 0; frame < 2; ++frame) drawPasses({"first", "second"});
    constexpr double kFirst = 3600e3, kStep = 2e3;  // ms
    EXPECT_NEAR(report_.passes[0].gpuBeginMs, kFirst, 1e3);
    EXPECT_NEAR(report_.passes[1].gpuBeginMs - report_.passes[0].gpuBeginMs, kStep, 1e-3);
    EXPECT_EQ(PlayedGl::askedNow, 1u);
    // The clocks part by an hour; it shows when they are compared again.
    PlayedGl::now += 3600 * int64_t(kSecond);
    PlayedGl::clock = [](uint32_t) { return kBegan + 7200 * kSecond; };
    while (PlayedGl::askedNow < 2) {
        ASSERT_LT(frame_, 100u);
        drawPasses({"first"});
        if (frame_ > 4) {
            EXPECT_NEAR(report_.passes[0].gpuBeginMs, 2 * kFirst, 60e3) << frame_;
        }
    }
    EXPECT_EQ(frame_, 65u);
    drawPasses({"first"});
    EXPECT_NEAR(report_.passes[0].gpuBeginMs, kFirst, 60e3);
}

TEST_F(PlayedGlTest, AClockThatGoesBackMeasuresNothing) {
    PlayedGl::clock = [](uint32_t number) { return kBegan - number * 1000; };
    for (int frame = 0; frame < 2; ++frame) drawPasses({"pass"});
    EXPECT_EQ(times(), std::vector<double>{0});
}

// The k-th pass of a frame takes k + 1 microseconds, and so says the renderer.
TEST_F(PlayedGlTest, TheRenderersReportAddsThemUp) {
    PlayedGl::clock = [](uint32_t number) {
        static uint64_t now = kBegan;
        static uint32_t pass = 0;
        if (number == 0) now = kBegan, pass = 0;
        return now += number % 2 ? 1000 * ++pass : 700;
    };
    RendererDesc desc;
    desc.loadGl = PlayedGl::load;
    const auto renderer = std::move(Renderer::create(desc).value());
    const auto draw = [&] {
        ASSERT_TRUE(renderer->renderOffscreen({}, 32, 32, CaptureKind::display));
        renderer->finish();
    };
    draw();
    const size_t passes = renderer->report().passes.size();
    ASSERT_GT(passes, 2u);
    draw();
    ASSERT_EQ(renderer->report().passes.size(), passes);
    for (size_t i = 0; i < passes; ++i)
        EXPECT_DOUBLE_EQ(renderer->report().passes[i].gpuMs, double(i + 1) * 1e-3)
            << renderer->report().passes[i].name;
    EXPECT_NEAR(renderer->report().gpuMs, double(passes * (passes + 1)) * 0.5e-3, 1e-9);
}

// The second of each is another buffer of the same name; what the first held is not to be seen in
// it.
TEST_F(PlayedGlTest, AnIndexBufferInThePlaceOfADestroyedOneIsBoundAnew) {
    const BufferHandle vertices = triangle(1);
    const BufferHandle nothing = buffer<uint32_t>({0, 0, 0}, BufferUsage::index);
    EXPECT_FALSE(isSeen(vertices, nothing));
    device_->destroy(nothing);
    const BufferHandle all = buffer<uint32_t>({0, 1, 2}, BufferUsage::index);
    EXPECT_EQ(PlayedGl::namesGivenAgain, 1u);
    EXPECT_TRUE(isSeen(vertices, all));
}

TEST_F(PlayedGlTest, AVertexBufferInThePlaceOfADestroyedOneIsBoundAnew) {
    const BufferHandle indices = buffer<uint32_t>({0, 1, 2}, BufferUsage::index);
    const BufferHandle point = triangle(0);
    EXPECT_FALSE(isSeen(point, indices));
    device_->destroy(point);
    const BufferHandle all = triangle(1);
    EXPECT_EQ(PlayedGl::namesGivenAgain, 1u);
    EXPECT_TRUE(isSeen(all, indices));
}

}  // namespace
}  // namespace rushlight
