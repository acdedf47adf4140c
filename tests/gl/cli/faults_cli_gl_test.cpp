// What the tool does where OpenGL does not.

#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace rushlight {
namespace {

class FaultsCli : public testing::Test {
protected:
    /// One line that holds `what`, and no file.
    void expectError(const Ended& ended, int code, const char* what) {
        EXPECT_EQ(ended.code, code) << ended.errors;
        EXPECT_EQ(std::ranges::count(ended.errors, '\n'), 1) << ended.errors;
        EXPECT_TRUE(ended.errors.starts_with("rushlight: error: ")) << ended.errors;
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
        EXPECT_FALSE(std::filesystem::exists(picture_));
    }
    Ended capture(const std::string& options, const std::string& before) {
        return runTool(folder_.path(),
                       "capture " RUSHLIGHT_SOURCE "/content/testcard/testcard.gltf -o " +
                           picture_ + " --context egl " + options,
                       before);
    }

    TemporaryDirectory folder_;
    std::string picture_ = folder_.path() + "/picture.png";
};

TEST_F(FaultsCli, AnOlderOpenGlIsFour) {
    expectError(capture("", "MESA_GL_VERSION_OVERRIDE=4.4"), 4, "OpenGL 4.5");
}

// 3 GB of addresses are too few for targets of a gigabyte each.
TEST_F(FaultsCli, TooLittleMemoryIsThreeAndNamesWhatHadNoRoom) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes more addresses than the test leaves";
#endif
    expectError(capture("--size 16384x16384", "ulimit -v 3000000;"), 3,
                "OpenGL has no room for a texture of 16384x16384");
}

}  // namespace
}  // namespace rushlight
