#include "sandbox/viewer/file_watch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "sub");
        write("sub/a.txt", "one");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const char* name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    /// How often a change is told in the next two seconds.
    int changes(FileWatch& watch) {
        int count = 0;
        for (int i = 0; i < 20; ++i) count += watch.poll(now_ += 0.1);
        return count;
    }

    fs::path folder_;
    double now_ = 0;
};

TEST_F(FileWatchTest, NothingChangedIsNotTold) {
    FileWatch watch(folder_);
    EXPECT_EQ(changes(watch), 0);
}

TEST_F(FileWatchTest, AChangeBelowTheFolderIsToldOnce) {
    FileWatch watch(folder_);
    write("sub/a.txt", "longer than before");
    EXPECT_EQ(changes(watch), 1);
    write("b.txt", "new");
    EXPECT_EQ(changes(watch), 1);
    fs::remove(folder_ / "b.txt");
    EXPECT_EQ(changes(watch), 1);
}

TEST_F(FileWatchTest, WaitsUntilTheWriterIsDone) {
    FileWatch watch(folder_ / "sub/a.txt");
    std::string text = "one";
    for (int i = 0; i < 20; ++i) {
        write("sub/a.txt", text += "+");
        EXPECT_FALSE(watch.poll(now_ += FileWatch::kInterval));
    }
    EXPECT_EQ(changes(watch), 1);
}

TEST_F(FileWatchTest, AnAcceptedChangeIsNotTold) {
    FileWatch watch(folder_);
    write("sub/a.txt", "longer than before");
    watch.accept();
    EXPECT_EQ(changes(watch), 0);
}

TEST_F(FileWatchTest, AMissingPathIsNoChangeUntilItAppears) {
    FileWatch watch(folder_ / "later.txt");
    EXPECT_EQ(changes(watch), 0);
    write("later.txt", "here");
    EXPECT_EQ(changes(watch), 1);
}

}  // namespace
}  // namespace rushlight
