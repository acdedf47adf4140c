// How wide the edge of a shadow is under lights that have a size.

#include "tests/support/scenes/lit_frame.h"

#include <cmath>

namespace rushlight {
namespace {

class PenumbraGl : public LitFrame {
protected:
    static constexpr uint32_t kPixels = 160;
    static constexpr float kHalf = 0.45f;  ///< metres of the ground to each side of the middle

    PenumbraGl() : LitFrame(kPixels, kPixels) {}

    void SetUp() override {
        LitFrame::SetUp();
        if (!renderer) return;
        lookDown(kHalf, 6);
        input.settings.shadowFilter = ShadowFilter::soft;
        input.settings.shadowCascades = 1;
        MaterialDesc chalk;
        chalk.metallic = 0;
        ground_ = *renderer->createMaterial(chalk);
    }
    /// Light from +x, 45 degrees high, past the edge of a screen at this height: its shadow ends at
    /// x = 0.
    void hideBehindEdge(float up) {
        instances.clear();
        addBox({0, -0.5f, 0}, {4, 0.5f, 4}, ground_).flags = 0;
        addBox({up + 3, up, 0}, {3, 0.002f, 3}, ground_);
    }
    /// Metres over which the light rises from a tenth to nine tenths, in the middle row.
    float width() {
        const CapturedImage image = render();
        const auto lit = [&](uint32_t x) { return pixelOf(image, x, kPixels / 2).x; };
        const float dark = lit(kPixels - 1), bright = lit(0);
        EXPECT_LT(dark, 0.05f * bright);
        const auto crossing = [&](float share) {
            for (uint32_t x = 1; x < kPixels; ++x) {
                const float before = (lit(x - 1) - dark) / (bright - dark);
                const float after = (lit(x) - dark) / (bright - dark);
                if (before >= share && after < share)
                    return (float(x) - (share - after) / (before - after)) * 2 * kHalf / kPixels;
            }
            ADD_FAILURE() << "the light never passes " << share;
            return 0.0f;
        };
        return crossing(0.1f) - crossing(0.9f);
    }

private:
    MaterialHandle ground_;
};

// A straight edge hides a disk up to t of its radius: 1 - (acos t - t sqrt(1 - t²)) / π of it are
// seen. A tenth is left, or gone, at t = ±0.687. Rays that are 45 degrees steep take sqrt 2 of the
// height, and sqrt 2 of their width on the ground.
TEST_F(PenumbraGl, WidensWithTheDistanceOfWhatCasts) {
    constexpr float kRadius = 0.025f;
    const DirectionalLight sun{glm::normalize(vec3(-1, -1, 0)), vec3(3), true, kRadius};
    input.lighting.directional = {&sun, 1};
    for (const float up : {0.5f, 1.0f, 1.5f}) {
        hideBehindEdge(up);
        const float expected = 2 * 0.687f * 2 * up * std::tan(kRadius);
        EXPECT_NEAR(width(), expected, 0.25f * expected) << up;
    }
}

}  // namespace
}  // namespace rushlight
