#include "renderer/capture/image_files.h"
#include "renderer/testing/matchers.h"
#include "renderer/testing/review.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace rushlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kWidth = 12, kHeight = 8;

/// Grey that grows from the first row to the last, with so much more red.
Frame grey(uint8_t red = 0, uint32_t width = kWidth) {
    Frame frame;
    frame.image.width = width;
    frame.image.height = kHeight;
    for (uint32_t i = 0; i < width * kHeight; ++i) {
        const uint8_t value = uint8_t(40 + 20 * (i / width));
        frame.image.rgba8.insert(frame.image.rgba8.end(),
                                 {uint8_t(value + red), value, value, 255});
    }
    return frame;
}

class GoldenPictures : public testing::Test {
protected:
    GoldenPictures() {
        unsetenv("RUSHLIGHT_EVIDENCE_ALWAYS");
        save("g.png", grey());
    }

    std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    void save(const std::string& name, const Frame& frame) const {
        EXPECT_TRUE(saveImage(path(name), PictureView(frame.image)));
    }
    bool has(const std::string& name) const { return fs::exists(path(name)); }
    std::string bytes(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void spoil(const std::string& name) const { folder_.write(name, "no picture"); }
    Result<Verdict> judgeBy(const Frame& frame, Near near, const std::string& name = "t",
                            bool always = false) const {
        return judge(frame, near, {.folder = path("evidence"), .name = name, .always = always});
    }
    Verdict verdictOf(const Frame& frame, Criterion criterion,
                      const std::string& name = "t") const {
        auto verdict = judgeBy(frame, near(path("g.png"), criterion), name);
        EXPECT_TRUE(verdict) << verdict.error().text();
        return *verdict;
    }
    std::vector<Review> reviews(const std::string& folder = "evidence") const {
        auto found = reviewEvidence(path(folder));
        EXPECT_TRUE(found) << found.error().text();
        return found ? *found : std::vector<Review>();
    }

    TemporaryDirectory folder_;
};

TEST_F(GoldenPictures, EqualPixelsMeetEveryCriterion) {
    for (const Criterion& c : {flip(0), psnr(99), ssim(0.9999), maxError(0.001), exact()}) {
        const Verdict verdict = verdictOf(grey(), c);
        EXPECT_TRUE(verdict.passed) << verdict.text();
        EXPECT_TRUE(verdict.evidence.empty());
    }
    EXPECT_FALSE(has("evidence"));
}

TEST_F(GoldenPictures, EachCriterionHasItsLimit) {
    Frame other = grey();
    other.image.rgba8[0] += 51;  // a fifth
    // PSNR: the square of a fifth over 12 * 8 * 3 values.
    const double decibel = -10 * std::log10(0.04 / (kWidth * kHeight * 3));
    EXPECT_TRUE(verdictOf(other, psnr(decibel - 0.01)).passed);
    EXPECT_FALSE(verdictOf(other, psnr(decibel + 0.01)).passed);
    EXPECT_TRUE(verdictOf(other, maxError(0.201)).passed);
    EXPECT_FALSE(verdictOf(other, maxError(0.199)).passed);
    const Figures figures = *verdictOf(other, exact()).figures;
    EXPECT_EQ(figures.changedPixels, 1u);
    EXPECT_EQ(figures.pixels, kWidth * kHeight);
    EXPECT_FALSE(verdictOf(other, exact()).passed);
    EXPECT_TRUE(verdictOf(other, flip(figures.flip)).passed);
    EXPECT_FALSE(verdictOf(other, flip(figures.flip * 0.99)).passed);
    EXPECT_TRUE(verdictOf(other, ssim(figures.ssim)).passed);
    EXPECT_FALSE(verdictOf(other, ssim(figures.ssim + 1e-6)).passed);
    EXPECT_FALSE(meets(flip(1), std::numeric_limits<double>::quiet_NaN()));
}

TEST_F(GoldenPictures, AllCriteriaHaveToBeMet) {
    for (const Near& both :
         {near(path("g.png"), flip(1), psnr(99)), near(path("g.png"), psnr(99), flip(1))}) {
        const auto verdict = judgeBy(grey(20), both);
        ASSERT_TRUE(verdict);
        EXPECT_FALSE(verdict->passed);
        const std::string text = verdict->text();
        EXPECT_NE(text.find("at most 1: ok"), std::string::npos) << text;
        EXPECT_NE(text.find("dB, at least 99: failed"), std::string::npos) << text;
    }
}

TEST_F(GoldenPictures, AFailureLeavesPicturesAndSaysWhere) {
    Frame far = grey(40);
    far.takeApart = [] {
        Breakdown breakdown;
        breakdown.pictures.push_back(
            {"frame", "frame", "t", "", -1, -1, Readout::color, 0, 1, false, 1, 1, {1, 2, 3, 255}});
        return Result<Breakdown>(breakdown);
    };
    const Verdict verdict = verdictOf(far, exact(), "Suite/of.tests");
    EXPECT_EQ(verdict.evidence, path("evidence/Suite_of.tests"));
    EXPECT_EQ(verdict.evidenceProblem, "");
    EXPECT_NE(verdict.text().find(verdict.evidence), std::string::npos);
    for (const char* file :
         {"actual.png", "error.png", "heat.png", "evidence.json", "breakdown/index.html"})
        EXPECT_TRUE(has("evidence/Suite_of.tests/" + std::string(file))) << file;
    EXPECT_EQ(bytes("evidence/Suite_of.tests/golden.png"), bytes("g.png"));
    const auto actual = loadPicture(path("evidence/Suite_of.tests/actual.png"));
    ASSERT_TRUE(actual);
    EXPECT_EQ(actual->rgba, pictureOf(PictureView(far.image)).rgba);
}

TEST_F(GoldenPictures, PassingRemovesWhatFailingLeftAndNothingElse) {
    verdictOf(grey(40), exact());
    folder_.write("evidence/t/mine.txt", "mine");
    verdictOf(grey(40), exact(), "other");
    verdictOf(grey(), exact());
    verdictOf(grey(), exact(), "other");
    EXPECT_FALSE(has("evidence/other"));
    EXPECT_TRUE(has("evidence/t/mine.txt"));
    EXPECT_EQ(std::distance(fs::directory_iterator(path("evidence/t")), {}), 1);
}

TEST_F(GoldenPictures, AMissingGoldenFailsAndIsNotMade) {
    const auto verdict = judgeBy(grey(), near(path("none.png"), flip(1)));
    ASSERT_TRUE(verdict);
    EXPECT_FALSE(verdict->passed);
    EXPECT_TRUE(has("evidence/t/actual.png"));
    EXPECT_FALSE(has("none.png"));
    EXPECT_NE(verdict->text().find("rushlight goldens \"" + path("evidence/t") + "\" --accept"),
              std::string::npos);
}

TEST_F(GoldenPictures, WhatCannotBeComparedIsSaid) {
    const Verdict size = verdictOf(grey(0, kWidth + 1), flip(1));
    EXPECT_FALSE(size.passed);
    EXPECT_NE(size.problem.find("13x8"), std::string::npos) << size.problem;
    spoil("broken.png");
    const auto broken = judgeBy(grey(), near(path("broken.png"), flip(1)));
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().kind, ErrorKind::badInput);
    for (const char* wrong : {"g.exr", "g.jpg", "g"}) {
        const auto refused = judgeBy(grey(), near(path(wrong), flip(1)));
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().kind, ErrorKind::wrongUse);
    }
    EXPECT_FALSE(judgeBy(grey(), Near{path("g.png"), {}}));
}

TEST_F(GoldenPictures, LinearFramesHaveLinearGoldens) {
    const std::vector<float> radiance(kWidth * kHeight * 4, 8.0f);
    const auto frame = hostFrame(kWidth, kHeight, std::span(radiance), RowOrder::topDown);
    ASSERT_TRUE(frame);
    const auto first = judgeBy(*frame, near(path("hdr.exr"), exact()));
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->passed);
    ASSERT_EQ(reviews().size(), 1u);
    EXPECT_TRUE(accept(reviews()[0]));
    EXPECT_TRUE(judgeBy(*frame, near(path("hdr.exr"), exact()))->passed);
    EXPECT_FALSE(judgeBy(*frame, near(path("g.png"), exact())));
}

TEST(GoldenFrames, HostsRowsComeInEitherOrder) {
    const Frame frame = grey();
    std::vector<uint8_t> turned;
    for (uint32_t y = kHeight; y-- > 0;)
        turned.insert(turned.end(), &frame.image.rgba8[y * kWidth * 4],
                      &frame.image.rgba8[y * kWidth * 4] + kWidth * 4);
    EXPECT_EQ(hostFrame(kWidth, kHeight, std::span<const uint8_t>(turned), RowOrder::bottomUp)
                  ->image.rgba8,
              frame.image.rgba8);
    EXPECT_EQ(hostFrame(kWidth, kHeight, std::span<const uint8_t>(turned), RowOrder::topDown)
                  ->image.rgba8,
              turned);
    EXPECT_EQ(hostFrame(kWidth, kHeight + 1, std::span<const uint8_t>(turned), RowOrder::topDown)
                  .error()
                  .kind,
              ErrorKind::wrongUse);
    EXPECT_FALSE(hostFrame(0, 0, std::span<const uint8_t>(), RowOrder::topDown));
}

TEST(GoldenFrames, APathIsFromTheFileThatNamesIt) {
    const fs::path here = findSourceFile(__FILE__).parent_path();
    EXPECT_TRUE(fs::exists(here / "golden_test.cpp")) << here;
    EXPECT_EQ(near("a/b.png", exact()).path, (here / "a/b.png").string());
    EXPECT_EQ(near(std::string("c.png"), exact()).path, (here / "c.png").string());
    EXPECT_EQ(near(fs::path("/d.png"), exact()).path, "/d.png");
}

TEST(GoldenFrames, ASourceFileIsFoundFromTheProgramUpwards) {
    const fs::path program = fs::read_symlink("/proc/self/exe");
    const fs::path name = program.parent_path().filename() / program.filename();
    EXPECT_EQ(findSourceFile(name), program);
    EXPECT_EQ(findSourceFile("no/such/file.cpp"), "no/such/file.cpp");
    EXPECT_EQ(findSourceFile("/no/such/file.cpp"), "/no/such/file.cpp");
}

TEST_F(GoldenPictures, AReviewSaysWhatWouldChange) {
    verdictOf(grey(40), exact(), "changed");
    judgeBy(grey(), near(path("new.png"), exact()), "new").value();
    judgeBy(grey(), near(path("g.png"), exact()), "same", true).value();
    save("h.png", grey(9));
    judgeBy(grey(), near(path("h.png"), exact()), "outdated").value();
    save("h.png", grey(10));
    const auto found = reviews();
    // "changed" and "same" have two pictures for one golden.
    const std::vector<Change> expected = {Change::disputed, Change::added, Change::outdated,
                                          Change::disputed};
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i].change, expected[i]) << found[i].evidence.name;
    for (size_t i : {0, 2, 3}) EXPECT_FALSE(accept(found[i]));
    EXPECT_EQ(reviews("evidence/same")[0].change, Change::none);
    EXPECT_EQ(reviews("evidence/changed")[0].change, Change::changed);
    EXPECT_EQ(reviews("evidence/changed")[0].figures->changedPixels, kWidth * kHeight);
    EXPECT_FALSE(reviewEvidence(path("none")));
    EXPECT_FALSE(reviewEvidence(folder_.path() + "/evidence/same/golden.png"));
}

TEST_F(GoldenPictures, AcceptingWritesTheGoldenOnce) {
    const std::string before = bytes("g.png");
    verdictOf(grey(40), exact());
    const auto found = reviews();
    EXPECT_EQ(bytes("g.png"), before) << "a review changes nothing";
    ASSERT_TRUE(accept(found[0]));
    EXPECT_EQ(bytes("g.png"), bytes("evidence/t/actual.png"));
    EXPECT_TRUE(verdictOf(grey(40), exact(), "again").passed);
    EXPECT_EQ(reviews()[0].change, Change::none);
    EXPECT_FALSE(accept(found[0])) << "the golden is another than the one that was reviewed";
}

TEST_F(GoldenPictures, EvidenceAndGoldensMayMoveTogether) {
    fs::create_directories(path("here"));
    fs::rename(path("g.png"), path("here/g.png"));
    ASSERT_TRUE(judge(grey(40), near(path("here/g.png"), exact()),
                      {.folder = path("here/evidence"), .name = "t"}));
    fs::rename(path("here"), path("there"));
    const auto found = reviews("there");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].evidence.golden, path("there/g.png"));
    ASSERT_TRUE(accept(found[0]));
    EXPECT_EQ(bytes("there/g.png"), bytes("there/evidence/t/actual.png"));
}

TEST_F(GoldenPictures, AGoldenWithTheSamePixelsIsNotTouched) {
    const auto encoded = encodeImage("g.png", ImageFormat::png, PictureView(grey().image),
                                     EncodeEffort::small);
    folder_.write(
        "g.png",
        std::string(reinterpret_cast<const char*>(encoded->data()), encoded->size()) + " ");
    const std::string before = bytes("g.png");
    judgeBy(grey(), near(path("g.png"), exact()), "t", true).value();
    ASSERT_EQ(reviews().size(), 1u);
    EXPECT_TRUE(accept(reviews()[0]));
    EXPECT_EQ(bytes("g.png"), before);
}

TEST_F(GoldenPictures, EvidenceIsCheckedBeforeItIsUsed) {
    verdictOf(grey(40), exact());
    std::string json = bytes("evidence/t/evidence.json");
    const size_t at = json.find("g.png");
    for (const char* wrong : {"g.txt", "g.exr"}) {
        folder_.write("evidence/t/evidence.json", std::string(json).replace(at, 5, wrong));
        EXPECT_FALSE(reviewEvidence(path("evidence"))) << wrong;
    }
    for (const char* wrong : {"", "[]", "{}", "{\"version\": \"1\"}"}) {
        folder_.write("evidence/t/evidence.json", wrong);
        EXPECT_FALSE(reviewEvidence(path("evidence"))) << wrong;
    }
    folder_.write("evidence/t/evidence.json", json);
    spoil("evidence/t/actual.png");
    EXPECT_FALSE(reviewEvidence(path("evidence")));
}

TEST_F(GoldenPictures, ThePageShowsBeforeAndAfter) {
    verdictOf(grey(40), exact(), "a&b");
    const std::string page = reviewPage(reviews(), path("evidence"));
    for (const char* text :
         {"a_b/golden.png", "a_b/actual.png", "a_b/heat.png", "96 of 96 pixels differ"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(GoldenPictures, TheMatchersFailWithFigures) {
    setenv("RUSHLIGHT_EVIDENCE", path("evidence").c_str(), 1);
    static std::string golden;  // what EXPECT_NONFATAL_FAILURE runs sees no other locals
    golden = path("g.png");
    EXPECT_FRAME(grey(), near(path("g.png"), exact()));
    EXPECT_FRAME(Result<Frame>(grey()), near(path("g.png"), flip(0)));
    EXPECT_NONFATAL_FAILURE(EXPECT_FRAME(grey(40), near(golden, maxError(0.1))),
                            "max error      0.156863, at most 0.1: failed");
    EXPECT_TRUE(has("evidence/GoldenPictures.TheMatchersFailWithFigures.g/actual.png"));
    EXPECT_NONFATAL_FAILURE(
        EXPECT_FRAME(Result<Frame>(fail("a", "No frame.")), near(golden, exact())), "a: No frame.");
    EXPECT_TRUE(isNear(near(path("g.png"), exact())).MatchAndExplain(grey(), nullptr));
    EXPECT_FALSE(isNear(near(path("g.png"), exact())).MatchAndExplain(grey(1), nullptr));
    unsetenv("RUSHLIGHT_EVIDENCE");
}

}  // namespace
}  // namespace rushlight::golden
