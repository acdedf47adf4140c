// `rushlight check` and `rushlight goldens`: exit codes, evidence, and goldens that change when
// they are told to.
#include "renderer/capture/image_files.h"
#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

class CheckCli : public testing::Test {
protected:
    CheckCli() { unsetenv("RUSHLIGHT_EVIDENCE_ALWAYS"); }

    /// Of the test card, small.
    Ended check(const std::string& options) {
        return runTool(folder.path(),
                       "check " RUSHLIGHT_SOURCE
                       "/content/testcard/testcard.gltf --size 64x36 --quality low --evidence " +
                           path("evidence") + " " + options);
    }
    Ended goldens(const std::string& options) {
        return runTool(folder.path(), "goldens " + path("evidence") + " " + options);
    }
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }

    TemporaryDirectory folder;
};

TEST_F(CheckCli, AGoldenIsMadeWhenItIsAcceptedAndFoundAgain) {
    const std::string golden = "--golden " + path("card.exr");
    Ended ended = check(golden + " --hdr");
    EXPECT_EQ(ended.code, 2) << "no such option";
    ended = check(golden);
    if (ended.code == 4) GTEST_SKIP() << ended.errors;
    ASSERT_EQ(ended.code, 1) << ended.errors;
    EXPECT_NE(ended.output.find("There is no golden picture yet."), std::string::npos)
        << ended.output;
    EXPECT_EQ(goldens("").code, 0);
    EXPECT_FALSE(fs::exists(path("card.exr")));
    EXPECT_EQ(goldens("--only nothing --accept").code, 2);
    EXPECT_EQ(goldens("--accept").code, 0);
    ended = check(golden);
    EXPECT_EQ(ended.code, 0) << ended.output << ended.errors;
    EXPECT_TRUE(loadPicture(path("card.exr"))->linear);
    EXPECT_EQ(goldens("").code, 3) << "there is nothing to look at any more";
}

TEST_F(CheckCli, WordsOfAFileCountLast) {
    folder.write("card.check", "# looser\n--name \"my card\"\n  --flip 1\n");
    const std::string golden = "--golden " + path("card.png");
    if (const Ended ended = check(golden); ended.code == 4) GTEST_SKIP() << ended.errors;
    EXPECT_EQ(goldens("--accept").code, 0);
    EXPECT_EQ(check(golden + " --exact").code, 0);
    const std::string brighter = golden + " --exposure-scale 2 --flip 0.001 --no-breakdown ";
    EXPECT_EQ(check(brighter).code, 1);
    EXPECT_FALSE(fs::exists(path("evidence/card/breakdown")));
    EXPECT_EQ(check(brighter + "--always @" + path("card.check")).code, 0);
    EXPECT_TRUE(fs::exists(path("evidence/my_card/actual.png")));
    folder.write("card.png", "no picture");
    EXPECT_EQ(check(golden).code, 3);
}

TEST_F(CheckCli, WithoutAContextItIsFour) {
    unsetenv("DISPLAY");
    EXPECT_EQ(check("--context window --golden " + path("card.png")).code, 4);
}

}  // namespace
}  // namespace rushlight
