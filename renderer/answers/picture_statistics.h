#pragma once
// What a frame's pictures look like, in numbers.

#include "renderer/renderer.h"

namespace rushlight {

/// The displayed picture and what is drawn of it. Codes are 0 to 255; a pixel's is that of its
/// brightest channel.
struct FrameLook {
    float drawn = 0;         ///< share of the pixels that show anything but the background
    float notFinite = 0;     ///< share of pixels whose linear radiance is NaN or infinite
    int brightest = 0;       ///< code that one pixel in a hundred exceeds
    int brightestDrawn = 0;  ///< of the drawn pixels
    int common = 0;          ///< code that one drawn pixel in four exceeds
    int darkest = 0;      ///< code of the darkest channel that 99 of a hundred drawn pixels exceed
    int range = 0;        ///< largest spread of a channel between its 1st and 99th hundredth
    float luminance = 0;  ///< linear, that one drawn pixel in a hundred exceeds
    float typical = 0;    ///< geometric mean of the linear luminance of drawn pixels that have any
    float alpha = 1;      ///< mean of the displayed picture
    float veiled = 0;     ///< share of the surfaces' pixels of which fog leaves less than a code
    bool expectsDrawn = true;  ///< there is something to be drawn

    bool isEmpty() const { return expectsDrawn && drawn < 0.0005f; }
    bool isBlack() const;
    bool isWhite() const;  ///< drawn pixels are
    bool isFlat() const { return range <= 3; }
    bool isVeiled() const { return veiled > 0.98f; }
    /// Only highlights or a few things are seen. Nights look so too.
    bool isMostlyBlack() const;
    bool isFine() const {
        return !isEmpty() && !isBlack() && !isWhite() && !isFlat() && !isVeiled() &&
               notFinite < 0.001f;
    }
    const char* name() const;  ///< "black", "white", "empty", ..., "fine"
};

/// G-buffer of the drawn pixels.
struct SurfaceLook {
    float baseColor = 0;  ///< linear, that one pixel in a hundred exceeds
    float metallic = 0;   ///< mean
};

struct LookPictures {
    const CapturedImage* display = nullptr;  ///< 8 bit
    const CapturedImage* linear = nullptr;
    const CapturedImage* background = nullptr;  ///< linear, with nothing in the scene
    const CapturedImage* depth = nullptr;
};
FrameLook lookOf(const LookPictures& pictures, bool expectsDrawn);
/// Share of the surfaces' pixels of which fog leaves less than a 255th.
float veiledBy(const Fog& fog, const View& view, const CapturedImage& depth);
SurfaceLook surfaceOf(const CapturedImage& baseColor, const CapturedImage& metallic,
                      const CapturedImage& depth);

}  // namespace rushlight
