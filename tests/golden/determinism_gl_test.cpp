// The same scene gives the same bytes: for every run, number of threads and kind of context of one
// driver.

#include "engine/jobs/tbb_jobs.h"
#include "renderer/capture/image_files.h"
#include "renderer/context/context.h"
#include "renderer/testing/scene_frames.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <optional>

namespace rushlight {
namespace {

struct Rendered {
    std::vector<std::byte> png;
    std::vector<std::string> passes;  ///< "pass attachment hash"
};

/// Two frames in a renderer of its own; what the second is.
Result<Rendered> render(const std::string& scene, GlLoadFunction loadGl, uint32_t threads) {
    const auto jobs = createTbbJobs(threads);
    RendererDesc desc;
    desc.loadGl = loadGl;
    desc.validateCommands = true;
    desc.jobs = jobs.get();
    const auto renderer = Renderer::create(desc);
    if (!renderer) return tl::unexpected(renderer.error());
    const auto frames = SceneFrames::open(**renderer, scene,
                                          RUSHLIGHT_SOURCE "/content/square/dusk.hdr");
    if (!frames) return tl::unexpected(frames.error());
    // Every shadow map is drawn in the hashed frame too.
    SceneView view;
    view.settings.shadowCaching = false;
    if (auto first = (*frames)->render(view); !first) return tl::unexpected(first.error());
    FrameOptions options;
    options.hashPasses = true;
    const auto image = (*frames)->render(view, options);
    if (!image) return tl::unexpected(image.error());
    auto png = encodeImage("frame", ImageFormat::png, PictureView(*image));
    if (!png) return tl::unexpected(png.error());
    Rendered rendered{std::move(*png), {}};
    for (const PassReport& pass : (*renderer)->report().passes)
        for (size_t i = 0; i < pass.hashes.size() && i < pass.writes.size(); ++i)
            rendered.passes.push_back(std::string(pass.name) + " " + pass.writes[i] + " " +
                                      std::to_string(pass.hashes[i]));
    return rendered;
}

class Determinism : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        scene = GetParam();
        if (!scene.starts_with("bench/")) {
            scene = RUSHLIGHT_SOURCE "/content/" + scene;
        } else if (const char* assets = std::getenv("RUSHLIGHT_ASSETS")) {
            scene = std::string(assets) + "/" + scene;
        } else {
            GTEST_SKIP() << "RUSHLIGHT_ASSETS does not name the folder of test scenes";
        }
    }

    /// Compares with the first frame that this test rendered.
    void expectSame(const std::string& what, GlLoadFunction loadGl, uint32_t threads) {
        SCOPED_TRACE(what);
        auto rendered = render(scene, loadGl, threads);
        ASSERT_TRUE(rendered) << rendered.error().text();
        ASSERT_GT(rendered->passes.size(), 4u);
        if (!reference) {
            reference = std::move(*rendered);
            return;
        }
        EXPECT_EQ(rendered->passes, reference->passes);  // the first that differs is the cause
        EXPECT_EQ(rendered->png, reference->png);
    }

    std::string scene;
    std::optional<Rendered> reference;
};

TEST_P(Determinism, RunsAndThreadsChangeNoByte) {
    // More threads than cores, too.
    const tbb::global_control workers(tbb::global_control::max_allowed_parallelism, 8);
    const auto context = createOffscreenContext(ContextChoice::automatic, {});
    if (!context) GTEST_SKIP() << context.error().text();
    for (const uint32_t threads : {1u, 1u, 2u, 8u, 8u})
        expectSame(std::to_string(threads) + " threads", (*context)->loader(), threads);
}

TEST_P(Determinism, KindsOfContextChangeNoByte) {
    int kinds = 0;
    for (const ContextKind kind : {ContextKind::eglDevice, ContextKind::eglSurfaceless,
                                   ContextKind::osmesa, ContextKind::hiddenWindow}) {
        const auto context = createContext(kind, {});
        if (!context) {
            std::printf("left out: %s: %s\n", toText(kind), context.error().message.c_str());
            continue;
        }
        ++kinds;
        expectSame(toText(kind), (*context)->loader(), 2);
    }
    if (kinds < 2) GTEST_SKIP() << "fewer than two kinds of context work here";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism,
                         testing::Values("testcard/testcard.gltf", "square/square.gltf",
                                         "bench/grid300.glb"),
                         [](const auto& instance) {
                             const std::string name = instance.param;
                             const size_t slash = name.find('/') + 1;
                             return name.substr(slash, name.find('.') - slash);
                         });

}  // namespace
}  // namespace rushlight
