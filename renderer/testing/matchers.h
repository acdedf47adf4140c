#pragma once
// GoogleTest: EXPECT_FRAME(frame, near("golden/square.png", flip(0.02))), and isNear() for
// EXPECT_THAT. Header only, so that the library links no GoogleTest.

#include "renderer/testing/verdict.h"

#include <gtest/gtest.h>

#include <ostream>

namespace rushlight::golden {

/// Evidence is named after the running test and the golden.
inline EvidenceOptions evidenceOfThisTest(const std::string& golden) {
    EvidenceOptions options;
    const std::string stem = std::filesystem::path(golden).stem().string();
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    options.name = test ? std::string(test->test_suite_name()) + "." + test->name() + "." + stem
                        : stem;
    return options;
}

inline ::testing::AssertionResult checkFrame(const Frame& frame, const Near& expected) {
    const auto verdict = judge(frame, expected, evidenceOfThisTest(expected.path));
    if (!verdict) return ::testing::AssertionFailure() << verdict.error().text();
    return (verdict->passed ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << verdict->text();
}

/// A frame that could not be rendered fails with its reason.
inline ::testing::AssertionResult checkFrame(const Result<Frame>& frame, const Near& expected) {
    if (!frame) return ::testing::AssertionFailure() << frame.error().text();
    return checkFrame(*frame, expected);
}

/// EXPECT_THAT(frame, isNear(near("golden/square.png", flip(0.02)))), of a Frame or a
/// Result<Frame>.
class IsNear {
public:
    using is_gtest_matcher = void;
    explicit IsNear(Near expected) : expected_(std::move(expected)) {}

    template <class AnyFrame>
    bool MatchAndExplain(const AnyFrame& frame, std::ostream* explanation) const {
        const auto result = checkFrame(frame, expected_);
        if (!result && explanation) *explanation << result.message();
        return bool(result);
    }
    void DescribeTo(std::ostream* out) const { *out << "is near " << expected_.path; }
    void DescribeNegationTo(std::ostream* out) const { *out << "is not near " << expected_.path; }

private:
    Near expected_;
};

inline IsNear isNear(Near expected) { return IsNear(std::move(expected)); }

/// What gtest prints of a frame: its size, not its pixels.
inline void PrintTo(const Frame& frame, std::ostream* out) {
    *out << "a frame of " << frame.image.width << "x" << frame.image.height << " pixels";
}

}  // namespace rushlight::golden

/// `frame`: a golden::Frame or a Result of one.
#define EXPECT_FRAME(frame, expected) EXPECT_TRUE(::rushlight::golden::checkFrame(frame, expected))
#define ASSERT_FRAME(frame, expected) ASSERT_TRUE(::rushlight::golden::checkFrame(frame, expected))
