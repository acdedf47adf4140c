#pragma once
// Dear ImGui without a graphics back end: what it draws becomes the Overlay of the frame, so that
// GL is called by the renderer alone.

#include "engine/core/result.h"
#include "engine/input/input.h"
#include "renderer/frame/frame_input.h"

#include <memory>
#include <string_view>
#include <vector>

struct ImGuiContext;
struct ImDrawData;
struct ImDrawList;
struct ImFont;

namespace rushlight {

class Renderer;

/// One user interface. Its ImGui context is current from begin() to end() only.
class OverlayUi {
public:
    /// Makes the font atlas an image of `renderer`, which must outlive this.
    static Result<std::unique_ptr<OverlayUi>> create(Renderer& renderer);
    ~OverlayUi();
    OverlayUi(const OverlayUi&) = delete;
    OverlayUi& operator=(const OverlayUi&) = delete;

    /// `pixelsPerUnit` scales the input's mouse position. With `mouse` false the interface ignores
    /// the mouse.
    void begin(const InputState& input, vec2 pixelsPerUnit, bool mouse, uvec2 size, float seconds);
    /// The spans are valid until the next end().
    Overlay end();

    /// The mouse is over a window or drags something of it: the game should ignore its buttons and
    /// wheel.
    bool wantsMouse() const { return wantsMouse_; }

    enum class Anchor : uint8_t { topLeft, topCenter, center, bottomCenter };
    /// A line of text over the picture, between begin() and end(). `offset` in pixels from the
    /// anchor.
    void text(Anchor anchor, vec2 offset, std::string_view line, vec4 color, bool large = false);

private:
    explicit OverlayUi(Renderer& renderer);
    Result<void> uploadFonts();
    void append(const ImDrawData& data);
    void appendBatches(const ImDrawList& list, uint32_t firstVertex, uint32_t firstIndex,
                       uvec2 size);

    Renderer& renderer_;
    ImGuiContext* context_ = nullptr;
    ImGuiContext* outer_ = nullptr;  ///< current before begin()
    ImFont* large_ = nullptr;
    ImageHandle fontImage_;
    std::vector<OverlayVertex> vertices_;
    std::vector<uint32_t> indices_;
    std::vector<OverlayBatch> batches_;
    bool wantsMouse_ = false;
};

}  // namespace rushlight
