#pragma once
// What a view remembers from frame to frame, and nothing else does.

#include "renderer/passes/post/exposure_pass.h"
#include "renderer/passes/shadow/shadow_atlas_pass.h"
#include "renderer/passes/shadow/shadow_pass.h"
#include "renderer/plan/image_history.h"
#include "renderer/shadows/shadow_lights.h"
#include "renderer/visibility/lod_memory.h"
#include "renderer/visibility/view_motion.h"

namespace rushlight {

/// A value: a frame works on a copy, which takes the place of the original when it was executed.
struct ViewHistory {
    uint64_t frames = 0;    ///< that were executed
    mat4 clipFromWorld{1};  ///< of the last of them
    ExposureHistory exposure;
    SunShadowHistory sunShadows, sunGlass;
    ShadowAtlasHistory shadowAtlas;
    AtlasGenerations atlasImages;
};

/// One view's memory. A frame begins with beginFrame() and ends with commit(), or with nothing when
/// it fails: then the next one begins from what was before. Of the images a failed frame may have
/// written some: forgetImages().
class ViewState {
public:
    explicit ViewState(Device& device) : images(device) {}

    /// `kept` may be null; what moved in it since this view's last frame is collected.
    void beginFrame(WorldHandle handle, const InstanceWorld* kept) {
        next = last_;
        motion.begin(handle, kept);
        lods.begin(handle);
        lastWorld_ = handle;
    }
    void commit() {
        std::swap(last_, next);
        ++last_.frames;
        motion.commit();
        lods.commit();
    }
    void forgetImages() { images.forget(); }

    const ViewHistory& last() const { return last_; }
    WorldHandle lastWorld() const { return lastWorld_; }  ///< of the last frame that was begun

    ViewHistory next;  ///< of the frame that is being built
    ImageHistory images;
    ViewMotion motion;
    LodMemory lods;
    InstanceWorld instances;  ///< of FrameInput::instances; equal ones cost a comparison

private:
    ViewHistory last_;
    WorldHandle lastWorld_;
};

}  // namespace rushlight
