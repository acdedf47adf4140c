#pragma once
// Dusk in the square: the lamps are out, and somebody has to light them.

#include "sandbox/game/lamps.h"
#include "sandbox/viewer/level.h"
#include "sandbox/viewer/viewer.h"

#include <string>

namespace rushlight {

class DuskGame final : public ViewerGame {
public:
    explicit DuskGame(bool allLit) : allLit_(allLit) {}

    void levelLoaded(Level& level) override;
    void update(const GameFrame& frame) override;
    void drawHud(OverlayUi& ui) override;

private:
    bool allLit_;  ///< the lamps burn from the start: no game, just the evening
    Lamps lamps_;
    std::string status_;
    bool canLight_ = false;
    double time_ = 0;
};

/// Sky light and background of a clear evening after sunset.
Lighting duskLighting();

}  // namespace rushlight
