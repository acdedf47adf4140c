#pragma once
// What frames of known scenes may cost, in exact counters: as many as the file says, no more and no
// fewer.

#include "renderer/renderer.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace rushlight {

struct BudgetScene {
    const char* name;
    /// Renders a few frames, the same each time; what the last one counted.
    std::function<Result<FrameReport>(GlLoadFunction, void (*change)(FrameInput&))> render;
};
/// `change` may be null; it may touch the input of each frame before it is rendered.
const std::vector<BudgetScene>& budgetScenes();

/// The counters of a frame and of each of its passes.
nlohmann::ordered_json countersOf(const FrameReport& report, uint64_t allocations);

/// Renders a scene and counts its last frame, with its heap allocations.
Result<nlohmann::ordered_json> measureBudget(const BudgetScene& scene, GlLoadFunction load,
                                             void (*change)(FrameInput&) = nullptr);

/// A line for each counter that differs; none when the budget is kept.
std::vector<std::string> differences(const nlohmann::ordered_json& budget,
                                     const nlohmann::ordered_json& measured);

std::string budgetPath();

}  // namespace rushlight
