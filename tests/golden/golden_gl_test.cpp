#include "renderer/capture/compare.h"
#include "renderer/capture/image_files.h"
#include "renderer/context/context.h"
#include "tests/golden/goldens.h"
#include "tests/support/test_context.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

class GoldenTest : public testing::Test {
protected:
    void SetUp() override {
        auto made = createOffscreenContext(ContextChoice::automatic, {});
        if (!made) GTEST_SKIP() << made.error().text();
        context = std::move(*made);
    }

    std::unique_ptr<Context> context;
};

bool isWithinLimits(const Comparison& c) { return c.flip <= kMaxFlip && c.psnr >= kMinPsnr; }

Result<Comparison> compareWithGolden(const Golden& golden, const CapturedImage& image) {
    const auto expected = loadPicture(goldenPath(golden));
    if (!expected) return tl::unexpected(expected.error());
    return comparePictures(*expected, pictureOf(image), goldenPath(golden), "the frame");
}

/// Keeps what was rendered beside the test, to be looked at.
void keep(const Golden& golden, const CapturedImage& image) {
    const std::string path = std::string(golden.name) + "_rendered.png";
    if (saveImage(path, PictureView(image)))
        std::printf("what was rendered is in %s\n", fs::absolute(path).c_str());
}

TEST_F(GoldenTest, EveryGoldenIsRenderedAgain) {
    for (const Golden& golden : goldens()) {
        SCOPED_TRACE(golden.name);
        const auto image = renderGolden(golden, context->loader());
        ASSERT_TRUE(image) << image.error().text();
        const auto comparison = compareWithGolden(golden, *image);
        ASSERT_TRUE(comparison) << comparison.error().text();
        EXPECT_LE(comparison->flip, kMaxFlip);
        EXPECT_GE(comparison->psnr, kMinPsnr);
        if (!isWithinLimits(*comparison)) keep(golden, *image);
    }
}

/// One line of a shader, made wrong. `golden` must notice.
struct Fault {
    const char* golden;
    const char* file;
    const char* right;
    const char* wrong;
};

const Fault kFaults[] = {
    {"testcard", "passes/gbuffer.frag", "encodeGBuffer(s.baseColor.rgb, s.metallic, s.normal,",
     "encodeGBuffer(s.baseColor.rgb, s.metallic, -s.normal,"},
    {"square", "common/material.glsl", "t * local.x + b * local.y", "t * local.x - b * local.y"},
    {"testcard", "common/lighting.glsl", "light *= sunVisibility(s, l);", ""},
    {"testcard_dusk", "common/lighting.glsl", "light *= sunVisibility(s, l);", ""},
    {"testcard", "common/material.glsl", "vec2 factors = unpackUnorm2x16(material.texel0.z);",
     "vec2 factors = unpackUnorm2x16(material.texel0.z).yx;"},
    {"testcard", "passes/tonemap.frag", "float exposure = flatSettings.y;",
     "float exposure = flatSettings.y * 1.03;"},
    {"square", "passes/tonemap.frag", "float exposure = flatSettings.y;",
     "float exposure = flatSettings.y * 1.03;"},
    {"testcard_normal", "common/gbuffer.glsl", "packNormal(normal)", "packNormal(normal.xzy)"},
    {"testcard_basecolor", "common/gbuffer.glsl", "s.baseColor = t.target0.rgb * t.target0.rgb;",
     "s.baseColor = t.target0.rgb;"},
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
        TemporaryDirectory shaders;
        fs::copy(RUSHLIGHT_SOURCE "/shaders", shaders.path(), fs::copy_options::recursive);
        ASSERT_TRUE(seed(fault, shaders.path()));
        const Golden& golden = goldenNamed(fault.golden);
        const auto image = renderGolden(golden, context->loader(), shaders.path());
        ASSERT_TRUE(image) << image.error().text();
        const auto comparison = compareWithGolden(golden, *image);
        ASSERT_TRUE(comparison) << comparison.error().text();
        EXPECT_FALSE(isWithinLimits(*comparison))
            << "flip " << comparison->flip << ", psnr " << comparison->psnr;
        std::printf("%-20s flip %.4f psnr %.1f  %s\n", fault.golden, comparison->flip,
                    comparison->psnr, fault.wrong);
    }
}

TEST_F(GoldenTest, ShadersFromADirectoryRenderTheSame) {
    const Golden& golden = goldenNamed("testcard_normal");
    const auto compiledIn = renderGolden(golden, context->loader());
    const auto fromFiles = renderGolden(golden, context->loader(), RUSHLIGHT_SOURCE "/shaders");
    ASSERT_TRUE(compiledIn && fromFiles);
    EXPECT_EQ(compiledIn->rgba8, fromFiles->rgba8);
}

}  // namespace
}  // namespace rushlight
