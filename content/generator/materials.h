#pragma once

#include "engine/core/math.h"

#include <span>

namespace rushlight::content {

enum class Mat {
    cobble,
    gravel,
    ashlar,
    ashlarDark,
    stone,
    stoneDark,
    brick,
    plasterCream,
    plasterOchre,
    plasterRose,
    plasterInside,
    roof,
    wood,
    woodDark,
    paintGreen,
    paintBlue,
    paintRed,
    iron,
    bronze,
    clothRed,
    clothBlue,
    leaf,
    ivy,
    glass,
    windowLit,
    windowDark,
    bulbWarm,
    bulbAmber,
    bulbCool,
    water,
    terracotta,
    soil,
};

enum class Alpha { opaque, mask, blend };

/// How a material is made from the maps of a surface. Factors are linear.
struct MaterialSpec {
    Mat id;
    const char* name;
    const char* color;   ///< file stem of the colour map, or null
    const char* detail;  ///< file stem of the normal and packed maps, or null
    float metres;        ///< what one tile of the maps covers
    vec4 baseColor{1};
    float metallic = 1;
    float roughness = 1;
    float normalScale = 1;
    vec3 emissive{0};
    float emissiveStrength = 1;
    const char* emissiveMap = nullptr;
    Alpha alpha = Alpha::opaque;
    bool doubleSided = false;
};

std::span<const MaterialSpec> materialTable();
const MaterialSpec& materialSpec(Mat id);

}  // namespace rushlight::content
