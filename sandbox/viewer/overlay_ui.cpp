#include "sandbox/viewer/overlay_ui.h"

#include "renderer/renderer.h"

#include <imgui.h>

#include <algorithm>
#include <limits>

namespace rushlight {
namespace {

constexpr float kSmallFont = 13;  // pixels: the built-in font is a bitmap and sharp at multiples of
                                  // 13
constexpr float kLargeFont = 26;

void style() {
    ImGui::StyleColorsDark();
    ImGuiStyle& look = ImGui::GetStyle();
    look.WindowRounding = 4;
    look.FrameRounding = 2;
    look.Colors[ImGuiCol_WindowBg].w = 0.82f;
}

}  // namespace

Result<std::unique_ptr<OverlayUi>> OverlayUi::create(Renderer& renderer) {
    std::unique_ptr<OverlayUi> ui(new OverlayUi(renderer));
    if (auto fonts = ui->uploadFonts(); !fonts) return tl::unexpected(fonts.error());
    return ui;
}

OverlayUi::OverlayUi(Renderer& renderer) : renderer_(renderer) {
    outer_ = ImGui::GetCurrentContext();
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // leaves no file behind in the working directory
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    style();
    ImGui::SetCurrentContext(outer_);
}

OverlayUi::~OverlayUi() {
    if (fontImage_) renderer_.destroy(fontImage_);
    ImGui::DestroyContext(context_);
}

Result<void> OverlayUi::uploadFonts() {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    ImFontConfig config;
    config.SizePixels = kSmallFont;
    io.Fonts->AddFontDefault(&config);
    config.SizePixels = kLargeFont;
    large_ = io.Fonts->AddFontDefault(&config);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImageDesc desc;
    desc.label = "overlay font";
    desc.width = uint32_t(width);
    desc.height = uint32_t(height);
    desc.pixels = {pixels, size_t(width) * size_t(height) * 4};
    const auto image = renderer_.createImage(desc);
    ImGui::SetCurrentContext(outer_);
    if (!image) return tl::unexpected(image.error());
    fontImage_ = *image;
    return {};
}

void OverlayUi::begin(const InputState& input, vec2 pixelsPerUnit, bool mouse, uvec2 size,
                      float seconds) {
    outer_ = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(float(size.x), float(size.y));
    io.DeltaTime = std::max(seconds, 1e-4f);
    const vec2 at = input.mousePosition() * pixelsPerUnit;
    constexpr float kNowhere = std::numeric_limits<float>::lowest();
    io.MousePos = mouse ? ImVec2(at.x, at.y) : ImVec2(kNowhere, kNowhere);
    for (int button = 0; button < int(MouseButton::count); ++button) {
        const auto which = MouseButton(button);
        io.MouseDown[button] = mouse && (input.isDown(which) || input.wasPressed(which));
    }
    io.MouseWheel = mouse ? input.scroll() : 0;
    ImGui::NewFrame();
    wantsMouse_ = io.WantCaptureMouse;
}

void OverlayUi::text(Anchor anchor, vec2 offset, std::string_view line, vec4 color, bool large) {
    const char* begin = line.data();
    const char* end = begin + line.size();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const auto extentIn = [&](const ImFont* font) {
        return font->CalcTextSizeA(font->FontSize, std::numeric_limits<float>::max(), 0, begin,
                                   end);
    };
    const bool fits = extentIn(large_).x <= size.x;
    ImFont* font = large && fits ? large_ : ImGui::GetFont();
    const ImVec2 extent = extentIn(font);
    vec2 at = offset;
    if (anchor != Anchor::topLeft) at.x += 0.5f * (size.x - extent.x);
    if (anchor == Anchor::center) at.y += 0.5f * (size.y - extent.y);
    if (anchor == Anchor::bottomCenter) at.y += size.y - extent.y;
    at = glm::floor(at);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImU32 shade = ImGui::ColorConvertFloat4ToU32(ImVec4(0, 0, 0, 0.7f * color.a));
    const ImU32 ink = ImGui::ColorConvertFloat4ToU32(ImVec4(color.r, color.g, color.b, color.a));
    list->AddText(font, font->FontSize, ImVec2(at.x + 1, at.y + 1), shade, begin, end);
    list->AddText(font, font->FontSize, ImVec2(at.x, at.y), ink, begin, end);
}

Overlay OverlayUi::end() {
    ImGui::Render();
    vertices_.clear();
    indices_.clear();
    batches_.clear();
    append(*ImGui::GetDrawData());
    ImGui::SetCurrentContext(outer_);
    return {vertices_, indices_, batches_, fontImage_};
}

void OverlayUi::append(const ImDrawData& data) {
    const uvec2 size(uint32_t(data.DisplaySize.x), uint32_t(data.DisplaySize.y));
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        const auto firstVertex = uint32_t(vertices_.size());
        const auto firstIndex = uint32_t(indices_.size());
        for (const ImDrawVert& v : list.VtxBuffer)
            vertices_.push_back({vec2(v.pos.x, v.pos.y), vec2(v.uv.x, v.uv.y), v.col});
        indices_.insert(indices_.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
        appendBatches(list, firstVertex, firstIndex, size);
    }
}

/// An ImDrawCmd's indices count from its own vertex offset; the overlay's from the first vertex of
/// all.
void OverlayUi::appendBatches(const ImDrawList& list, uint32_t firstVertex, uint32_t firstIndex,
                              uvec2 size) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        OverlayBatch batch;
        batch.firstIndex = firstIndex + command.IdxOffset;
        batch.indexCount = command.ElemCount;
        for (uint32_t i = 0; i < batch.indexCount; ++i)
            indices_[batch.firstIndex + i] += firstVertex + command.VtxOffset;
        const ImVec4& clip = command.ClipRect;
        batch.clipLow = glm::max(ivec2(int(clip.x), int(clip.y)), ivec2(0));
        batch.clipHigh = glm::min(ivec2(int(clip.z), int(clip.w)), ivec2(size));
        const bool visible = batch.indexCount > 0 && batch.clipLow.x < batch.clipHigh.x &&
                             batch.clipLow.y < batch.clipHigh.y;
        if (visible) batches_.push_back(batch);
    }
}

}  // namespace rushlight
