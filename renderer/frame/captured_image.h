#pragma once
// Pictures of frames that were rendered offscreen.

#include <cstdint>
#include <vector>

namespace rushlight {

/// Pixels that came back. Rows from the top of the picture.
struct CapturedImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba8;  ///< sRGB, straight alpha; or
    std::vector<float> rgba32f;  ///< linear radiance times exposure, premultiplied alpha
};

enum class CaptureKind : uint8_t {
    display,  ///< what is presented: tone mapped, 8 bit sRGB
    /// Linear, before exposure and tone mapping. FrameSettings::debugView may ask for two other
    /// images, as they are: `bloom`, of half the size, and `depth`, the device's reversed z in red.
    hdr,
};

/// Names a capture that was asked for.
struct CaptureTicket {
    uint32_t value = 0;
    explicit operator bool() const { return value != 0; }
};

}  // namespace rushlight
