// capture --frames: shards, resumed runs and what they leave behind.

#include "tests/support/run_tool.h"
#include "tests/support/scenes/moving_scene.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace rushlight {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kFrames = 12;

class SequenceCli : public testing::Test {
protected:
    void SetUp() override { writeMovingScene(RUSHLIGHT_SOURCE "/content/testcard", folder.path()); }
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    static std::string bytesOf(const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::string frame(const std::string& shot, int number) const {
        char name[32];
        std::snprintf(name, sizeof name, "_%04d.png", number);
        return path(shot + name);
    }
    Ended capture(const std::string& shot, const std::string& more = "") const {
        return runTool(
            folder.path(),
            "capture " + path("moving.gltf") + " --animation 0 --size 96x64 --light-shadows on " +
                "--exposure auto --frames 0-" + std::to_string(kFrames - 1) + " --fps 4 -o " +
                path(shot + "_%04d.png") + " --stats " + path("stats.json") + " " + more);
    }
    Json stats() const { return Json::parse(bytesOf(path("stats.json"))).at("sequence"); }
    int same(const std::string& a, const std::string& b) const {
        int count = 0;
        for (int i = 0; i < kFrames; ++i)
            count += !bytesOf(frame(a, i)).empty() && bytesOf(frame(a, i)) == bytesOf(frame(b, i));
        return count;
    }

    TemporaryDirectory folder;
};

TEST_F(SequenceCli, ShardsWriteTheBytesOfOneRun) {
    const Ended whole = capture("whole");
    ASSERT_EQ(whole.code, 0) << whole.errors;
    EXPECT_EQ(whole.errors, "") << "there is no progress in a pipe";
    EXPECT_EQ(stats().at("rendered"), kFrames);
    EXPECT_NE(bytesOf(frame("whole", 2)), bytesOf(frame("whole", 3))) << "nothing moves";
    for (int shard = 1; shard <= 5; ++shard)
        ASSERT_EQ(capture("part", "--shard " + std::to_string(shard) + "/5").code, 0);
    EXPECT_EQ(same("whole", "part"), kFrames);
}

TEST_F(SequenceCli, AResumedRunDrawsWhatIsMissingOrBroken) {
    ASSERT_EQ(capture("whole").code, 0);
    ASSERT_EQ(capture("again", "--shard 1/2").code, 0);
    const auto times = [&](int number) { return fs::last_write_time(frame("again", number)); };
    const auto before = times(1);
    // Cut short, of other options, and no picture at all.
    fs::resize_file(frame("again", 3), fs::file_size(frame("again", 3)) / 2);
    ASSERT_EQ(capture("other", "--tonemap aces").code, 0);
    fs::copy_file(frame("other", 4), frame("again", 4), fs::copy_options::overwrite_existing);
    std::ofstream(frame("again", 5)) << "text";
    const Ended resumed = capture("again", "--resume");
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_EQ(stats().at("kept"), 3);
    EXPECT_EQ(stats().at("rendered"), kFrames - 3);
    EXPECT_EQ(same("whole", "again"), kFrames);
    EXPECT_EQ(times(1), before);
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos) << entry.path();
}

TEST_F(SequenceCli, AnotherSceneIsAnotherKey) {
    ASSERT_EQ(capture("a", "--shard 1/6").code, 0);
    ASSERT_EQ(capture("a", "--resume --shard 1/6").code, 0);
    EXPECT_EQ(stats().at("kept"), 2);
    // A file that the scene names, not the scene's own.
    std::string bytes = bytesOf(path("moving.bin"));
    const float lower = 1.0f;
    std::memcpy(bytes.data() + 12 + 4, &lower, sizeof lower);
    std::ofstream(path("moving.bin"), std::ios::binary) << bytes;
    ASSERT_EQ(capture("a", "--resume --shard 1/6").code, 0);
    EXPECT_EQ(stats().at("kept"), 0);
}

TEST_F(SequenceCli, AFullDiskIsAnErrorAndKeepsWhatIsThere) {
    fs::create_directories(path("full_0002.png"));  // nothing can be written there
    const Ended ended = capture("full");
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.errors.find("full_0002.png"), std::string::npos) << ended.errors;
    EXPECT_TRUE(fs::exists(frame("full", 0)));
    EXPECT_TRUE(fs::exists(frame("full", 1)));
    EXPECT_FALSE(fs::exists(frame("full", kFrames - 1)));
}

TEST_F(SequenceCli, WithoutWritingThereIsNoFile) {
    const Ended ended = capture("none", "--no-write");
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(stats().at("rendered"), kFrames);
    EXPECT_FALSE(fs::exists(frame("none", 0)));
}

}  // namespace
}  // namespace rushlight
