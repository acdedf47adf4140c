#pragma once
// Debug views as rows of one table: the image of the plan that is wanted, and how it is presented.

#include "renderer/frame/frame_settings.h"

namespace rushlight {

enum class Presentation : uint8_t {
    frame,          ///< the frame, as it is
    frameAndBoxes,  ///< and the boxes of what is visible over it
    aliased,        ///< the frame before anti-aliasing
    radiance,       ///< exposed and tone mapped in place of the frame's radiance
    part,           ///< likewise, without bloom
    factor,         ///< neither exposed nor tone mapped
    scattered,      ///< exposed as the frame is: it is made of the frame's radiance
    channel,        ///< in false colours
};

struct DebugViewRow {
    Presentation presentation = Presentation::frame;
    const char* image = nullptr;  ///< published in the plan; null: none is asked for
    bool linear = false;          ///< what a linear capture reads back in the radiance's place
};

const DebugViewRow& debugViewRow(DebugView view);

/// The settings that a presentation is displayed with.
FrameSettings presentedSettings(const FrameSettings& settings, Presentation presentation);

}  // namespace rushlight
