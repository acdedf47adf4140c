// What the frame breakdown is made of: light in parts that add up, overdraw, and numbers that
// looking does not change.
#include "renderer/capture/breakdown/breakdown.h"
#include "tests/support/random.h"
#include "tests/support/scenes/lit_frame.h"
#include "tests/support/scenes/random_scene.h"

#include <glm/gtc/packing.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 96, kHeight = 54;

class BreakdownGlTest : public LitFrame {
protected:
    BreakdownGlTest() : LitFrame(kWidth, kHeight) {}

    CapturedImage show(const FrameInput& frame, DebugView image,
                       CaptureKind kind = CaptureKind::hdr, const FrameOptions& options = {}) {
        FrameInput shown = frame;
        shown.settings.debugView = image;
        CapturedImage picture;
        const auto ticket = renderer->renderOffscreen(shown, kWidth, kHeight, kind, options);
        EXPECT_TRUE(ticket) << ticket.error().text();
        if (ticket) renderer->takeCapture(*ticket, true, picture);
        return picture;
    }

    /// Direct + ambient * share + emission against the lit image; the number of values that are
    /// over zero in each part.
    std::array<size_t, 4> expectPartsAddUp(const FrameInput& frame) {
        constexpr DebugView kParts[] = {DebugView::direct, DebugView::ambient,
                                        DebugView::ambientShare, DebugView::emission};
        std::array<CapturedImage, 4> parts;
        std::array<size_t, 4> lit{};
        for (size_t p = 0; p < 4; ++p) parts[p] = show(frame, kParts[p]);
        const CapturedImage whole = show(frame, DebugView::lighting);
        size_t wrong = 0;
        for (size_t i = 0; i < whole.rgba32f.size(); ++i) {
            if (i % 4 == 3) continue;
            const auto of = [&](size_t p) { return parts[p].rgba32f[i]; };
            for (size_t p = 0; p < 4; ++p) lit[p] += of(p) > 0.001f;
            const float sum = of(0) + of(1) * of(2) + of(3), expected = whole.rgba32f[i];
            // Half floats: each term and the product of two are rounded.
            if (std::abs(sum - expected) > 0.003f * expected + 2e-4f && ++wrong <= 3)
                ADD_FAILURE() << "value " << i << ": " << sum << " of " << expected << " = "
                              << of(0) << " + " << of(1) << " * " << of(2) << " + " << of(3);
        }
        EXPECT_EQ(wrong, 0u);
        return lit;
    }
};

TEST_F(BreakdownGlTest, LightInPartsAddsUp) {
    lookDown(3, 6);
    addBox({0, -1, 0}, {3, 1, 3});
    addBox({0, 0.5f, 0}, {0.5f, 0.5f, 0.5f});
    addBox({1.5f, 0.3f, 0}, {0.3f, 0.3f, 0.3f}, glowing({2, 1, 0.5f}));
    const DirectionalLight sun{.direction = glm::normalize(vec3(0.6f, -1, 0.3f)),
                               .illuminance = {3, 3, 2}};
    PunctualLight lamp;
    lamp.position = {-1, 1, 1};
    lamp.intensity = vec3(4, 2, 1);
    input.lighting.directional = {&sun, 1};
    input.lighting.punctual = {&lamp, 1};
    input.lighting.ambientSky = {0.5f, 0.7f, 1};
    input.lighting.ambientGround = {0.2f, 0.1f, 0.1f};
    input.settings.ambientOcclusion = AmbientOcclusion::high;
    input.settings.contactShadows = ContactShadows::lights;
    input.instances = instances;
    for (const size_t lit : expectPartsAddUp(input)) EXPECT_GT(lit, 50u);

    // The share is what occlusion leaves: less beside the box than in the open, and all of it
    // without occlusion.
    const auto lowest = [&] {
        float least = 10;
        const CapturedImage share = show(input, DebugView::ambientShare);
        const CapturedImage ambient = show(input, DebugView::ambient);
        for (size_t i = 0; i < share.rgba32f.size(); i += 4)
            if (ambient.rgba32f[i] > 0.01f) least = std::min(least, share.rgba32f[i]);
        return least;
    };
    EXPECT_LT(lowest(), 0.9f);
    input.settings.ambientOcclusion = AmbientOcclusion::off;
    EXPECT_NEAR(lowest(), 1, 0.002f);
}

TEST_F(BreakdownGlTest, LightInPartsAddsUpInScenesOfAllKinds) {
    for (uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        RandomScene scene(*renderer, seed);
        expectPartsAddUp(scene.frame(0));
    }
}

// Where there is no surface the G-buffer holds zeroes, which would be lit as one that looks at a
// corner: suns on both sides of it, so that one shines on it.
TEST_F(BreakdownGlTest, LightFallsOnSurfacesAlone) {
    lookDown(3, 6);
    addBox({0, 0, 0}, {1, 1, 1});
    const DirectionalLight suns[] = {
        {.direction = glm::normalize(vec3(1, -0.9f, 1)), .illuminance = vec3(9)},
        {.direction = glm::normalize(vec3(-1, 0.9f, -1)), .illuminance = vec3(9)}};
    input.lighting.directional = suns;
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
    input.lighting.backgroundColor = vec3(0.5f);
    input.instances = instances;
    for (const DebugView part :
         {DebugView::untextured, DebugView::direct, DebugView::ambient, DebugView::ambientShare}) {
        const CapturedImage picture = show(input, part);
        EXPECT_EQ(pixelOf(picture, 1, 1), vec3(0)) << int(part);
        EXPECT_EQ(pixelOf(picture, kWidth - 2, kHeight - 2), vec3(0)) << int(part);
        EXPECT_GT(pixelOf(picture, kWidth / 2, kHeight / 2).g, 0.1f) << int(part);
    }
}

TEST_F(BreakdownGlTest, OverdrawCountsWhatTheGBufferWasWrittenWith) {
    lookDown(3, 6);
    Random random(5);
    for (int i = 0; i < 60; ++i)  // they cross each other, so that no order draws each pixel once
        addBox({random.uniform(-2, 2), random.uniform(-1, 1), random.uniform(-2, 2)},
               {random.uniform(0.1f, 1), random.uniform(0.1f, 1), random.uniform(0.1f, 1)});
    input.instances = instances;
    input.settings.debugView = DebugView::overdraw;
    const auto texelsOf = [&](const char* name) {
        std::vector<std::byte> texels;
        for (const PassReport& pass : renderer->report().passes)
            for (const PassImage& image : pass.images)
                if (std::string_view(image.name) == name) texels = image.texels;
        return texels;
    };
    show(input, DebugView::overdraw, CaptureKind::display, {.keepImages = true});
    const std::vector<std::byte> counts = texelsOf("overdraw");
    EXPECT_FALSE(hasPass("gbuffer"));
    show(input, DebugView::none, CaptureKind::display, {.keepImages = true});
    const std::vector<std::byte> depths = texelsOf("depth");
    ASSERT_EQ(counts.size(), size_t(kWidth) * kHeight * 2);
    ASSERT_EQ(depths.size(), size_t(kWidth) * kHeight * 4);
    float most = 0;
    for (size_t i = 0; i < size_t(kWidth) * kHeight; ++i) {
        uint16_t half;
        float depth;
        std::memcpy(&half, &counts[i * 2], 2);
        std::memcpy(&depth, &depths[i * 4], 4);
        const float count = glm::unpackHalf1x16(half);
        EXPECT_EQ(count, std::round(count));
        EXPECT_EQ(count > 0, depth > 0) << i;
        most = std::max(most, count);
    }
    EXPECT_GE(most, 2);
    EXPECT_LE(most, 60);
}

TEST_F(BreakdownGlTest, LookingIntoAFrameChangesNoCounter) {
    RandomScene scene(*renderer, 2);
    FrameInput frame = scene.frame(0);
    frame.settings.shadowCaching = false;
    for (int i = 0; i < 8; ++i)  // timers are made one frame after the other
        show(frame, DebugView::none, CaptureKind::display);
    const FrameReport plain = renderer->report();
    show(frame, DebugView::none, CaptureKind::display, {.hashPasses = true, .keepImages = true});
    const FrameReport looked = renderer->report();
    EXPECT_EQ(plain.draws, looked.draws);
    EXPECT_EQ(plain.stateChanges, looked.stateChanges);
    ASSERT_EQ(plain.passes.size(), looked.passes.size());
    uint32_t calls = 0, changes = 0;
    for (size_t i = 0; i < plain.passes.size(); ++i) {
        EXPECT_EQ(plain.passes[i].glCalls, looked.passes[i].glCalls) << plain.passes[i].name;
        EXPECT_EQ(plain.passes[i].stateChanges, looked.passes[i].stateChanges)
            << plain.passes[i].name;
        EXPECT_GT(plain.passes[i].glCalls, plain.passes[i].stateChanges);
        EXPECT_EQ(looked.passes[i].images.size(), looked.passes[i].writes.size());
        for (const PassImage& image : looked.passes[i].images)
            EXPECT_EQ(image.texels.size(),
                      size_t(image.width) * image.height * bytesPerTexel(image.format));
        calls += looked.passes[i].glCalls, changes += looked.passes[i].stateChanges;
    }
    EXPECT_LT(calls, looked.glCalls);
    EXPECT_LE(changes, looked.stateChanges);
}

TEST_F(BreakdownGlTest, TheFrameIsTheOneThatIsCaptured) {
    RandomScene scene(*renderer, 4);
    const FrameInput frame = scene.frame(0);
    const CapturedImage captured = show(frame, DebugView::none, CaptureKind::display);
    const auto taken = takeBreakdown(*renderer, frame, {kWidth, kHeight, {}});
    ASSERT_TRUE(taken) << taken.error().text();
    size_t found = 0;
    for (const BreakdownPicture& picture : taken->pictures) {
        if (picture.name != "frame") continue;
        ++found;
        size_t differing = 0;
        for (size_t i = 0; i < captured.rgba8.size(); ++i)
            differing += i % 4 != 3 && captured.rgba8[i] != picture.rgba8[i];
        EXPECT_EQ(differing, 0u);
    }
    EXPECT_EQ(found, 1u);
}

}  // namespace
}  // namespace rushlight
