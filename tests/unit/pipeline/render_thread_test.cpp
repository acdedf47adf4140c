// The render-thread mode with no GPU: the test's own thread serves, another one plays the game.
#include "renderer/pipeline/frame_pipeline.h"
#include "renderer/rhi/threaded_device.h"
#include "tests/support/frame_recorder.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

namespace rushlight {
namespace {

using namespace std::chrono_literals;

constexpr FrameTarget kTarget{0, 320, 200};

// Cubes that come and go under a sun: frames that differ in commands and in data.
class Cubes {
public:
    explicit Cubes(FramePipeline& frames)
        : frames_(frames), mesh_(*frames.stores.geometry.create(makeCube().desc())) {}

    void render(uint32_t frame) {
        Random random(frame);
        instances_.resize(random.below(20));
        for (Instance& instance : instances_) {
            instance.mesh = mesh_;
            instance.worldFromLocal[3] = random.vector(-5, 5) - vec3(0, 0, 10);
        }
        const DirectionalLight sun{glm::normalize(vec3(-1, -2, random.uniform(-1, 1)))};
        FrameInput input;
        input.instances = instances_;
        input.lighting.directional = {&sun, random.below(2)};
        input.settings.bloom = random.below(2);
        const auto rendered = frames_.render(input, kTarget, nullptr, {});
        EXPECT_TRUE(rendered) << rendered.error().text();
    }

private:
    FramePipeline& frames_;
    MeshHandle mesh_;
    std::vector<Instance> instances_;
};

std::vector<uint64_t> directFrames(uint32_t count) {
    FrameRecorder::Log log;
    FrameRecorder device(log);
    SerialJobs jobs;
    FramePipeline frames(device, jobs, {}, "");
    Cubes cubes(frames);
    for (uint32_t i = 0; i < count; ++i) cubes.render(i);
    return log.frames;
}

TEST(RenderThread, AThousandFramesAreTheSameBytesInTheSameOrder) {
    constexpr uint32_t kFrames = 1000;
    const std::vector<uint64_t> direct = directFrames(kFrames);
    ASSERT_EQ(direct.size(), kFrames);
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight) {
        FrameRecorder::Log log;
        ThreadedDevice device(std::make_unique<FrameRecorder>(log), inFlight);
        SerialJobs jobs;
        FramePipeline frames(device, jobs, {}, "");
        std::thread game([&] {
            ASSERT_TRUE(device.enter());
            Cubes cubes(frames);
            for (uint32_t i = 0; i < kFrames; ++i) {
                cubes.render(i);
                const FrameReport& report = frames.report();
                ASSERT_EQ(report.frameNumber, i);
                if (report.executedFrame == FrameReport::kNone) {
                    ASSERT_LT(i, inFlight);
                    continue;
                }
                ASSERT_LE(report.executedFrame, i);
                ASSERT_GE(report.executedFrame + inFlight, i);
            }
            device.leave();
            device.stopServing();
        });
        EXPECT_TRUE(device.serve(nullptr, nullptr));
        game.join();
        EXPECT_EQ(log.frames, direct) << inFlight << " in flight";
        for (std::thread::id id : log.threads) ASSERT_EQ(id, std::this_thread::get_id());
    }
}

// Hands frames over while the device is held up: as many as are in flight go in, the next one
// waits.
TEST(RenderThread, WaitsForTheServingThreadAreCounted) {
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight) {
        FrameRecorder::Log log;
        ThreadedDevice device(std::make_unique<FrameRecorder>(log), inFlight);
        std::vector<CommandBuffer> commands(inFlight + 1);
        std::vector<ExecutionReport> reports(inFlight + 1);
        log.gate.set(false);
        std::thread game([&] {
            ASSERT_TRUE(device.enter());
            for (uint32_t i = 0; i < inFlight; ++i) device.execute(commands[i], {}, reports[i]);
            EXPECT_EQ(device.pendingFrames(), inFlight);
            std::thread opener([&] {
                std::this_thread::sleep_for(200ms);
                EXPECT_EQ(device.pendingFrames(), inFlight) << "more frames than may be in flight";
                log.gate.set(true);
            });
            device.execute(commands[inFlight], {}, reports[inFlight]);
            opener.join();
            device.leave();
            device.stopServing();
        });
        EXPECT_TRUE(device.serve(nullptr, nullptr));
        game.join();
        for (uint32_t i = 0; i <= inFlight; ++i)
            EXPECT_EQ(reports[i].queueWaits, i == inFlight) << i;
        EXPECT_EQ(log.frames.size(), inFlight + 1);
        EXPECT_EQ(device.pendingFrames(), 0u);
    }
}

TEST(RenderThread, StoppingExecutesWhatIsQueued) {
    FrameRecorder::Log log;
    ThreadedDevice device(std::make_unique<FrameRecorder>(log), 3);
    std::vector<CommandBuffer> commands(3);
    std::vector<ExecutionReport> reports(3);
    log.gate.set(false);
    std::thread game([&] {
        ASSERT_TRUE(device.enter());
        const auto texture = device.createTexture(
            {"texture", TextureKind::texture2d, Format::rgba8, 4, 4});
        for (uint32_t i = 0; i < 3; ++i) device.execute(commands[i], {}, reports[i]);
        device.destroy(*texture);
        device.leave();
        std::thread opener([&] {
            std::this_thread::sleep_for(20ms);
            log.gate.set(true);
        });
        device.stopServing();
        EXPECT_EQ(log.frames.size(), 3u) << "stopServing() returned too early";
        EXPECT_FALSE(device.enter());
        opener.join();
    });
    EXPECT_TRUE(device.serve(nullptr, nullptr));
    EXPECT_EQ(log.frames.size(), 3u);
    game.join();
}

// Destroying runs behind the frames that use the thing: the null device stops the program when one
// names what is gone.
TEST(RenderThread, ThingsAreDestroyedBehindTheFramesThatUseThem) {
    FrameRecorder::Log log;
    ThreadedDevice device(std::make_unique<FrameRecorder>(log), 3);
    CommandBuffer commands;
    ExecutionReport report;
    std::thread game([&] {
        ASSERT_TRUE(device.enter());
        for (int i = 0; i < 300; ++i) {
            const BufferHandle buffer = *device.createBuffer({"buffer", 64, BufferUsage::index});
            device.finish();
            commands.clear();
            commands.push(SetIndexStream{{buffer, 0, 0, 64}});
            device.execute(commands, {}, report);
            device.destroy(buffer);
        }
        device.leave();
        device.stopServing();
    });
    EXPECT_TRUE(device.serve(nullptr, nullptr));
    game.join();
    EXPECT_EQ(log.frames.size(), 300u);
}

TEST(RenderThread, ALostDeviceIsAnErrorOfTheFramesAfter) {
    FrameRecorder::Log log;
    ThreadedDevice device(std::make_unique<FrameRecorder>(log), 2);
    CommandBuffer commands;
    ExecutionReport report;
    std::thread game([&] {
        ASSERT_TRUE(device.enter());
        EXPECT_TRUE(device.status());
        log.gate.set(false);
        device.execute(commands, {}, report);
        log.status = fail("device", "it fell off the bus.");
        log.gate.set(true);
        device.finish();
        const auto status = device.status();
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().message, "it fell off the bus.");
        device.leave();
        device.stopServing();
    });
    EXPECT_TRUE(device.serve(nullptr, nullptr));
    game.join();
}

// ---- through the one header
// --------------------------------------------------------------------------------------

std::unique_ptr<Renderer> threadedRenderer(uint32_t inFlight = 2) {
    RendererDesc desc;
    desc.renderThread = true;
    desc.framesInFlight = inFlight;
    desc.validateCommands = false;  // it asks the device about what the commands name
    return std::move(Renderer::create(desc).value());
}

/// Serves while `game` runs on another thread.
template <class Game>
void play(Renderer& renderer, Game&& game) {
    std::thread thread([&] {
        game();
        renderer.stopServing();
    });
    EXPECT_TRUE(renderer.serve());
    thread.join();
}

std::string commandsOf(Renderer& renderer, RandomScene& scene) {
    std::string text;
    for (uint32_t i = 0; i < 5; ++i) {
        const auto rendered = renderer.render(scene.frame(i), kTarget);
        EXPECT_TRUE(rendered) << rendered.error().text();
        text += renderer.printCommands();
    }
    return text;
}

TEST(RenderThread, ScenesMadeOnTheOtherThreadGiveTheSameCommands) {
    for (uint64_t seed = 200; seed < 206; ++seed) {
        const auto direct = std::move(Renderer::create({}).value());
        RandomScene scene(*direct, seed);
        const std::string expected = commandsOf(*direct, scene);
        const auto threaded = threadedRenderer();
        play(*threaded, [&] {
            RandomScene other(*threaded, seed);
            EXPECT_TRUE(commandsOf(*threaded, other) == expected) << "seed " << seed;
        });
    }
}

TEST(RenderThread, AWarmFrameCallsTheServingThreadForNothing) {
    const auto renderer = threadedRenderer();
    play(*renderer, [&] {
        RandomScene scene(*renderer, 2);
        const auto callsOf = [&](uint32_t frame) {
            EXPECT_TRUE(renderer->render(scene.frame(frame % 5), kTarget));
            renderer->finish();  // the call itself counts for the frame after
            EXPECT_EQ(renderer->report().executedFrame, renderer->report().frameNumber);
            return renderer->report().synchronousCalls;
        };
        EXPECT_GT(callsOf(0), 10u) << "what is created is counted";
        for (uint32_t i = 1; i < 10; ++i) callsOf(i);
        for (uint32_t i = 10; i < 40; ++i) ASSERT_EQ(callsOf(i), 1u) << "only finish()";
    });
}

TEST(RenderThread, CapturesComeBack) {
    const auto renderer = threadedRenderer(3);
    play(*renderer, [&] {
        RandomScene scene(*renderer, 2);
        CapturedImage image;
        for (uint32_t i = 0; i < 10; ++i) {
            const auto ticket = renderer->renderOffscreen(scene.frame(i), 33, 17,
                                                          CaptureKind::display);
            ASSERT_TRUE(ticket);
            ASSERT_TRUE(renderer->takeCapture(*ticket, true, image));
            EXPECT_EQ(image.rgba8.size(), 33u * 17 * 4);
        }
        const auto ticket = renderer->renderOffscreen(scene.frame(0), 33, 17, CaptureKind::display);
        while (!renderer->takeCapture(*ticket, false, image)) {
        }
    });
}

TEST(RenderThread, AfterFrameFollowsEachFrameForTheHost) {
    const auto renderer = threadedRenderer();
    struct Seen {
        Renderer& renderer;
        uint32_t frames = 0, refused = 0;
    } seen{*renderer};
    std::thread game([&] {
        for (int i = 0; i < 4; ++i) {
            EXPECT_TRUE(renderer->render({}, kTarget));
            EXPECT_TRUE(renderer->renderOffscreen({}, 8, 8, CaptureKind::display));
            EXPECT_TRUE(renderer->render({}, {0, 0, 0})) << "minimised";
        }
        renderer->finish();
        renderer->stopServing();
    });
    EXPECT_TRUE(renderer->serve(
        [](void* user) {
            Seen& s = *static_cast<Seen*>(user);
            ++s.frames;
            s.refused += !s.renderer.createMesh(makeCube().desc());
        },
        &seen));
    game.join();
    EXPECT_EQ(seen.frames, 4u);
    EXPECT_EQ(seen.refused, 4u) << "calls on the serving thread would wait for themselves";
}

TEST(RenderThread, TheHostMayServeAgainAndUseItDirectlyInBetween) {
    const auto renderer = threadedRenderer();
    for (int round = 0; round < 3; ++round) {
        EXPECT_TRUE(renderer->render({}, kTarget)) << "on the context's own thread";
        EXPECT_EQ(renderer->report().executedFrame, renderer->report().frameNumber);
        play(*renderer, [&] {
            while (!renderer->render({}, kTarget))
                std::this_thread::yield();  // refused until it is served again
        });
    }
    EXPECT_EQ(renderer->report().frameNumber, 5u);
}

TEST(RenderThread, CallsBeforeTheFirstServeWaitForIt) {
    const auto renderer = threadedRenderer();
    std::atomic<bool> rendered = false;
    std::thread game([&] {
        EXPECT_TRUE(renderer->render({}, kTarget));
        rendered = true;
        renderer->stopServing();
    });
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(rendered);
    EXPECT_TRUE(renderer->serve());
    game.join();
    EXPECT_TRUE(rendered);
}

TEST(RenderThread, StoppedBeforeItServesItReturnsAtOnce) {
    const auto renderer = threadedRenderer();
    renderer->stopServing();
    EXPECT_TRUE(renderer->serve());
}

TEST(RenderThread, WrongUseIsAnError) {
    const auto isWrongUse = [](const auto& result) {
        return !result && result.error().kind == ErrorKind::wrongUse &&
               result.error().message.size() > 10;
    };
    EXPECT_TRUE(isWrongUse((*Renderer::create({}))->serve()))
        << "without RendererDesc::renderThread";
    const auto renderer = threadedRenderer();
    play(*renderer, [&] {
        EXPECT_TRUE(renderer->render({}, kTarget));
        EXPECT_TRUE(isWrongUse(renderer->serve())) << "twice";
        std::atomic<bool> stop = false;
        std::thread other([&] {
            while (!stop) (void)renderer->render({}, kTarget);
        });
        const auto end = std::chrono::steady_clock::now() + 10s;
        bool refused = false;
        while (!refused && std::chrono::steady_clock::now() < end)
            refused = isWrongUse(renderer->render({}, kTarget));
        EXPECT_TRUE(refused) << "two threads at once";
        stop = true;
        other.join();
    });
    std::thread late(
        [&] { EXPECT_TRUE(isWrongUse(renderer->render({}, kTarget))) << "nobody serves"; });
    late.join();
}

}  // namespace
}  // namespace rushlight
