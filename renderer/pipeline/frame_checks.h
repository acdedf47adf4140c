#pragma once
// What a host may not hand over.

#include "renderer/frame/frame_input.h"
#include "renderer/pipeline/stores.h"

namespace rushlight {

/// An Error of ErrorKind::wrongUse that names the object and the limit.
Result<void> checkFrame(const FrameInput& input, const FrameTarget& target, const Stores& stores);

}  // namespace rushlight
