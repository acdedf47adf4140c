#pragma once
// IESNA LM-63 photometric files (.ies): how bright a luminaire is in which direction.

#include "engine/assets/model.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string_view>

namespace rushlight::assets {

/// LM-63-1986, -1991, -1995, -2002 and -2019 with TILT=NONE or TILT=INCLUDE, whose factors are for
/// a luminaire that hangs askew and are not applied. Photometry of types A and B becomes type C
/// (ies_planes.h). Candela is as it shines: times the candela multiplier and the ballast factor.
/// `name` is for messages.
Result<LightProfile> parseIes(std::string_view name, std::string_view text);
Result<LightProfile> loadIes(const std::filesystem::path& path);

/// Whether a file that can be parsed has factors for a luminaire that hangs askew.
bool hasTiltFactors(std::string_view text);

/// Lumens: candela integrated over the sphere.
double luminousFlux(const LightProfile& profile);

}  // namespace rushlight::assets
