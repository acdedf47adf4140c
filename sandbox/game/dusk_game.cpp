#include "sandbox/game/dusk_game.h"

#include "engine/input/input.h"
#include "sandbox/viewer/overlay_ui.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr double kIntroTime = 8;  // seconds

}  // namespace

Lighting duskLighting() {
    Lighting lighting;
    lighting.ambientSky = vec3(0.15f, 0.18f, 0.28f);
    lighting.ambientGround = vec3(0.06f, 0.052f, 0.048f);
    lighting.background = Background::color;
    lighting.backgroundColor = vec3(0.055f, 0.085f, 0.17f);
    lighting.fog.density = 0.006f;  // the lamps get a glow; the far side of the square stays clear
    lighting.fog.heightFalloff = 0.12f;
    return lighting;
}

void DuskGame::levelLoaded(Level& level) {
    std::vector<std::string> names;
    const auto lights = level.punctualLights();
    for (size_t i = 0; i < lights.size(); ++i) names.push_back(level.punctualName(i));
    lamps_.gather(lights, names);
    if (allLit_) lamps_.lightAll(-Lamps::kKindleTime);
}

void DuskGame::update(const GameFrame& frame) {
    time_ = frame.time;
    canLight_ = lamps_.canLightAt(frame.camera.position);
    if (canLight_ && frame.input.wasPressed(Key::e)) {
        lamps_.lightAround(frame.camera.position, frame.time);
        canLight_ = false;
    }
    lamps_.apply(frame.level.punctualLights(), frame.time);
}

void DuskGame::drawHud(OverlayUi& ui) {
    using Anchor = OverlayUi::Anchor;
    const vec4 warm(1, 0.86f, 0.6f, 1);
    if (lamps_.count() == 0 || allLit_) return;
    status_ = "lamps " + std::to_string(lamps_.litCount()) + " / " + std::to_string(lamps_.count());
    ui.text(Anchor::bottomCenter, vec2(0, -16), status_, warm, true);
    if (canLight_) ui.text(Anchor::bottomCenter, vec2(0, -60), "E: light the lamp", warm, true);
    if (lamps_.allLit())
        ui.text(Anchor::center, vec2(0, -80), "All lamps are lit. Good night.", warm, true);
    else if (time_ < kIntroTime)
        ui.text(Anchor::center, vec2(0, -80), "Night falls. Light the lamps of the square.",
                vec4(vec3(warm), std::min(1.0f, float(kIntroTime - time_))), true);
}

}  // namespace rushlight
