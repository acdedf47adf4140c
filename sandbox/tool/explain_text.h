#pragma once
// A pixel's explanation as a table for people and as JSON.

#include "renderer/answers/explain.h"
#include "sandbox/tool/render_setup.h"

#include <nlohmann/json.hpp>

namespace rushlight::tool {

void printExplanation(const PixelExplanation& pixel, const RenderSetup& setup, uvec2 size);
nlohmann::ordered_json explanationJson(const PixelExplanation& pixel, const RenderSetup& setup);

}  // namespace rushlight::tool
