#pragma once

#include "renderer/rhi/resources.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rushlight {

/// An image that a pass wrote.
struct PassImage {
    const char* name = "";
    Format format = Format::none;
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t layer = 0;
    /// With FrameOptions::keepImages: what it held after the pass, tightly packed rows from v = 0
    /// (the picture's bottom).
    std::vector<std::byte> texels;
};

/// What one pass did. `reads` and `writes` name images of the frame plan. Times in milliseconds.
struct PassReport {
    const char* name = "";
    uint32_t draws = 0;
    uint64_t triangles = 0;
    uint32_t glCalls = 0;
    uint32_t stateChanges = 0;
    double cpuBeginMs = 0;  ///< since executing FrameReport::executedFrame began
    double cpuMs = 0;
    double gpuBeginMs = 0;  ///< since executing FrameReport::gpuFrame began
    double gpuMs = 0;
    std::vector<const char*> reads;
    std::vector<const char*> writes;
    std::vector<PassImage> images;  ///< as `writes`
    uint32_t bytesPerPixel = 0;     ///< of everything it writes
    std::vector<uint64_t> hashes;   ///< as `writes`, when asked for
};

/// The numbers behind `--stats`; the schema is in sandbox/tool/README.md. In the render-thread mode
/// (RendererDesc::renderThread) the frame `frameNumber` may not be executed yet; then what
/// executing gives (cpuExecuteMs, gpuMs, draws, triangles, glCalls, stateChanges, uploadedBytes,
/// the waits, synchronousCalls, passes) is of the newest frame that is.
struct FrameReport {
    static constexpr uint64_t kNone = ~uint64_t(0);  ///< the number of no frame

    uint64_t frameNumber = 0;
    uint64_t executedFrame = kNone;  ///< `frameNumber`, or the newest that is executed
    double cpuBuildMs = 0;
    double cpuExecuteBeginMs = 0;  ///< since render() of `executedFrame` was called
    double cpuExecuteMs = 0;
    double gpuMs = 0;           ///< of all passes
    uint64_t gpuFrame = kNone;  ///< that the GPU's times are of: the newest that the GPU was done
                                ///< with when `executedFrame` was executed
    uint32_t instances = 0;
    uint32_t visible = 0;  ///< from the camera
    uint32_t culledFrustum = 0;
    uint32_t culledOcclusion = 0;
    uint32_t culledSmall = 0;  ///< smaller than FrameSettings::smallObjectPixels
    uint32_t rejected = 0;     ///< instances with a stale handle or a transform that is not finite
    uint32_t draws = 0;
    uint64_t triangles = 0;
    uint32_t glCalls = 0;
    uint32_t stateChanges = 0;
    uint64_t uploadedBytes = 0;
    uint32_t lights = 0;
    uint32_t lightsVisible = 0;
    uint32_t shadowViewsDrawn = 0;
    uint32_t shadowViewsCached = 0;
    uint32_t shadowLights = 0;         ///< point and spot lights in view that have a shadow map
    uint32_t shadowLightsReduced = 0;  ///< of those, coarser than their size on screen asks for:
                                       ///< the atlas is full
    uint32_t shadowLightsWithout = 0;  ///< that should have one and found no room
    uint32_t pipelinesCompiled = 0;    ///< for `frameNumber`, and for what was created before it
    uint32_t waits = 0;                ///< of the CPU for the GPU
    uint32_t queueWaits = 0;  ///< of render() for the serving thread, all frames in flight being
                              ///< taken
    uint32_t synchronousCalls = 0;  ///< of the frame and what was created before it to the serving
                                    ///< thread; warm: none
    std::vector<PassReport> passes;
};

}  // namespace rushlight
