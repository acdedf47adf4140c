#include "renderer/testing/frame.h"

#include <algorithm>

namespace rushlight::golden {
namespace {

template <class Value>
Result<std::vector<Value>> rowsFromTop(uint32_t width, uint32_t height,
                                       std::span<const Value> values, RowOrder order) {
    const size_t row = size_t(width) * 4;
    if (values.empty() || values.size() != row * height)
        return fail("host frame",
                    std::to_string(values.size()) + " values were given; a picture of " +
                        std::to_string(width) + "x" + std::to_string(height) + " pixels has " +
                        std::to_string(row * height) + ", and at least one pixel.",
                    ErrorKind::wrongUse);
    std::vector<Value> rows(values.begin(), values.end());
    if (order == RowOrder::topDown) return rows;
    for (uint32_t y = 0; y < height; ++y)
        std::ranges::copy(values.subspan(row * (height - 1 - y), row),
                          rows.begin() + long(row * y));
    return rows;
}

}  // namespace

Result<Frame> hostFrame(uint32_t width, uint32_t height, std::span<const uint8_t> rgba8,
                        RowOrder order) {
    auto rows = rowsFromTop(width, height, rgba8, order);
    if (!rows) return tl::unexpected(rows.error());
    return Frame{{width, height, std::move(*rows), {}}};
}

Result<Frame> hostFrame(uint32_t width, uint32_t height, std::span<const float> rgba32f,
                        RowOrder order) {
    auto rows = rowsFromTop(width, height, rgba32f, order);
    if (!rows) return tl::unexpected(rows.error());
    return Frame{{width, height, {}, std::move(*rows)}};
}

Result<Frame> renderFrame(Renderer& renderer, const FrameInput& input, uint32_t width,
                          uint32_t height, CaptureKind kind) {
    const auto ticket = renderer.renderOffscreen(input, width, height, kind);
    if (!ticket) return tl::unexpected(ticket.error());
    Frame frame;
    if (!renderer.takeCapture(*ticket, true, frame.image))
        return fail("capture", "It did not arrive although it was waited for.",
                    ErrorKind::noContext);
    frame.takeApart = [&renderer, input, width, height] {
        return takeBreakdown(renderer, input, {width, height, {}});
    };
    return frame;
}

Result<std::unique_ptr<Offscreen>> Offscreen::create(const OffscreenDesc& desc) {
    std::unique_ptr<Offscreen> offscreen(new Offscreen);
    auto context = createOffscreenContext(desc.context, {});
    if (!context) return tl::unexpected(context.error());
    offscreen->context_ = std::move(*context);
    RendererDesc renderer;
    renderer.loadGl = offscreen->context_->loader();
    renderer.shaderDirectory = desc.shaderDirectory;
    renderer.log = desc.log;
    renderer.validateCommands = true;
    auto made = Renderer::create(renderer);
    if (!made) return tl::unexpected(made.error());
    offscreen->renderer_ = std::move(*made);
    return offscreen;
}

Offscreen::~Offscreen() {
    if (context_) context_->makeCurrent();
    renderer_.reset();
}

Renderer& Offscreen::renderer() {
    context_->makeCurrent();
    return *renderer_;
}

Result<Frame> Offscreen::render(const FrameInput& input, uint32_t width, uint32_t height,
                                CaptureKind kind) {
    auto frame = renderFrame(renderer(), input, width, height, kind);
    if (frame)
        frame->takeApart = [this, takeApart = std::move(frame->takeApart)] {
            context_->makeCurrent();
            return takeApart();
        };
    return frame;
}

Result<Frame> Offscreen::renderScene(const std::string& scene, const SceneView& view,
                                     const std::string& environment, CaptureKind kind) {
    auto opened = SceneFrames::open(renderer(), scene, environment);
    if (!opened) return tl::unexpected(opened.error());
    const std::shared_ptr<SceneFrames> frames(opened->release(), [this](SceneFrames* gone) {
        context_->makeCurrent();
        delete gone;
    });
    FrameInput input;
    if (auto filled = frames->fill(view, input); !filled) return tl::unexpected(filled.error());
    auto frame = render(input, view.width, view.height, kind);
    // The scene lives as long as somebody may ask for its breakdown.
    if (frame)
        frame->takeApart = [frames, takeApart = std::move(frame->takeApart)] {
            return takeApart();
        };
    return frame;
}

}  // namespace rushlight::golden
