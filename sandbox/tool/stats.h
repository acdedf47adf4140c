#pragma once
// The JSON of --stats and of bench --json; its schema is in the README. Keys are added, never
// renamed.

#include "renderer/frame/frame_report.h"
#include "sandbox/tool/render_setup.h"

#include <nlohmann/json_fwd.hpp>

namespace rushlight::tool {

/// What the tool itself measures of a frame.
struct FrameTimes {
    double wallMs = 0;
    uint64_t allocations = 0;
};

nlohmann::ordered_json statsJson(RenderSetup& setup, uvec2 size, double firstFrameMs,
                                 const FrameReport& report, const FrameTimes& times);

Result<void> writeJson(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace rushlight::tool
