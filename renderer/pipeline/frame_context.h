#pragma once
// What every stage of a frame gets.

#include "renderer/frame/captured_image.h"
#include "renderer/frame/frame_input.h"
#include "renderer/pipeline/stores.h"
#include "renderer/pipeline/view_state.h"
#include "renderer/plan/frame_plan.h"
#include "renderer/visibility/draw_list.h"

#include <vector>

namespace rushlight {

/// A frame that is read back in place of being drawn into the host's framebuffer.
struct CaptureRequest {
    CaptureKind kind = CaptureKind::display;
    uint32_t ticket = 0;
};

struct FrameContext {
    const FrameInput& input;
    const FrameTarget& target;
    const CaptureRequest* capture;  ///< null: into the host's framebuffer
    const CameraMatrices& camera;
    Stores& stores;
    JobSystem& jobs;
    FramePlan& plan;
    CommandBuffer& uploads;  ///< its data block gets uniforms and instances
    ViewState& view;
    FrameWorlds worlds;
    std::vector<DrawList*>& drawn;  ///< lists whose instances the frame needs: a stage adds its own

    uint32_t width() const { return target.width; }
    uint32_t height() const { return target.height; }
    const FrameSettings& settings() const { return input.settings; }
    DrawBinder binder() const { return {&stores.geometry, &stores.materials}; }
    template <class T>
    BufferRange upload(const T& value) {
        return uploads.append(std::span<const T>(&value, 1));
    }
};

}  // namespace rushlight
