#pragma once
// Photometry of types A and B as that of type C, whose vertical angles are from straight down and
// whose horizontal ones turn about it.

#include "engine/assets/model.h"

namespace rushlight::assets {

enum class IesPlanes { c = 1, b = 2, a = 3 };  ///< as LM-63 numbers them

/// Angles as the file has them, -90 or 0 to 90 both ways (0: the other side mirrors it
/// horizontally, and is dark vertically). By LM-63-2002's key definitions all types share one
/// frame: straight down is (0, 0) of B and C, and vertical -90 of A; the planes of A share a
/// vertical axis, those of B a horizontal one. Type A keeps its values, B is sampled anew between
/// them.
LightProfile asTypeC(const LightProfile& file, IesPlanes planes);

}  // namespace rushlight::assets
