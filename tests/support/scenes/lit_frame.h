#pragma once
// A renderer on a context of its own, a frame to be filled, and what it shows. No OpenGL message
// may come of it.

#include "renderer/renderer.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace rushlight {

/// Linear radiance of a captured picture; rows count from the top.
vec3 pixelOf(const CapturedImage& image, uint32_t x, uint32_t y);

class LitFrame : public testing::Test {
protected:
    LitFrame(uint32_t columns, uint32_t rows) : width(columns), height(rows) {}

    void SetUp() override;
    void TearDown() override;

    /// Of the frame that `input` describes, with the fixture's instances when it has some.
    CapturedImage render(CaptureKind kind = CaptureKind::hdr);
    /// The pixel in the middle.
    vec3 centre() { return pixelOf(render(), width / 2, height / 2); }
    /// Of a name that begins so, in the last frame.
    bool hasPass(std::string_view name) const;
    /// A cube of which one half side is 1, scaled and moved.
    Instance& addBox(const vec3& center, const vec3& halfSize, MaterialHandle material = {});
    /// A material that shows its own radiance and no light.
    MaterialHandle glowing(const vec3& radiance);
    /// Looks straight down on the plane y = 0, `half` metres to each side of the origin; up in the
    /// picture is -z.
    void lookDown(float half, float eyeHeight);

    uint32_t width, height;
    TestContext context;
    TemporaryDirectory cache;  ///< shaders are compiled once
    std::unique_ptr<Renderer> renderer;
    std::vector<Instance> instances;
    FrameInput input;

private:
    MeshHandle cube_;
};

}  // namespace rushlight
