#pragma once

#include "renderer/capture/breakdown/breakdown.h"

#include <nlohmann/json.hpp>

namespace rushlight {

inline constexpr const char* kPictureFolder = "pictures";

/// What frame.json holds: the schema of --stats, each pass's images, and the pictures.
Result<nlohmann::ordered_json> breakdownJson(const Breakdown& breakdown);

/// Pairs of passes of two such objects, those that differ first: by what they wrote, in one frame
/// alone, by counters. Each has "a" and "b" (indices, or null), "outputs" (whether hashes differ)
/// and "counters" (keys that differ).
nlohmann::ordered_json comparePasses(const nlohmann::ordered_json& a,
                                     const nlohmann::ordered_json& b);

/// As text that may stand in a page's script element, whatever is in its strings.
std::string textForPage(const nlohmann::ordered_json& json);
std::string textForFile(const nlohmann::ordered_json& json);

}  // namespace rushlight
