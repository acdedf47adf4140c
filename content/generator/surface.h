#pragma once

#include "content/generator/png_writer.h"

#include <functional>
#include <string>

#include "content/generator/numeric.h"

namespace rushlight::content {

/// What one point of a material looks like. `color` is sRGB encoded; `height` is in metres.
struct Texel {
    float height = 0;
    vec3 color{0.5f};
    float roughness = 0.8f;
    float metallic = 0;
    float alpha = 1;
};

/// A tileable material on [0, 1)^2: u to the right, v down, as in the picture.
using TexelFunction = std::function<Texel(float u, float v)>;

struct SurfaceSpec {
    std::string name;     ///< files are NAME_color.png, NAME_normal.png, NAME_orm.png
    int size = 512;       ///< pixels, of colour and normal; the packed map has half of it
    float metres = 1;     ///< what one tile covers
    float occlusion = 1;  ///< strength of the cavity term
    bool alpha = false;   ///< writes RGBA
    TexelFunction texel;
};

/// Colour, normal (+y up in the picture, as glTF) and occlusion-roughness-metallic of one surface.
struct SurfaceMaps {
    Picture color;
    Picture normal;
    Picture orm;
};
SurfaceMaps bakeSurface(const SurfaceSpec& spec);

SurfaceSpec cobbleSurface();
SurfaceSpec gravelSurface();
SurfaceSpec ashlarSurface();
SurfaceSpec stoneSurface();  ///< carved, without joints
SurfaceSpec brickSurface();
SurfaceSpec plasterSurface();
SurfaceSpec roofTileSurface();
SurfaceSpec plankSurface();
SurfaceSpec metalSurface();
SurfaceSpec clothSurface(const vec3& stripe, const std::string& name);
SurfaceSpec leafSurface();
SurfaceSpec windowSurface();  ///< the colour map is the light of a lit window
SurfaceSpec waterSurface();

}  // namespace rushlight::content
