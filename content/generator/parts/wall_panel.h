#pragma once

#include "content/generator/mesh_builder.h"

namespace rushlight::content {

/// A rectangle of wall facing +z.
struct WallPanel {
    float x0, x1, y0, y1, z;
};
struct Opening {
    float x0, x1, y0, y1;
};

/// The wall without its openings, and the reveals of those, `depth` deep; the openings' backs stay
/// open.
void wallPanel(MeshBuilder& b, const WallPanel& wall, const std::vector<Opening>& openings,
               float depth);

}  // namespace rushlight::content
