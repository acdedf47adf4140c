#pragma once
// What the TAB key shows. Called between OverlayUi::begin and end.

#include "engine/time/frame_clock.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/frame_report.h"
#include "sandbox/viewer/camera_rig.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rushlight {

struct StatisticsView {
    const FrameReport& report;
    const FrameRateMeter& meter;
    std::string_view device;
    uvec2 size{0};
    uint64_t allocations = 0;  ///< in the last frame
    bool allocationsKnown = false;
};

/// What the panels change.
struct ViewerSettings {
    FrameSettings frame;
    bool hasEnvironment = false;
    bool useEnvironment = true;
    bool hasReflectionProbes = false;
    bool useReflectionProbes = true;
    float ambientScale = 1;
    float fogScale = 1;
};

void drawStatistics(const StatisticsView& view);
void drawPassViews(FrameSettings& settings);
void drawSettings(ViewerSettings& settings, CameraRig& camera);
void drawHelp();
/// A red box with what went wrong, until it is mended. Nothing for an empty message.
void drawProblem(const char* title, const std::string& message, uvec2 size);

}  // namespace rushlight
