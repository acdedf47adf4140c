#pragma once
// Pictures to be judged: of hosts, which bring pixels, and of an offscreen renderer of one's own.

#include "renderer/capture/breakdown/breakdown.h"
#include "renderer/context/context.h"
#include "renderer/renderer.h"
#include "renderer/testing/scene_frames.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace rushlight::golden {

struct Frame {
    CapturedImage image;
    /// Takes the frame apart where it is judged too far from its golden; empty for pixels of a
    /// host.
    std::function<Result<Breakdown>()> takeApart = {};
};

enum class RowOrder : uint8_t { topDown, bottomUp };  ///< glReadPixels gives bottomUp

/// Pixels that a host has read back, copied: RGBA, sRGB with straight alpha. ErrorKind::wrongUse
/// where they are not as many as the size says.
Result<Frame> hostFrame(uint32_t width, uint32_t height, std::span<const uint8_t> rgba8,
                        RowOrder order);
/// The same, linear with premultiplied alpha.
Result<Frame> hostFrame(uint32_t width, uint32_t height, std::span<const float> rgba32f,
                        RowOrder order);

struct OffscreenDesc {
    ContextChoice context = ContextChoice::automatic;
    std::string shaderDirectory = {};  ///< as in RendererDesc
    LogSink log = {};
};

/// A context and a renderer of its own, with no window, which says so where commands are not valid.
/// Everything is done on the calling thread. There may be several: each makes its context current
/// where it needs it.
class Offscreen {
public:
    /// ErrorKind::noContext, with the reasons, where no context can be had: tests skip then.
    static Result<std::unique_ptr<Offscreen>> create(const OffscreenDesc& desc = {});
    ~Offscreen();

    /// With its context current.
    Renderer& renderer();

    /// What `input` points to must live until the frame is judged. No frame may outlive this.
    Result<Frame> render(const FrameInput& input, uint32_t width, uint32_t height,
                         CaptureKind kind = CaptureKind::display);

    /// A .gltf or .glb file, with an .hdr or .exr file as environment or none.
    Result<Frame> renderScene(const std::string& scene, const SceneView& view,
                              const std::string& environment = {},
                              CaptureKind kind = CaptureKind::display);

private:
    Offscreen() = default;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Renderer> renderer_;
};

/// Renders with a renderer that the host has, in the host's context; it, and what `input` points
/// to, must live until the frame is judged.
Result<Frame> renderFrame(Renderer& renderer, const FrameInput& input, uint32_t width,
                          uint32_t height, CaptureKind kind = CaptureKind::display);

}  // namespace rushlight::golden
