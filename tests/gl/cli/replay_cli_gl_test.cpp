// capture --save-frame and replay, as a user calls them.

#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <iterator>

namespace rushlight {
namespace {

class ReplayCli : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    std::string bytes(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Ended run(const std::string& arguments) const { return runTool(folder.path(), arguments); }
    /// The test card, small, into NAME.EXTENSION and NAME.rlf.
    Ended capture(const std::string& name, const std::string& more = "",
                  const std::string& extension = ".png") const {
        return run("capture " RUSHLIGHT_SOURCE "/content/testcard/testcard.gltf --size 64x48 -o " +
                   path(name + extension) + " --save-frame " + path(name + ".rlf") + " " + more);
    }
    static void expectError(const Ended& ended, int code, const std::string& what) {
        EXPECT_EQ(ended.code, code);
        EXPECT_TRUE(ended.errors.starts_with("rushlight: error: ")) << ended.errors;
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
        EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
    }
    TemporaryDirectory folder;
};

TEST_F(ReplayCli, DrawsTheBytesThatCaptureWrote) {
    const Ended captured = capture("a", "--hashes");
    ASSERT_EQ(captured.code, 0) << captured.errors;
    const Ended replayed = run("replay " + path("a.rlf") + " --hashes -o " + path("b.png"));
    ASSERT_EQ(replayed.code, 0) << replayed.errors;
    EXPECT_EQ(replayed.errors, "");
    EXPECT_GT(bytes("a.png").size(), 500u);
    EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
    EXPECT_EQ(captured.output, replayed.output);

    ASSERT_EQ(capture("linear", "", ".exr").code, 0);
    ASSERT_EQ(run("replay " + path("linear.rlf") + " -o " + path("again.exr")).code, 0);
    EXPECT_TRUE(bytes("linear.exr") == bytes("again.exr"));
}

TEST_F(ReplayCli, ListsAndStops) {
    ASSERT_EQ(capture("a").code, 0);
    const Ended listed = run("replay " + path("a.rlf") + " --list");
    EXPECT_EQ(listed.code, 0);
    EXPECT_TRUE(listed.output.starts_with("    1  BeginPass 0 \"shadow.0\"")) << listed.output;
    EXPECT_NE(listed.output.find("\"materials\""), std::string::npos);
    ASSERT_EQ(run("replay " + path("a.rlf") + " --until 1 -o " + path("first.png")).code, 0);
    EXPECT_FALSE(bytes("first.png").empty());
    EXPECT_FALSE(bytes("first.png") == bytes("a.png"));
}

TEST_F(ReplayCli, DiffEndsWithOneWhereFramesDiffer) {
    ASSERT_EQ(capture("a").code, 0);
    ASSERT_EQ(capture("b").code, 0);
    ASSERT_EQ(capture("c", "--tonemap agx").code, 0);
    EXPECT_TRUE(bytes("a.rlf") == bytes("b.rlf")) << "the same frame is the same file";
    const Ended same = run("replay --diff " + path("a.rlf") + " " + path("b.rlf"));
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.output, "");
    const Ended other = run("replay --diff " + path("a.rlf") + " " + path("c.rlf"));
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.output.find("\"tonemap\": the source of passes/post/tonemap.frag differs"),
              std::string::npos)
        << other.output;
}

TEST_F(ReplayCli, BadFilesAreThreeAndNothingIsWritten) {
    ASSERT_EQ(capture("a").code, 0);
    const std::string whole = bytes("a.rlf");
    folder.write("cut.rlf", whole.substr(0, whole.size() / 2));
    expectError(run("replay " + path("cut.rlf") + " -o " + path("cut.png")), 3,
                "cut.rlf: The file is truncated");
    std::string damaged = whole;
    damaged[damaged.size() - 100] ^= 1;
    folder.write("damaged.rlf", damaged);
    expectError(run("replay " + path("damaged.rlf") + " --list"), 3,
                "damaged.rlf: The file is wrong: blob");
    expectError(run("replay --diff " + path("a.rlf") + " " + path("cut.rlf")), 3, "cut.rlf");
    EXPECT_FALSE(std::filesystem::exists(path("cut.png")));
}

TEST_F(ReplayCli, AFullDiskIsAnError) {
    const Ended ended = run("capture " RUSHLIGHT_SOURCE
                            "/content/testcard/testcard.gltf --size 16x16 -o " +
                            path("a.png") + " --save-frame /dev/full");
    expectError(ended, 3, "/dev/full: The file could not be written");
}

}  // namespace
}  // namespace rushlight
