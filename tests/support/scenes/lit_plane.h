#pragma once
// A plane seen from straight above, and the irradiance that lights give it.

#include "tests/support/scenes/lit_frame.h"

#include <functional>

namespace rushlight {

class LitPlane : public LitFrame {
protected:
    static constexpr uint32_t kSide = 96;
    static constexpr float kHalf = 2;  ///< metres that the picture shows to each side of the origin

    LitPlane() : LitFrame(kSide, kSide) {}

    void SetUp() override;
    CapturedImage render(const MaterialDesc& material, CaptureKind kind = CaptureKind::hdr);
    /// The irradiance that each pixel's radiance means: the diffuse light alone, as white less
    /// black.
    std::vector<vec3> irradiance();
    /// Compares with `expected(point on the plane)` where that is above `least`, within one in a
    /// hundred. Where it is negative nothing is known; elsewhere there must be hardly any light.
    void expectIrradiance(const std::function<float(vec3)>& expected, float least);
    static vec3 pointOf(uint32_t x, uint32_t y);

private:
    MeshHandle plane_;
};

}  // namespace rushlight
