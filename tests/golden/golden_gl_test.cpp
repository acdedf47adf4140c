#include "renderer/testing/matchers.h"
#include "tests/golden/goldens.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace rushlight {
namespace {

namespace fs = std::filesystem;
using golden::Offscreen;

class GoldenTest : public testing::Test {
protected:
    void SetUp() override {
        auto made = Offscreen::create();
        if (!made) GTEST_SKIP() << made.error().text();
        offscreen = std::move(*made);
    }

    std::unique_ptr<Offscreen> offscreen;
};

TEST_F(GoldenTest, EveryGoldenIsRenderedAgain) {
    for (const Golden& golden : goldens())
        EXPECT_FRAME(renderGolden(golden, *offscreen), nearGolden(golden));
}

/// One line of a shader, made wrong. `golden` must notice.
struct Fault {
    const char* golden;
    const char* file;
    const char* right;
    const char* wrong;
};

const Fault kFaults[] = {
    {"testcard", "passes/surface/gbuffer.frag",
     "encodeGBuffer(s.baseColor.rgb, s.metallic, s.normal,",
     "encodeGBuffer(s.baseColor.rgb, s.metallic, -s.normal,"},
    {"square", "common/surface/material.glsl", "t * local.x + b * local.y",
     "t * local.x - b * local.y"},
    {"testcard", "common/light/lighting.glsl", "light *= sunVisibility(s, l);", ""},
    {"testcard_dusk", "common/light/lighting.glsl", "light *= sunVisibility(s, l);", ""},
    {"testcard", "common/surface/material.glsl",
     "vec2 factors = unpackUnorm2x16(material.texel0.z);",
     "vec2 factors = unpackUnorm2x16(material.texel0.z).yx;"},
    {"testcard", "passes/post/tonemap.frag", "float exposure = flatSettings.y;",
     "float exposure = flatSettings.y * 1.03;"},
    {"square", "passes/post/tonemap.frag", "float exposure = flatSettings.y;",
     "float exposure = flatSettings.y * 1.03;"},
    {"testcard_normal", "common/surface/gbuffer.glsl", "packNormal(normal)",
     "packNormal(normal.xzy)"},
    {"testcard_basecolor", "common/surface/gbuffer.glsl",
     "s.baseColor = t.target0.rgb * t.target0.rgb;", "s.baseColor = t.target0.rgb;"},
};

const Golden& goldenNamed(std::string_view name) {
    for (const Golden& golden : goldens())
        if (golden.name == name) return golden;
    abort();
}

/// Replaces the one place where `fault.right` stands.
testing::AssertionResult seed(const Fault& fault, const fs::path& shaders) {
    const fs::path path = shaders / fault.file;
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    std::string source = text.str();
    const size_t at = source.find(fault.right);
    if (at == source.npos || source.find(fault.right, at + 1) != source.npos)
        return testing::AssertionFailure() << fault.file << " does not hold \"" << fault.right
                                           << "\" once; seed the fault in its new place";
    source.replace(at, std::string_view(fault.right).size(), fault.wrong);
    std::ofstream(path) << source;
    return testing::AssertionSuccess();
}

TEST_F(GoldenTest, TheLimitsNoticeASeededFault) {
    for (const Fault& fault : kFaults) {
        SCOPED_TRACE(std::string(fault.golden) + ": " + fault.wrong);
        TemporaryDirectory shaders, evidence;
        fs::copy(RUSHLIGHT_SOURCE "/shaders", shaders.path(), fs::copy_options::recursive);
        ASSERT_TRUE(seed(fault, shaders.path()));
        const Golden& golden = goldenNamed(fault.golden);
        const auto faulty = Offscreen::create({.shaderDirectory = shaders.path()});
        ASSERT_TRUE(faulty) << faulty.error().text();
        const auto frame = renderGolden(golden, **faulty);
        ASSERT_TRUE(frame) << frame.error().text();
        const auto verdict = golden::judge(*frame, nearGolden(golden),
                                           {.folder = evidence.path(), .breakdown = false});
        ASSERT_TRUE(verdict && verdict->figures);
        EXPECT_FALSE(verdict->passed) << verdict->text();
        std::printf("%-20s flip %.4f psnr %.1f  %s\n", fault.golden, verdict->figures->flip,
                    verdict->figures->psnr, fault.wrong);
    }
}

TEST_F(GoldenTest, ShadersFromADirectoryRenderTheSame) {
    const Golden& golden = goldenNamed("testcard_normal");
    const auto fromFiles = Offscreen::create({.shaderDirectory = RUSHLIGHT_SOURCE "/shaders"});
    ASSERT_TRUE(fromFiles) << fromFiles.error().text();
    const auto compiledIn = renderGolden(golden, *offscreen);
    const auto read = renderGolden(golden, **fromFiles);
    ASSERT_TRUE(compiledIn && read);
    EXPECT_EQ(compiledIn->image.rgba8, read->image.rgba8);
}

}  // namespace
}  // namespace rushlight
