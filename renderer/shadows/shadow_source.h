#pragma once
// What of a light its shadow views depend on: where they stand, which way they look, from where on
// they see.

#include "renderer/frame/lights.h"

#include <cstdint>

namespace rushlight {

/// Views of a light. A point light has the six of a cube, a spot one, and an area light those that
/// stand in its middle: a cube's six, or five of them where it shines to one side of a plane. A
/// flat light's cube is turned so that z is the way it shines, a tube's so that z lies along it.
struct ShadowSource {
    vec3 position{0};
    float range = 0;  ///< metres; in steps of two where it follows from the intensity, which may
                      ///< flicker
    uint32_t faceCount = 0;  ///< 1, 5 or 6
    mat3 axes{1};            ///< of the cube; of a spot, z is its direction
    float tanHalf = 1;       ///< of half the angle of one view
    vec3 nearPlanes{0.05f};  ///< metres, of the views along x, y and z
    float radius = 0;        ///< metres, of the source
    float peak = 0;          ///< candela of its brightest colour
    uint32_t border = 32;    ///< a side of a tile over its border; see shadowBorder()
    uint64_t identity = 0;   ///< of all that the views depend on; never 0

    bool isCube() const { return faceCount > 1; }
    void face(uint32_t index, vec3& right, vec3& up, vec3& forward) const;
    float nearPlane(uint32_t index) const { return nearPlanes[isCube() ? int(index / 2) : 2]; }
};

ShadowSource makeShadowSource(const PunctualLight& light);
ShadowSource makeShadowSource(const AreaLight& light);

}  // namespace rushlight
