#include "tests/support/scenes/metamorphic.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

std::unique_ptr<TestContext> Metamorphic::context_;
std::unique_ptr<TemporaryDirectory> Metamorphic::cache_;
std::unique_ptr<Renderer> Metamorphic::renderer_;

Difference difference(const std::vector<float>& a, const std::vector<float>& b, float step) {
    Difference found;
    double sum = 0, all = 0, pixels = 0;
    for (size_t i = 0; i + 3 < a.size() && i + 3 < b.size(); i += 4) {
        bool differs = false;
        for (size_t c = i; c < i + 3; ++c) {
            const float apart = std::abs(a[c] - b[c]);
            sum += double(apart);
            all += double(a[c]);
            differs |= apart > std::max(step * std::max(a[c], b[c]), 1e-3f) ||
                       !std::isfinite(apart);
        }
        pixels += differs;
    }
    found.mean = sum / std::max(all, 1e-9);
    found.differing = pixels / std::max(double(a.size() / 4), 1.0);
    return found;
}

Difference mirroredDifference(const std::vector<float>& a, std::vector<float> b, uint32_t width,
                              float step) {
    const size_t row = size_t(width) * 4;
    for (size_t first = 0; first + row <= b.size(); first += row)
        for (size_t x = 0; x < width / 2; ++x)
            std::swap_ranges(&b[first + x * 4], &b[first + x * 4 + 4], &b[first + row - x * 4 - 4]);
    return difference(a, b, step);
}

void Metamorphic::SetUpTestSuite() {
    context_ = std::make_unique<TestContext>();
    if (!context_->valid()) return;
    cache_ = std::make_unique<TemporaryDirectory>();
    renderer_ = make(desc());
}

void Metamorphic::TearDownTestSuite() {
    if (renderer_) {
        EXPECT_EQ(renderer_->takeDebugMessages(), std::vector<std::string>{});
    }
    renderer_.reset();
    cache_.reset();
    context_.reset();
}

void Metamorphic::SetUp() {
    ASSERT_TRUE(context_->valid()) << "no surfaceless EGL context with OpenGL 4.5";
}

RendererDesc Metamorphic::desc() {
    RendererDesc desc;
    desc.loadGl = TestContext::load;
    desc.cacheDirectory = cache_->path();
    desc.debugOutput = true;
    return desc;
}

std::unique_ptr<Renderer> Metamorphic::make(const RendererDesc& desc) {
    return std::move(Renderer::create(desc).value());
}

Pictures Metamorphic::picture(Renderer& renderer, const FrameInput& input) {
    Pictures pictures;
    CapturedImage image;
    for (const CaptureKind kind : {CaptureKind::hdr, CaptureKind::display}) {
        const auto ticket = renderer.renderOffscreen(input, kWidth, kHeight, kind);
        EXPECT_TRUE(ticket) << ticket.error().text();
        EXPECT_TRUE(ticket && renderer.takeCapture(*ticket, true, image));
        if (kind == CaptureKind::hdr)
            pictures.linear = image.rgba32f;
        else
            pictures.display = image.rgba8;
    }
    return pictures;
}

void Metamorphic::expectSame(const Pictures& a, const Pictures& b) {
    ASSERT_FALSE(a.display.empty());
    const Difference apart = difference(a.linear, b.linear, 0);
    EXPECT_TRUE(a.linear == b.linear)
        << apart.differing * 100 << " % of the pixels differ, by " << apart.mean << " of the mean";
    EXPECT_TRUE(a.display == b.display);
}

void Metamorphic::expectNear(const Pictures& a, const Pictures& b, double differing, double mean,
                             float step) {
    ASSERT_FALSE(a.linear.empty());
    const Difference apart = difference(a.linear, b.linear, step);
    EXPECT_LE(apart.differing, differing);
    EXPECT_LE(apart.mean, mean);
}

}  // namespace rushlight
