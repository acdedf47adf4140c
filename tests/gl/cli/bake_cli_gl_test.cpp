// rushlight bake, and captures that find what it wrote.

#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

namespace rushlight {
namespace {

class BakeCli : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::copy(RUSHLIGHT_SOURCE "/content/testcard", folder.path());
    }
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    std::string bytes(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Ended run(const std::string& arguments) const { return runTool(folder.path(), arguments); }
    Ended bake(const std::string& more = "") const {
        return run("bake " + path("testcard.gltf") +
                   " --probe-spacing 2 --samples 16 --ambient 0.5,0.5,0.5 " + more);
    }
    Ended capture(const std::string& name, const std::string& more = "",
                  const std::string& ambient = "0.5,0.5,0.5") const {
        return run("capture " + path("testcard.gltf") + " --size 64x48 --ambient " + ambient +
                   " -o " + path(name) + " " + more);
    }
    TemporaryDirectory folder;
};

TEST_F(BakeCli, WritesTheSameFileEachTimeAndNothingElseToAPipe) {
    const Ended first = bake(), second = bake("--threads 1 -o " + path("again.probes"));
    EXPECT_EQ(first.code, 0) << first.errors;
    EXPECT_EQ(first.errors, "");
    EXPECT_NE(first.output.find("probes every"), std::string::npos) << first.output;
    EXPECT_EQ(second.code, 0) << second.errors;
    EXPECT_GT(bytes("testcard.probes").size(), 400u);
    EXPECT_TRUE(bytes("testcard.probes") == bytes("again.probes"));
}

TEST_F(BakeCli, ACaptureUsesWhatLiesBesideTheSceneUnderTheSameLight) {
    ASSERT_EQ(capture("none.png").code, 0);
    ASSERT_EQ(bake().code, 0);
    const Ended found = capture("found.png");
    EXPECT_EQ(found.code, 0) << found.errors;
    EXPECT_EQ(found.errors, "");
    EXPECT_FALSE(bytes("found.png") == bytes("none.png"));
    ASSERT_EQ(capture("named.png", "--probes " + path("testcard.probes")).code, 0);
    EXPECT_TRUE(bytes("named.png") == bytes("found.png"));
    ASSERT_EQ(capture("baked.png", "--probes bake --probe-spacing 2 --samples 16").code, 0);
    EXPECT_TRUE(bytes("baked.png") == bytes("found.png"));
    ASSERT_EQ(capture("off.png", "--probes off").code, 0);
    EXPECT_TRUE(bytes("off.png") == bytes("none.png"));

    // Under other light they would be wrong: left alone with a warning, unless they are asked for.
    const Ended other = capture("other.png", "", "0.6,0.5,0.5");
    EXPECT_EQ(other.code, 0);
    EXPECT_TRUE(other.errors.starts_with("rushlight: warning: ")) << other.errors;
    ASSERT_EQ(capture("open.png", "--probes off", "0.6,0.5,0.5").code, 0);
    EXPECT_TRUE(bytes("other.png") == bytes("open.png"));
}

TEST_F(BakeCli, ProbesBakedUnderOtherAreaLightsAreNotUsed) {
    const std::string original = bytes("testcard.gltf"), node = "\"name\": \"card\",";
    const size_t at = original.find(node);
    ASSERT_NE(at, std::string::npos);
    const auto shine = [&](const std::string& luminance) {
        std::string scene = original;
        scene.insert(at + node.size(),
                     "\"extras\": {\"rushlight\": {\"areaLight\": {\"shape\": \"rectangle\", "
                     "\"size\": [2, 1], \"luminance\": " +
                         luminance + "}}},");
        std::ofstream(path("testcard.gltf"), std::ios::binary) << scene;
    };
    shine("10");
    ASSERT_EQ(bake().code, 0);
    const Ended same = capture("same.png");
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.errors, "");
    const std::string dim = bytes("testcard.probes");
    shine("20");
    const Ended other = capture("other.png");
    EXPECT_EQ(other.code, 0);
    EXPECT_TRUE(other.errors.starts_with("rushlight: warning: ")) << other.errors;
    ASSERT_EQ(bake().code, 0);
    EXPECT_FALSE(bytes("testcard.probes") == dim);
}

TEST_F(BakeCli, ADamagedFileIsBadInput) {
    ASSERT_EQ(bake().code, 0);
    std::string damaged = bytes("testcard.probes");
    damaged[damaged.size() / 2] ^= 1;
    std::ofstream(path("testcard.probes"), std::ios::binary) << damaged;
    for (const char* more : {"", "--probes /nowhere/a.probes", "--probes " RUSHLIGHT_TOOL}) {
        const Ended ended = capture("a.png", more);
        EXPECT_EQ(ended.code, 3) << ended.errors;
        EXPECT_TRUE(ended.errors.starts_with("rushlight: error: ")) << ended.errors;
        EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
    }
    EXPECT_EQ(bake("--probe-spacing nan").code, 2);
    EXPECT_EQ(bake("--samples 3").code, 2);
    EXPECT_EQ(run("bake /nowhere/a.gltf").code, 3);
    const Ended fine = run("bake " + path("testcard.gltf") + " --probe-spacing 0.001");
    EXPECT_EQ(fine.code, 2) << fine.errors;
}

}  // namespace
}  // namespace rushlight
