// The frame breakdown on the null backend: its numbers, its files, and a page whose texts nobody
// can be trusted with.
#include "renderer/capture/breakdown/breakdown.h"

#include "renderer/capture/breakdown/breakdown_json.h"
#include "renderer/capture/breakdown/breakdown_pictures.h"
#include "tests/support/browser.h"
#include "tests/support/scenes/random_scene.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <iterator>

namespace rushlight {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kHostile = "</script><img src=x onerror=alert(1)><!-- \xff\" '";

Breakdown take(uint64_t seed, bool shadows = true) {
    const auto renderer = std::move(Renderer::create({}).value());
    RandomScene scene(*renderer, seed);
    FrameInput input = scene.frame(0);
    input.settings.shadows = shadows;
    auto taken = takeBreakdown(*renderer, input, {96, 54, {}});
    EXPECT_TRUE(taken) << taken.error().text();
    return std::move(*taken);
}

std::string textOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class BreakdownTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    void write(const Breakdown& breakdown, const std::string& name,
               const WrittenBreakdown* other = nullptr) const {
        const auto written = writeBreakdown(path(name), breakdown, other);
        ASSERT_TRUE(written) << written.error().text();
    }
    void expectRefused(const Breakdown& breakdown, const std::string& name,
                       const std::string& why) const {
        const auto written = writeBreakdown(path(name), breakdown);
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().text().find(why), std::string::npos) << written.error().text();
    }
    TemporaryDirectory folder;
};

TEST_F(BreakdownTest, TotalsAreTheCountersOfTheFrame) {
    for (uint64_t seed = 0; seed < 4; ++seed) {
        const Breakdown breakdown = take(seed);
        const ordered_json json = breakdownJson(breakdown).value();
        const ordered_json& outside = json["breakdown"]["outside_passes"];
        uint64_t draws = 0, triangles = 0, calls = outside["gl_calls"],
                 changes = outside["state_changes"];
        for (const ordered_json& pass : json["passes"]) {
            draws += pass["draws"].get<uint64_t>();
            triangles += pass["triangles"].get<uint64_t>();
            calls += pass["gl_calls"].get<uint64_t>();
            changes += pass["state_changes"].get<uint64_t>();
            EXPECT_EQ(pass["images"].size(), pass["writes"].size());
            EXPECT_GT(pass["gl_calls"], 0);
        }
        EXPECT_GT(draws, 0u);
        EXPECT_EQ(draws, json["frame"]["draws"]);
        EXPECT_EQ(triangles, json["frame"]["triangles"]);
        EXPECT_EQ(calls, json["frame"]["gl_calls"]);
        EXPECT_EQ(changes, json["frame"]["state_changes"]);
        EXPECT_LT(outside["gl_calls"].get<uint64_t>(), calls / 2);
    }
}

TEST_F(BreakdownTest, EveryImageThatAPassWritesIsAPictureInAFile) {
    const Breakdown breakdown = take(1);
    write(breakdown, "out");
    const ordered_json json = ordered_json::parse(textOf(path("out/frame.json")));
    size_t images = 0;
    for (const ordered_json& pass : json["passes"]) images += pass["images"].size();
    size_t written = 0;
    for (const ordered_json& picture : json["breakdown"]["pictures"]) {
        written += picture["pass"] >= 0;
        EXPECT_GT(fs::file_size(path("out/" + picture["file"].get<std::string>())), 50u);
    }
    EXPECT_EQ(written, images);
    EXPECT_EQ(textOf(path("out/commands.txt")), breakdown.commands);
    EXPECT_NE(breakdown.commands.find("BeginPass 0 "), std::string::npos);
}

TEST_F(BreakdownTest, TheReportKeepsNoTexels) {
    for (const PassReport& pass : take(2).report.passes)
        for (const PassImage& image : pass.images) EXPECT_TRUE(image.texels.empty());
}

TEST_F(BreakdownTest, NoTextBecomesMarkup) {
    Breakdown breakdown = take(0);
    breakdown.title = kHostile;
    breakdown.commands += kHostile;
    breakdown.pictures[0].title = breakdown.pictures[0].note = kHostile;
    breakdown.host = ordered_json{{"gl_renderer", kHostile}}.dump(
        -1, ' ', false, ordered_json::error_handler_t::replace);
    write(breakdown, "out");
    const std::string page = textOf(path("out/index.html"));
    EXPECT_EQ(page.find("<img src=x"), page.npos);
    EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org/2000/svg"));
    EXPECT_EQ(page.find("https://"), page.npos);
    size_t scripts = 0;
    for (size_t at = 0; (at = page.find("</script>", at)) != page.npos; ++at) ++scripts;
    EXPECT_EQ(scripts, 2u);
    if (browser().empty()) GTEST_SKIP() << kNoBrowser;
    const std::string document = documentOf(path("out/index.html"));
    EXPECT_EQ(attributeOf(document, "data-check"), "ok") << attributeOf(document, "data-problems");
    EXPECT_EQ(document.find("<img src=\"x\""), document.npos);
    EXPECT_NE(document.find("&lt;/script&gt;&lt;img src=x onerror"), document.npos);
}

TEST_F(BreakdownTest, ThePageNoticesTotalsThatDoNotAgree) {
    if (browser().empty()) GTEST_SKIP() << kNoBrowser;
    Breakdown breakdown = take(0);
    breakdown.report.draws += 1;
    write(breakdown, "out");
    const std::string document = documentOf(path("out/index.html"));
    EXPECT_EQ(attributeOf(document, "data-check"), "failed");
    EXPECT_NE(attributeOf(document, "data-problems").find("draws"), std::string::npos);
}

TEST_F(BreakdownTest, PassesThatDifferComeFirst) {
    const auto pass = [](const char* name, const char* hash, int draws) {
        return ordered_json{
            {"name", name}, {"draws", draws}, {"images", {{{"name", "i"}, {"hash", hash}}}}};
    };
    const ordered_json a = {pass("one", "1", 1), pass("two", "1", 2), pass("three", "1", 1),
                            pass("four", "1", 1)};
    const ordered_json b = {pass("one", "1", 1), pass("two", "1", 1), pass("three", "2", 1),
                            pass("five", "1", 1)};
    const ordered_json pairs = comparePasses(a, b);
    std::string order;
    for (const ordered_json& pair : pairs) order += pair["name"].get<std::string>() + " ";
    EXPECT_EQ(order, "three four five two one ");
    EXPECT_TRUE(pairs[0]["outputs"]);
    EXPECT_TRUE(pairs[1]["b"].is_null());
    EXPECT_TRUE(pairs[2]["a"].is_null());
    EXPECT_EQ(pairs[3]["counters"], ordered_json({"draws"}));
    EXPECT_EQ(pairs[4]["counters"], ordered_json::array());
}

TEST_F(BreakdownTest, TwoFramesSideBySideInTheBrowser) {
    write(take(3, false), "without");
    const auto other = loadBreakdown(path("without/frame.json"));
    ASSERT_TRUE(other) << other.error().text();
    write(take(3), "with", &*other);
    fs::remove_all(path("without"));  // the page holds all of it
    if (browser().empty()) GTEST_SKIP() << kNoBrowser;
    const std::string document = documentOf(path("with/index.html"));
    EXPECT_EQ(attributeOf(document, "data-check"), "ok") << attributeOf(document, "data-problems");
    EXPECT_NE(document.find("only in this"), document.npos);
    EXPECT_NE(document.find("id=\"comparison\""), document.npos);
}

TEST_F(BreakdownTest, RefusesAFrameThatIsNoneOrLeavesItsFolder) {
    write(take(0), "out");
    ordered_json json = ordered_json::parse(textOf(path("out/frame.json")));
    const auto refusal = [&](const ordered_json& changed) {
        folder.write("changed.json", changed.dump());
        const auto loaded = loadBreakdown(path("changed.json"));
        return loaded ? std::string() : loaded.error().message;
    };
    EXPECT_EQ(refusal(json), "");
    EXPECT_NE(refusal(ordered_json::array()), "");
    EXPECT_NE(refusal({{"frame", {{"draws", 1}}}}), "");
    for (const char* file :
         {"../secret.png", "/etc/passwd", "pictures/../../a.png", "pictures/", "pictures/.."}) {
        ordered_json changed = json;
        changed["breakdown"]["pictures"][0]["file"] = file;
        EXPECT_EQ(refusal(changed), "It names a picture outside of its folder.") << file;
    }
    for (const char* key : {"title", "width", "exact"}) {
        ordered_json changed = json;
        changed["breakdown"]["pictures"][0].erase(key);
        EXPECT_NE(refusal(changed), "") << key;
    }
    EXPECT_FALSE(loadBreakdown(path("nowhere.json")));
}

TEST_F(BreakdownTest, KeepsWhatIsInTheFolder) {
    folder.write("mine/index.html", "my page");
    expectRefused(take(0), "mine", "index.html that is no breakdown's");
    EXPECT_EQ(textOf(path("mine/index.html")), "my page");

    folder.write("out/notes.txt", "my notes");
    write(take(0), "out");
    const std::string first = textOf(path("out/frame.json"));
    folder.write("out/pictures/mine.png", "my picture");
    write(take(3, false), "out");  // its own files are replaced
    EXPECT_NE(textOf(path("out/frame.json")), first);
    EXPECT_EQ(textOf(path("out/notes.txt")), "my notes");
    EXPECT_EQ(textOf(path("out/pictures/mine.png")), "my picture");
    EXPECT_FALSE(fs::exists(path("out/pictures/shadow.0.shadow-map.png")));
}

TEST_F(BreakdownTest, SaysWhyItCannotWrite) {
    const Breakdown breakdown = take(0);
    folder.write("file", "text");
    expectRefused(breakdown, "file", "This is a file; name a folder.");
    EXPECT_EQ(textOf(path("file")), "text");
    expectRefused(breakdown, "file/below", "cannot be written");
    Breakdown wrong = breakdown;
    wrong.host = "[1]";
    expectRefused(wrong, "out", "no JSON object");
    EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(BreakdownTest, AFullDiskLeavesTheOldBreakdown) {
    write(take(0), "out");
    const std::string page = textOf(path("out/index.html")), json = textOf(path("out/frame.json"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{page.size() / 2, before.rlim_max};  // the pictures fit, the page does not
    setrlimit(RLIMIT_FSIZE, &small);
    const auto written = writeBreakdown(path("out"), take(1));
    const auto fresh = writeBreakdown(path("new"), take(1));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().text().find("index.html: The file could not be written"),
              std::string::npos)
        << written.error().text();
    EXPECT_EQ(textOf(path("out/index.html")), page);
    EXPECT_EQ(textOf(path("out/frame.json")), json);
    for (const auto& entry : fs::directory_iterator(path("out")))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".breakdown")) << entry.path();
    ASSERT_FALSE(fresh);
    EXPECT_FALSE(fs::exists(path("new")));
}

TEST_F(BreakdownTest, CulledBoxesHaveTheirColours) {
    const std::vector<uint8_t> frame(16, 100);
    const auto changed = [&](std::vector<uint8_t> picture, size_t pixel) {
        picture[pixel * 4] = 0;
        return picture;
    };
    const auto visible = changed(frame, 0), unhidden = changed(visible, 1),
               all = changed(unhidden, 2);
    const std::vector<uint8_t> picture = culledPicture(frame, visible, unhidden, all);
    EXPECT_GT(picture[1], picture[0]);                                      // green: drawn
    EXPECT_GT(picture[4], 2 * picture[5]);                                  // red: hidden
    EXPECT_TRUE(picture[8] == 255 && picture[9] > 2 * picture[10]);         // yellow: small
    EXPECT_TRUE(picture[12] == picture[13] && picture[13] == picture[14]);  // the frame in grey
}

TEST_F(BreakdownTest, DepthReadsAsMetresByTheLogarithm) {
    BreakdownPicture picture;
    PassImage image{"depth", Format::depth32f, 3, 1, 0, {}};
    const float depths[] = {0, 0.1f / 2, 0.1f / 8};  // nothing, 2 m, 8 m
    const auto bytes = std::as_bytes(std::span(depths));
    image.texels.assign(bytes.begin(), bytes.end());
    fillPicture(picture, image, {.depthDecode = {10, 0}});
    EXPECT_EQ(picture.readout, Readout::distance);
    EXPECT_EQ(picture.rgba8[0], 0);
    const auto metres = [&](uint8_t grey) {  // as the page reads it
        return picture.low * std::pow(picture.high / picture.low, 1 - float(grey) / 255);
    };
    EXPECT_NEAR(metres(picture.rgba8[4]), 2, 0.02f);
    EXPECT_NEAR(metres(picture.rgba8[8]), 8, 0.08f);
}

}  // namespace
}  // namespace rushlight
