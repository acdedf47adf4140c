#pragma once
// A scene drawn twice, the second time with its input changed in a way that must not change the
// picture.

#include "renderer/renderer.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/varied_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace rushlight {

/// One frame, as it is presented and as linear radiance.
struct Pictures {
    std::vector<uint8_t> display;
    std::vector<float> linear;
    bool operator==(const Pictures&) const = default;
};

/// How far two pictures of linear radiance are apart. A pixel differs where a channel does by more
/// than `step` of the greater value, and by more than 1/1000.
struct Difference {
    double mean = 0;       ///< of the absolute differences over the mean radiance
    double differing = 0;  ///< share of pixels
};
Difference difference(const std::vector<float>& a, const std::vector<float>& b, float step);

/// As difference, with the second picture's columns in reverse.
Difference mirroredDifference(const std::vector<float>& a, std::vector<float> b, uint32_t width,
                              float step);

class Metamorphic : public testing::Test {
protected:
    static constexpr uint32_t kWidth = 160, kHeight = 90;
    /// A half float's last place is 1/1024 of the value or less; sums in another order may end one
    /// beside.
    static constexpr float kHalfStep = 1.5f / 1024;

    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;

    /// Programs are compiled once for all tests of the process.
    static RendererDesc desc();
    static std::unique_ptr<Renderer> make(const RendererDesc& desc);
    /// For tests that need no renderer of their own.
    static Renderer& renderer() { return *renderer_; }

    static Pictures picture(Renderer& renderer, const FrameInput& input);
    static Pictures picture(const FrameInput& input) { return picture(renderer(), input); }
    /// The pictures are the same bytes.
    static void expectSame(const Pictures& a, const Pictures& b);
    /// At most `differing` of the pixels differ beyond `step`, and the mean by at most `mean`.
    static void expectNear(const Pictures& a, const Pictures& b, double differing, double mean,
                           float step = kHalfStep);

private:
    static std::unique_ptr<TestContext> context_;
    static std::unique_ptr<TemporaryDirectory> cache_;
    static std::unique_ptr<Renderer> renderer_;
};

}  // namespace rushlight
