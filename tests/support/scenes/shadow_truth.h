#pragma once
// The share of pixels whose shadow is wrong, by casting their shadow rays.

#include "renderer/raytrace/ray_scene.h"
#include "renderer/renderer.h"

#include <functional>
#include <ostream>

namespace rushlight {

/// Of pixels that the light would reach if nothing cast shadows. A pixel counts as lit where more
/// than half of the light arrives. "Clear" are those whose truth is the same all around them within
/// one and a half texels of the shadow map.
struct ShadowFigures {
    uint64_t pixels = 0, falselyShadowed = 0, falselyLit = 0;
    uint64_t clear = 0, clearShadowed = 0, clearLit = 0;

    double shadowedShare() const { return share(falselyShadowed, pixels); }
    double litShare() const { return share(falselyLit, pixels); }
    double clearShadowedShare() const { return share(clearShadowed, clear); }
    double clearLitShare() const { return share(clearLit, clear); }
    void add(const ShadowFigures& other);

private:
    static double share(uint64_t part, uint64_t all) {
        return all ? double(part) / double(all) : 0;
    }
};
std::ostream& operator<<(std::ostream&, const ShadowFigures&);

/// One light of a frame.
struct LightChoice {
    bool sun = false;  ///< the first directional light; else
    uint32_t punctual = 0;
};

class ShadowTruth {
public:
    uint32_t width = 480, height = 270;
    /// Metres that a texel of the light's map spans at a point.
    std::function<float(const vec3&)> texelMetres;
    std::string picture;  ///< where a .png of the wrong pixels goes; empty: nowhere

    ShadowTruth(Renderer& renderer, const RayScene& scene) : renderer_(renderer), scene_(scene) {}
    /// The frame with that light alone shining; the others keep their shadow maps.
    ShadowFigures compare(const FrameInput& input, const LightChoice& light);
    /// By pixel, rows from the top: the share of the light that arrives, -1 where none would.
    std::vector<float> term(const FrameInput& input, const LightChoice& light);

private:
    std::vector<float> luminance(const FrameInput& input);
    bool isLit(const FrameInput&, const LightChoice&, const vec3& position,
               const vec3& normal) const;

    Renderer& renderer_;
    const RayScene& scene_;
};

}  // namespace rushlight
