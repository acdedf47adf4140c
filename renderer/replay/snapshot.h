#pragma once

#include "renderer/rhi/device.h"
#include "renderer/rhi/saved/saved_frame.h"

namespace rushlight {

/// The frame that `commands` draw, with what their resources hold now: to be called before they are
/// executed. Slow: it reads everything back.
SavedFrame takeSnapshot(Device& device, const CommandBuffer& commands, const FrameTarget& target);

}  // namespace rushlight
