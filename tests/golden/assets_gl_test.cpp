// Every scene that others made is drawn, or refused with a reason.

#include "renderer/context/context.h"
#include "renderer/testing/scene_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> listScenes(const fs::path& assets) {
    std::vector<fs::path> scenes;
    for (const char* folder : {"models", "scenes", "lights", "extensions"})
        for (const auto& entry : fs::recursive_directory_iterator(assets / folder))
            if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
                scenes.push_back(entry.path());
    std::ranges::sort(scenes);
    return scenes;
}

bool isOneColor(const CapturedImage& image) {
    for (size_t i = 4; i < image.rgba8.size(); ++i)
        if (image.rgba8[i] != image.rgba8[i - 4]) return false;
    return true;
}

struct Outcome {
    bool loaded = false;
    std::string text;  ///< "drawn", or why not
};

Outcome draw(Renderer& renderer, const fs::path& scene) {
    auto frames = SceneFrames::open(renderer, scene.string(), "");
    if (!frames) {
        EXPECT_GT(frames.error().message.size(), 10u) << "a refusal without a reason";
        return {false, frames.error().message};
    }
    SceneView view;
    view.width = 160;
    view.height = 90;
    view.settings.dither = false;
    const auto image = (*frames)->render(view);
    EXPECT_TRUE(image) << image.error().text();
    if (!image) return {true, image.error().text()};
    EXPECT_FALSE(isOneColor(*image)) << "nothing is to be seen";
    return {true, "drawn"};
}

TEST(Assets, EverySceneIsDrawnOrRefusedWithAReason) {
    const char* assets = std::getenv("RUSHLIGHT_ASSETS");
    if (!assets) GTEST_SKIP() << "RUSHLIGHT_ASSETS does not name the folder of test scenes";
    const auto context = createOffscreenContext(ContextChoice::automatic, {.debug = true});
    if (!context) GTEST_SKIP() << context.error().text();
    RendererDesc desc;
    desc.loadGl = (*context)->loader();
    desc.debugOutput = true;
    desc.validateCommands = true;
    const auto renderer = Renderer::create(desc);
    ASSERT_TRUE(renderer) << renderer.error().text();

    size_t drawn = 0;
    const auto scenes = listScenes(assets);
    for (const fs::path& scene : scenes) {
        const std::string name = fs::relative(scene, assets).string();
        SCOPED_TRACE(name);
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = draw(**renderer, scene);
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() -
                                                                  start;
        for (const std::string& message : (*renderer)->takeDebugMessages())
            ADD_FAILURE() << "OpenGL says: " << message;
        std::printf("%-75s %6.0f ms  %s\n", name.c_str(), elapsed.count(), outcome.text.c_str());
        drawn += outcome.loaded;
    }
    std::printf("%zu of %zu scenes are drawn\n", drawn, scenes.size());
    EXPECT_GT(drawn, scenes.size() / 2);
}

}  // namespace
}  // namespace rushlight
