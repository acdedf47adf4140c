#pragma once
// How different two pictures are, in numbers and as a picture.

#include "engine/core/result.h"
#include "renderer/capture/compare/flip.h"
#include "renderer/capture/picture.h"

#include <string>
#include <vector>

namespace rushlight {

struct CompareOptions {
    float pixelsPerDegree = kDefaultPixelsPerDegree;  ///< of the viewer, for FLIP
};

/// Errors are of the values as stored (sRGB from 0 to 1, or linear), over RGB, and alpha where
/// either is not opaque.
struct Comparison {
    double psnr = 0;          ///< dB, for a peak of 1; infinite when the pictures are equal
    double maxError = 0;      ///< the largest difference of a value
    double meanError = 0;     ///< mean absolute difference
    double ssim = 1;          ///< structural similarity of luma: 1 when equal. Wang et al. 2004
    double flip = 0;          ///< mean FLIP error, 0 to 1; of linear pictures HDR-FLIP
    double alphaOverlap = 1;  ///< pixels of which both cover half or more, over those of which
                              ///< either does; 1: neither
    Plane flipErrors;         ///< of every pixel
    Plane errors;             ///< the largest difference of a value of every pixel
};

/// `objectA` and `objectB` name the pictures in messages. An Error when they differ in size or kind
/// (sRGB or linear). Linear pictures are cut to 0..1 for SSIM.
Result<Comparison> comparePictures(const Picture& a, const Picture& b, const std::string& objectA,
                                   const std::string& objectB, const CompareOptions& = {});

/// Errors from 0 to 1 as colours: black, violet, red, orange, yellow, white. RGBA, 8 bit.
std::vector<uint8_t> heatMap(const Plane& errors);
Result<void> saveHeatMap(const std::string& path, const Plane& errors);

}  // namespace rushlight
