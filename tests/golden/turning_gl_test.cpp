// A camera that turns once around compiles nothing after the first frame; a second start with a
// cache compiles nothing at all.
#include "renderer/testing/scene_frames.h"
#include "tests/golden/goldens.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace rushlight {
namespace {

/// What each of a turn's frames compiled.
std::vector<uint32_t> turn(const std::string& scene, const std::string& cache) {
    std::vector<uint32_t> compiled;
    const auto context = createOffscreenContext(ContextChoice::automatic, {});
    if (!context) return compiled;
    RendererDesc desc;
    desc.loadGl = (*context)->loader();
    desc.cacheDirectory = cache;
    const auto renderer = std::move(Renderer::create(desc).value());
    const auto frames = std::move(SceneFrames::open(*renderer, scene, "").value());
    for (int degrees = 0; degrees < 360; degrees += 10) {
        FrameInput input;
        SceneView view{"", 64, 36, {}};
        view.settings.lightShadows = true;
        EXPECT_TRUE(frames->fill(view, input));
        input.view.viewFromWorld = glm::rotate(mat4(1), glm::radians(float(degrees)),
                                               vec3(0, 1, 0)) *
                                   input.view.viewFromWorld;
        const auto ticket = renderer->renderOffscreen(input, 64, 36, CaptureKind::display);
        CapturedImage image;
        EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
        compiled.push_back(renderer->report().pipelinesCompiled);
    }
    return compiled;
}

void expectWarm(const std::string& scene) {
    const TemporaryDirectory cache;
    const std::vector<uint32_t> first = turn(scene, cache.path());
    if (first.empty()) GTEST_SKIP() << "no OpenGL 4.5 context";
    EXPECT_GT(first[0], 5u);
    for (size_t i = 1; i < first.size(); ++i) EXPECT_EQ(first[i], 0u) << i * 10 << " degrees";
    for (const uint32_t again : turn(scene, cache.path())) EXPECT_EQ(again, 0u);
}

TEST(TurningGl, CompilesNothingInTheSquare) {
    expectWarm(RUSHLIGHT_SOURCE "/content/square/square.gltf");
}

TEST(TurningGl, CompilesNothingAmongThreeThousandObjects) {
    const char* assets = std::getenv("RUSHLIGHT_ASSETS");
    const std::string scene = std::string(assets ? assets : "") + "/bench/grid3000.glb";
    if (!std::filesystem::exists(scene)) GTEST_SKIP() << "RUSHLIGHT_ASSETS has no " << scene;
    expectWarm(scene);
}

}  // namespace
}  // namespace rushlight
