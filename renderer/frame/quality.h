#pragma once
// How much a frame may cost, in one word: what the tool's and the game's --quality choose.

#include "renderer/frame/frame_settings.h"

namespace rushlight {

enum class Quality : uint8_t { low, medium, high, ultra };

/// All settings but those of exposure, tone map and what is shown, which are FrameSettings' own.
FrameSettings frameSettings(Quality);

}  // namespace rushlight
