#pragma once
// A FrameReport in the schema of `--stats` (sandbox/tool/README.md).

#include "renderer/frame/frame_report.h"

#include <nlohmann/json_fwd.hpp>

namespace rushlight {

/// Its counters and times, without those that only a host can measure.
nlohmann::ordered_json frameJson(const FrameReport& report);
nlohmann::ordered_json passesJson(const FrameReport& report);

}  // namespace rushlight
