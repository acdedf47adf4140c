// rushlight breakdown, as a user calls it, and its page in a browser.
#include "tests/support/browser.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace rushlight {
namespace {

class BreakdownCli : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    nlohmann::json json(const std::string& name) const {
        std::ifstream file(path(name));
        return nlohmann::json::parse(std::string(std::istreambuf_iterator<char>(file), {}));
    }
    Ended run(const std::string& arguments) const {
        return runTool(folder.path(), "breakdown " RUSHLIGHT_SOURCE
                                      "/content/testcard/testcard.gltf --size 96x54 " +
                                          arguments);
    }
    TemporaryDirectory folder;
};

TEST_F(BreakdownCli, ThePageHoldsAndItsTotalsAreThoseOfStats) {
    const Ended first = run("--quality ultra --ambient 1,1,1 -o " + path("a") + " --stats " +
                            path("stats.json"));
    ASSERT_EQ(first.code, 0) << first.errors;
    EXPECT_EQ(first.output + first.errors, "");
    const nlohmann::json frame = json("a/frame.json"), stats = json("stats.json");
    EXPECT_EQ(frame["frame"], stats["frame"]);
    EXPECT_EQ(frame["gl_version"], stats["gl_version"]);
    ASSERT_EQ(frame["passes"].size(), stats["passes"].size());
    uint64_t draws = 0;
    for (size_t i = 0; i < stats["passes"].size(); ++i) {
        for (const char* key :
             {"name", "draws", "triangles", "gl_calls", "state_changes", "writes"})
            EXPECT_EQ(frame["passes"][i][key], stats["passes"][i][key]);
        draws += frame["passes"][i]["draws"].get<uint64_t>();
    }
    EXPECT_EQ(draws, frame["frame"]["draws"]);
    for (const char* pass : {"gbuffer", "gtao", "lighting", "reflections", "tonemap"})
        EXPECT_TRUE(std::ranges::any_of(frame["passes"], [&](const auto& p) {
            return p["name"] == pass;
        })) << pass;

    const Ended second = run("--quality ultra --ambient 1,1,1 --shadows off -o " + path("b") +
                             " --compare " + path("a/frame.json"));
    ASSERT_EQ(second.code, 0) << second.errors;
    if (browser().empty()) GTEST_SKIP() << kNoBrowser;
    for (const char* page : {"a/index.html", "b/index.html"}) {
        const std::string document = documentOf(path(page));
        EXPECT_EQ(attributeOf(document, "data-check"), "ok")
            << page << ": " << attributeOf(document, "data-problems");
        EXPECT_GE(std::stoul(std::string("0").append(attributeOf(document, "data-pictures"))), 30u);
    }
}

TEST_F(BreakdownCli, ErrorsAreOneLineWithTheirExitCode) {
    const auto expectError = [&](const std::string& arguments, int code, const std::string& what) {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.code, code) << arguments;
        EXPECT_TRUE(ended.errors.starts_with("rushlight: error: ")) << ended.errors;
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
        EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
    };
    folder.write("page/index.html", "mine");
    expectError("", 2, "--output is required");
    expectError("-o " + path("page"), 2, "no breakdown's");
    expectError("-o " + path("page/index.html"), 3, "This is a file");
    expectError("-o /proc/rushlight", 3, "cannot be written");
    expectError("-o " + path("out") + " --compare " + path("nowhere.json"), 3, "cannot be read");
    expectError("-o " + path("out") + " --compare " + path("page/index.html"), 3, "no frame.json");
}

}  // namespace
}  // namespace rushlight
