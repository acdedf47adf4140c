#include "content/generator/materials.h"

#include "engine/core/check.h"

namespace rushlight::content {
namespace {

// clang-format off
constexpr vec4 kWhite{1};
const MaterialSpec kMaterials[] = {
    {Mat::cobble, "cobble", "cobble", "cobble", 2.0f},
    {Mat::gravel, "gravel", "gravel", "gravel", 1.5f},
    {Mat::ashlar, "ashlar", "ashlar", "ashlar", 2.0f},
    {Mat::ashlarDark, "ashlar.weathered", "ashlar", "ashlar", 2.0f, {0.62f, 0.60f, 0.57f, 1}},
    {Mat::stone, "stone", "stone", "stone", 1.5f},
    {Mat::stoneDark, "stone.weathered", "stone", "stone", 1.5f, {0.62f, 0.60f, 0.57f, 1}},
    {Mat::brick, "brick", "brick", "brick", 1.5f},
    {Mat::plasterCream, "plaster.cream", "plaster", "plaster", 2.5f, {0.74f, 0.66f, 0.50f, 1}},
    {Mat::plasterOchre, "plaster.ochre", "plaster", "plaster", 2.5f, {0.69f, 0.45f, 0.20f, 1}},
    {Mat::plasterRose, "plaster.rose", "plaster", "plaster", 2.5f, {0.62f, 0.33f, 0.24f, 1}},
    {Mat::plasterInside, "plaster.lime", "plaster", "plaster", 2.5f, {0.66f, 0.64f, 0.58f, 1}},
    {Mat::roof, "rooftile", "rooftile", "rooftile", 2.0f},
    {Mat::wood, "wood", "plank", "plank", 1.0f},
    {Mat::woodDark, "wood.dark", "plank", "plank", 1.0f, {0.42f, 0.36f, 0.32f, 1}},
    {Mat::paintGreen, "paint.green", "plank", "plank", 1.0f, {0.26f, 0.62f, 0.44f, 1}},
    {Mat::paintBlue, "paint.blue", "plank", "plank", 1.0f, {0.27f, 0.52f, 0.92f, 1}},
    {Mat::paintRed, "paint.red", "plank", "plank", 1.0f, {0.86f, 0.26f, 0.20f, 1}},
    {Mat::iron, "iron", "metal", "metal", 0.5f, {0.07f, 0.07f, 0.075f, 1}},
    {Mat::bronze, "bronze", "metal", "metal", 0.5f, {0.80f, 0.56f, 0.30f, 1}},
    {Mat::clothRed, "cloth.red", "cloth_red", "cloth", 1.0f, kWhite, 1, 1, 1, vec3(0), 1, nullptr, Alpha::opaque, true},
    {Mat::clothBlue, "cloth.blue", "cloth_blue", "cloth", 1.0f, kWhite, 1, 1, 1, vec3(0), 1, nullptr, Alpha::opaque, true},
    {Mat::leaf, "leaf", "leaf", "leaf", 0.8f, kWhite, 1, 1, 1, vec3(0), 1, nullptr, Alpha::mask, true},
    {Mat::ivy, "leaf.ivy", "leaf", "leaf", 0.8f, {0.55f, 0.72f, 0.62f, 1}, 1, 1, 1, vec3(0), 1, nullptr, Alpha::mask, true},
    {Mat::glass, "glass", nullptr, nullptr, 1.0f, {0.92f, 0.95f, 0.92f, 0.14f}, 0, 0.06f, 1, vec3(0), 1, nullptr, Alpha::blend},
    {Mat::windowLit, "window.lit", nullptr, nullptr, 1.0f, {0.05f, 0.045f, 0.04f, 1}, 0, 0.12f, 1, {1, 0.72f, 0.38f}, 1.6f, "window"},
    {Mat::windowDark, "window.dark", nullptr, nullptr, 1.0f, {0.022f, 0.026f, 0.032f, 1}, 0, 0.08f},
    {Mat::bulbWarm, "bulb.warm", nullptr, nullptr, 1.0f, {0.9f, 0.8f, 0.6f, 1}, 0, 0.4f, 1, {1, 0.66f, 0.30f}, 14},
    {Mat::bulbAmber, "bulb.amber", nullptr, nullptr, 1.0f, {0.9f, 0.7f, 0.5f, 1}, 0, 0.4f, 1, {1, 0.47f, 0.14f}, 12},
    {Mat::bulbCool, "bulb.cool", nullptr, nullptr, 1.0f, {0.7f, 0.85f, 0.9f, 1}, 0, 0.4f, 1, {0.50f, 0.80f, 1}, 10},
    {Mat::water, "water", nullptr, "water", 1.5f, {0.030f, 0.085f, 0.085f, 0.72f}, 0, 0.05f, 0.5f, vec3(0), 1, nullptr, Alpha::blend},
    {Mat::terracotta, "terracotta", "plaster", "plaster", 2.5f, {0.50f, 0.20f, 0.11f, 1}},
    {Mat::soil, "soil", "gravel", "gravel", 1.5f, {0.40f, 0.34f, 0.30f, 1}},
};
// clang-format on

}  // namespace

std::span<const MaterialSpec> materialTable() { return kMaterials; }

const MaterialSpec& materialSpec(Mat id) {
    const MaterialSpec& spec = kMaterials[size_t(id)];
    RL_CHECK(spec.id == id, "the table of materials is in the order of the enum");
    return spec;
}

}  // namespace rushlight::content
