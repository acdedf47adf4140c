// The passes after lighting, drawn and read back.

#include "interop/tonemap.h"
#include "renderer/backend/gl/gl_device.h"
#include "renderer/geometry/half.h"
#include "renderer/passes/debug/debug_view_pass.h"
#include "renderer/passes/debug/overlay_pass.h"
#include "renderer/passes/post/bloom_pass.h"
#include "renderer/passes/post/exposure_pass.h"
#include "renderer/passes/post/fxaa_pass.h"
#include "renderer/passes/post/tonemap_pass.h"
#include "tests/support/gl/test_context.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 96, kHeight = 64;

class PostGlTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
        auto device = createGlDevice({.load = &TestContext::load, .debugOutput = true});
        ASSERT_TRUE(device) << device.error().text();
        device_ = std::move(*device);
        plan_ = std::make_unique<FramePlan>(*device_);
        settings_.dither = false;
        settings_.toneMap = ToneMap::none;
    }
    void TearDown() override {
        if (!device_) return;
        device_->finish();
        for (const std::string& message : device_->takeDebugMessages())
            ADD_FAILURE() << "GL debug message: " << message;
        plan_.reset();
    }

    template <class T>
    TextureHandle upload(Format format, uint32_t width, uint32_t height,
                         const std::vector<T>& data) {
        TextureDesc desc;
        desc.label = "source";
        desc.format = format;
        desc.width = width;
        desc.height = height;
        const auto texture = device_->createTexture(desc);
        EXPECT_TRUE(texture) << texture.error().text();
        TextureRegion region;
        region.width = width;
        region.height = height;
        device_->write(*texture, region, std::as_bytes(std::span(data)));
        return *texture;
    }
    TextureHandle radiance(const std::function<vec4(uint32_t, uint32_t)>& color) {
        std::vector<uint16_t> halves;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x)
                for (int c = 0; c < 4; ++c) halves.push_back(toHalf(color(x, y)[c]));
        return upload(Format::rgba16f, kWidth, kHeight, halves);
    }
    ImageId import(TextureHandle texture, Format format) {
        return plan_->importImage({"source", format, kWidth, kHeight}, texture);
    }
    FinalTarget target() {
        const ImageId image = plan_->createImage({"result", Format::rgba8, kWidth, kHeight});
        plan_->requestImage(image);
        return {image, kWidth, kHeight, false};
    }
    void begin() {
        plan_->begin();
        commands_.clear();
    }
    ReadbackImage run(ImageId image) {
        const auto compiled = plan_->compile();
        EXPECT_TRUE(compiled) << compiled.error().text();
        SerialJobs jobs;
        plan_->record(jobs, commands_);
        commands_.push(Readback{plan_->texture(image), 0, 0, ++ticket_});
        ExecutionReport report;
        device_->execute(commands_, {}, report);
        ReadbackImage result;
        EXPECT_TRUE(device_->takeReadback(ticket_, true, result));
        return result;
    }
    ReadbackImage toneMapped(TonemapPass& pass, TextureHandle source) {
        begin();
        TonemapPass::Inputs in;
        in.radiance = import(source, Format::rgba16f);
        in.settings = &settings_;
        in.target = target();
        in.data = &commands_;
        EXPECT_TRUE(pass.add(*plan_, in));
        return run(in.target.image);
    }
    static std::array<int, 4> texel(const ReadbackImage& image, uint32_t x, uint32_t y) {
        std::array<int, 4> t;
        for (size_t c = 0; c < 4; ++c) t[c] = int(image.bytes[(y * image.width + x) * 4 + c]);
        return t;
    }

    TestContext context_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<FramePlan> plan_;
    CommandBuffer commands_;
    FrameSettings settings_;
    uint32_t ticket_ = 0;
};

TEST_F(PostGlTest, ToneMapsAsTheSharedSourceSays) {
    const auto color = [](uint32_t x, uint32_t y) {
        return vec4(float(x) / 40, float(y) / 30, float((x + y) % 7) / 5, 1);
    };
    const TextureHandle source = radiance(color);
    TonemapPass pass(*device_);
    using Curve = vec3 (*)(vec3);
    const std::pair<ToneMap, Curve> curves[] = {{ToneMap::none, [](vec3 c) { return c; }},
                                                {ToneMap::neutral, interop::toneMapNeutral},
                                                {ToneMap::agx, interop::toneMapAgx},
                                                {ToneMap::aces, interop::toneMapAces}};
    for (const auto& [toneMap, curve] : curves) {
        settings_.toneMap = toneMap;
        settings_.exposureScale = 1.5f;
        const ReadbackImage image = toneMapped(pass, source);
        for (uint32_t y = 0; y < kHeight; y += 5)
            for (uint32_t x = 0; x < kWidth; x += 7) {
                const vec3 expected = interop::encodeSrgb(
                    interop::saturate3(curve(vec3(color(x, y)) * 1.5f)));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(texel(image, x, y)[size_t(c)], expected[c] * 255, 1.1f)
                        << int(toneMap) << " " << x << " " << y;
                EXPECT_EQ(texel(image, x, y)[3], 255);
            }
    }
}

// ISO 2720 with K = 12.5 and S = 100: white is 1.2 * 2^EV.
TEST_F(PostGlTest, AnExposureValueHalvesLightByTheStop) {
    const TextureHandle source = radiance(
        [](uint32_t, uint32_t) { return vec4(0.6f, 1.2f, 2.4f, 1); });
    TonemapPass pass(*device_);
    settings_.useExposureValue = true;
    for (const float stops : {-1.0f, 0.0f, 1.0f, 3.0f}) {
        settings_.exposureValue = stops;
        const auto shown = texel(toneMapped(pass, source), 5, 5);
        for (size_t c = 0; c < 3; ++c) {
            const float light = 0.5f * float(1 << c) / std::exp2(stops);
            const float expected = interop::encodeSrgb(vec3(std::min(light, 1.0f))).x * 255;
            EXPECT_NEAR(shown[c], expected, 1.1f) << stops;
        }
    }
}

TEST_F(PostGlTest, TransparentPicturesHaveStraightAlpha) {
    const TextureHandle source = radiance(
        [](uint32_t x, uint32_t) { return x < 48 ? vec4(0.25f, 0.1f, 0, 0.5f) : vec4(0); });
    TonemapPass pass(*device_);
    begin();
    TonemapPass::Inputs in;
    in.radiance = import(source, Format::rgba16f);
    in.settings = &settings_;
    in.transparent = true;
    in.target = target();
    in.data = &commands_;
    ASSERT_TRUE(pass.add(*plan_, in));
    const ReadbackImage image = run(in.target.image);
    EXPECT_NEAR(texel(image, 10, 10)[0], interop::encodeSrgb(0.5f) * 255, 1.1f);
    EXPECT_NEAR(texel(image, 10, 10)[3], 128, 1);
    EXPECT_EQ(texel(image, 80, 10), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST_F(PostGlTest, BloomSpreadsLightAndAddsNone) {
    const TextureHandle source = radiance(
        [](uint32_t, uint32_t) { return vec4(0.5f, 2, 0.25f, 1); });
    BloomPass pass(*device_);
    begin();
    auto bloom = pass.add(*plan_, {import(source, Format::rgba16f), &commands_, kWidth, kHeight});
    ASSERT_TRUE(bloom) << bloom.error().text();
    settings_.bloomStrength = 1;  // the bloom image alone
    settings_.exposureScale = 0.25f;
    TonemapPass tonemap(*device_);
    TonemapPass::Inputs in;
    in.radiance = import(source, Format::rgba16f);
    in.bloom = bloom->bloom;
    in.settings = &settings_;
    in.target = target();
    in.data = &commands_;
    ASSERT_TRUE(tonemap.add(*plan_, in));
    const ReadbackImage image = run(in.target.image);
    for (const auto& [x, y] : {std::pair(0u, 0u), std::pair(50u, 30u), std::pair(95u, 63u)}) {
        EXPECT_NEAR(texel(image, x, y)[0], interop::encodeSrgb(0.125f) * 255, 2.5f);
        EXPECT_NEAR(texel(image, x, y)[1], interop::encodeSrgb(0.5f) * 255, 2.5f);
    }
}

TEST_F(PostGlTest, ExposureBringsGreyToMiddleGreyAndAdapts) {
    const TextureHandle bright = radiance([](uint32_t, uint32_t) { return vec4(vec3(9), 1); });
    const TextureHandle dim = radiance([](uint32_t, uint32_t) { return vec4(vec3(0.09f), 1); });
    BloomPass bloomPass(*device_);
    ExposurePass exposurePass(*device_);
    ImageHistory images(*device_);
    ExposureHistory history;
    const auto frame = [&](TextureHandle source, float deltaTime) {
        begin();
        const auto bloom = bloomPass.add(
            *plan_, {import(source, Format::rgba16f), &commands_, kWidth, kHeight});
        EXPECT_TRUE(bloom);
        const auto exposure = exposurePass.add(
            *plan_, {bloom->smallest, bloom->smallestWidth, bloom->smallestHeight, &commands_,
                     deltaTime, &images, &history});
        EXPECT_TRUE(exposure) << exposure.error().text();
        const ReadbackImage image = run(exposure->exposure);
        float value = 0;
        std::memcpy(&value, image.bytes.data(), sizeof value);
        return value;
    };
    EXPECT_NEAR(frame(bright, 0.01f), 0.02f, 0.0005f);  // at once in the first frame
    const float next = frame(dim, 0.1f);                // aims at 2, in stops
    const float share = 1 - std::exp(-0.2f);
    EXPECT_NEAR(std::log2(next), std::log2(0.02f) + share * std::log2(100.0f), 0.05f);
    for (int i = 0; i < 6; ++i) frame(dim, 1);
    EXPECT_NEAR(frame(dim, 1), 2, 0.05f);
    const ExposureHistory before = history;
    const float once = frame(bright, 0.1f);
    history = before;  // that frame was not executed as far as the view knows
    EXPECT_EQ(frame(bright, 0.1f), once);
}

TEST_F(PostGlTest, FxaaSmoothsStairsAndLeavesFlatsAlone) {
    std::vector<uint8_t> pixels;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const bool white = 4 * y > x + 40;  // an edge with steps of four pixels
            for (int c = 0; c < 3; ++c) pixels.push_back(white ? 230 : 20);
            pixels.push_back(200);
        }
    const TextureHandle source = upload(Format::rgba8, kWidth, kHeight, pixels);
    FxaaPass pass(*device_);
    begin();
    FxaaPass::Inputs in;
    in.display = import(source, Format::rgba8);
    in.target = target();
    in.data = &commands_;
    ASSERT_TRUE(pass.add(*plan_, in));
    const ReadbackImage image = run(in.target.image);
    uint32_t between = 0, edges = 0;
    for (uint32_t x = 8; x < 88; ++x)
        for (uint32_t y = 1; y + 1 < kHeight; ++y) {
            const int got = texel(image, x, y)[0];
            const auto was = [&](uint32_t row) { return pixels[(row * kWidth + x) * 4]; };
            const bool nearEdge = was(y - 1) != was(y) || was(y) != was(y + 1);
            edges += nearEdge;
            between += got > 25 && got < 225;
            if (was(y > 3 ? y - 3 : 0) == was(std::min(y + 3, kHeight - 1))) {
                EXPECT_EQ(got, was(y)) << x << " " << y;
            }
            EXPECT_EQ(texel(image, x, y)[3], 200);
        }
    EXPECT_GT(between, edges / 3);
    EXPECT_LE(between, edges);
}

TEST_F(PostGlTest, APictureMayHaveItsTopRowFirst) {
    const auto color = [](uint32_t, uint32_t y) {
        return vec4(y < 16 ? 1 : 0, y < 16 ? 0 : 1, 0, 1);
    };
    const TextureHandle source = radiance(color);
    TonemapPass pass(*device_);
    for (const bool topRowFirst : {false, true}) {
        begin();
        FinalTarget final = target();
        final.topRowFirst = topRowFirst;
        TonemapPass::Inputs inputs;
        inputs.radiance = import(source, Format::rgba16f);
        inputs.settings = &settings_;
        inputs.target = final;
        inputs.data = &commands_;
        ASSERT_TRUE(pass.add(*plan_, inputs));
        const ReadbackImage image = run(final.image);
        // The low rows are red.
        EXPECT_EQ(texel(image, 5, topRowFirst ? kHeight - 3 : 2)[0], 255) << topRowFirst;
        EXPECT_EQ(texel(image, 5, topRowFirst ? 2 : kHeight - 3)[1], 255) << topRowFirst;
    }
}

// Pixels count from the top left, whichever row the target has first.
TEST_F(PostGlTest, OverlayStandsUpright) {
    TextureDesc desc;
    desc.label = "coverage";
    desc.kind = TextureKind::texture2dArray;
    const auto array = device_->createTexture(desc);
    ASSERT_TRUE(array);
    const uint32_t white[] = {0xffffffff};
    device_->write(*array, {0, 0, 1, 1, 1}, std::as_bytes(std::span(white)));
    ImageLocation location{};
    location.array = *array;
    const OverlayVertex vertices[] = {
        {{0, 0}, {0, 0}, ~0u}, {{40, 0}, {0, 0}, ~0u}, {{0, 20}, {0, 0}, ~0u}};
    const uint32_t indices[] = {0, 1, 2};
    const OverlayBatch batches[] = {{0, 3, {0, 0}, {kWidth, kHeight}}};
    Overlay overlay;
    overlay.vertices = vertices;
    overlay.indices = indices;
    overlay.batches = batches;
    for (const bool topRowFirst : {false, true}) {
        const std::vector<uint8_t> black(kWidth * kHeight * 4, 0);
        const TextureHandle display = upload(Format::rgba8, kWidth, kHeight, black);
        OverlayPass pass(*device_);
        begin();
        FinalTarget final{import(display, Format::rgba8), kWidth, kHeight, topRowFirst};
        ASSERT_TRUE(pass.add(*plan_, {&overlay, &location, final, &commands_}));
        const ReadbackImage image = run(final.image);
        const auto shown = [&](uint32_t x, uint32_t fromTop) {
            return texel(image, x, topRowFirst ? fromTop : kHeight - 1 - fromTop)[0];
        };
        EXPECT_EQ(shown(2, 2), 255) << topRowFirst;
        EXPECT_EQ(shown(30, 2), 255) << topRowFirst;
        EXPECT_EQ(shown(2, 15), 255) << topRowFirst;
        EXPECT_EQ(shown(30, 15), 0) << topRowFirst;
        EXPECT_EQ(shown(2, kHeight - 3), 0) << topRowFirst;
    }
}

TEST_F(PostGlTest, OverlayDrawsWithinItsScissor) {
    TextureDesc desc;
    desc.label = "coverage";
    desc.kind = TextureKind::texture2dArray;
    desc.layers = 2;
    const auto array = device_->createTexture(desc);
    ASSERT_TRUE(array);
    const uint32_t texels[] = {0, 0xffffffff};
    TextureRegion region;
    region.layerCount = 2;
    region.width = region.height = 1;
    device_->write(*array, region, std::as_bytes(std::span(texels)));
    ImageLocation location{};
    location.array = *array;
    location.layer = 1;

    const OverlayVertex vertices[] = {{{0, 0}, {0, 0}, 0xff0000ff},
                                      {{0, 200}, {0, 0}, 0xff0000ff},
                                      {{200, 0}, {0, 0}, 0xff0000ff}};
    const uint32_t indices[] = {0, 1, 2};
    const OverlayBatch batches[] = {{0, 3, {10, 5}, {20, 15}}};
    Overlay overlay;
    overlay.vertices = vertices;
    overlay.indices = indices;
    overlay.batches = batches;

    const std::vector<uint8_t> black(kWidth * kHeight * 4, 0);
    const TextureHandle display = upload(Format::rgba8, kWidth, kHeight, black);
    OverlayPass pass(*device_);
    begin();
    FinalTarget final{import(display, Format::rgba8), kWidth, kHeight, false};
    ASSERT_TRUE(pass.add(*plan_, {&overlay, &location, final, &commands_}));
    const ReadbackImage image = run(final.image);
    const std::array<int, 4> red{255, 0, 0, 255}, none{0, 0, 0, 0};
    EXPECT_EQ(texel(image, 10, kHeight - 1 - 5), red);  // rows from the bottom
    EXPECT_EQ(texel(image, 19, kHeight - 1 - 14), red);
    EXPECT_EQ(texel(image, 20, kHeight - 1 - 10), none);
    EXPECT_EQ(texel(image, 15, kHeight - 1 - 4), none);

    const OverlayBatch beyond[] = {{1, 3, {0, 0}, {20, 15}}};
    overlay.batches = beyond;
    begin();
    EXPECT_FALSE(pass.add(*plan_, {&overlay, &location, final, &commands_}));
}

TEST_F(PostGlTest, EveryDebugViewCompilesAndShowsTheGBuffer) {
    DebugViewPass pass(*device_);
    const std::vector<uint8_t> orange = [] {
        std::vector<uint8_t> p;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) p.insert(p.end(), {255, 128, 0, 64});
        return p;
    }();
    const std::vector<float> depths(kWidth * kHeight, 0.01f);
    const TextureHandle color = upload(Format::rgba8, kWidth, kHeight, orange);
    const TextureHandle depth = upload(Format::r32f, kWidth, kHeight, depths);
    for (uint32_t i = 0; i < uint32_t(DebugView::count); ++i) {
        const DebugView show = DebugView(i);
        if (!DebugViewPass::shows(show)) continue;
        SCOPED_TRACE(toText(show));
        begin();
        DebugViewPass::Inputs in;
        in.view = show;
        in.gbuffer.target0 = import(color, Format::rgba8);
        in.gbuffer.target1 = import(color, Format::rgba8);
        in.gbuffer.target2 = import(color, Format::rgba8);
        in.gbuffer.depth = import(depth, Format::r32f);
        in.depthDecode = {10, 0};  // view depth 0.1 / 0.01 = 10 m
        in.target = target();
        in.data = &commands_;
        if (show == DebugView::ambientOcclusion) {  // halfway open; the depth's bits are 0.01's
            const float half = std::bit_cast<float>((std::bit_cast<uint32_t>(0.01f) & ~1023u) |
                                                    512u);
            const std::vector<vec4> texels(kWidth / 2 * kHeight / 2, vec4(0, 0, 0, half));
            in.ambientOcclusion = plan_->importImage(
                {"occlusion", Format::rgba32f, kWidth / 2, kHeight / 2},
                upload(Format::rgba32f, kWidth / 2, kHeight / 2, texels));
        }
        if (show == DebugView::clusters) {
            const uint32_t counts[] = {32};
            in.clusters = commands_.append(std::span<const uint32_t>(counts));
            in.clusterCounts = {1, 1, 1, 0};
            in.clusterMapping = {0, 0, 0, 0};
        }
        const auto added = pass.add(*plan_, in);
        ASSERT_TRUE(added) << added.error().text();
        const ReadbackImage image = run(in.target.image);
        const auto t = texel(image, 40, 20);
        EXPECT_EQ(t[3], 255);
        float expected = float(t[0]);
        switch (show) {
            case DebugView::metallic: expected = 64; break;
            case DebugView::depth:
                expected = 255.0f / 3;
                break;                                    // 10 m leave a third of 0.1 to 100
            case DebugView::shadow: expected = 0; break;  // there is none
            case DebugView::ambientOcclusion: expected = 255.0f * 512 / 1023; break;
            case DebugView::clusters: expected = 255; break;  // 32 lights are white
            default: break;
        }
        EXPECT_NEAR(t[0], expected, 1.1f);
        if (show == DebugView::baseColor) {
            EXPECT_NEAR(t[1], interop::encodeSrgb(128.0f * 128 / (255 * 255)) * 255, 1.1f);
        }
    }
}

}  // namespace
}  // namespace rushlight
