// What a surface shows of its texture coordinates, of a turned sky, and of the sun where its shadow
// map ends.

#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class SurfacesGl : public LitFrame {
protected:
    SurfacesGl() : LitFrame(32, 32) {}

    /// Fills the picture, at z = -2; all of it has the same two texture coordinates.
    Instance& addSheet(MaterialHandle material, const vec2& uv0, const vec2& uv1) {
        const vec3 corners[] = {{-9, -9, -2}, {9, -9, -2}, {9, 9, -2}, {-9, 9, -2}};
        const std::vector<vec2> first(4, uv0), second(4, uv1);
        const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
        MeshDesc desc;
        desc.label = "sheet";
        desc.positions = corners;
        desc.uv0 = first;
        desc.uv1 = second;
        desc.indices = indices;
        Instance& sheet = instances.emplace_back();
        sheet.mesh = *renderer->createMesh(desc);
        sheet.material = material;
        return sheet;
    }
};

// Each texture has a set of its own: red on the left, green on the right.
TEST_F(SurfacesGl, EachTextureIsLookedUpByItsOwnCoordinates) {
    const std::vector<uint8_t> pixels = {255, 0, 0, 255, 0, 255, 0, 255};
    const ImageHandle image = *renderer->createImage({"red and green", 2, 1, true, pixels});
    for (const uint8_t baseSet : {0, 1})
        for (const uint8_t glowSet : {0, 1}) {
            SCOPED_TRACE(testing::Message()
                         << "base " << int(baseSet) << ", emissive " << int(glowSet));
            MaterialDesc desc;
            desc.metallic = 0;
            desc.baseColorTexture.image = desc.emissiveTexture.image = image;
            desc.baseColorTexture.sampler.magnify = desc.emissiveTexture.sampler
                                                        .magnify = TextureFilter::nearest;
            desc.baseColorTexture.uvSet = baseSet;
            desc.emissiveTexture.uvSet = glowSet;
            desc.emissive = vec3(100);
            instances.clear();
            addSheet(*renderer->createMaterial(desc), {0.25f, 0.5f}, {0.75f, 0.5f});
            const vec3 glow = centre();
            EXPECT_NEAR(glow[glowSet], 100, 2);
            EXPECT_NEAR(glow[1 - glowSet], 0, 2);
            desc.emissive = vec3(0);
            desc.unlit = true;
            instances[0].material = *renderer->createMaterial(desc);
            const vec3 base = centre();
            EXPECT_NEAR(base[baseSet], 1, 0.01f);
            EXPECT_NEAR(base[1 - baseSet], 0, 0.01f);
        }
}

// Light from +x, turned a quarter about +y, comes from -z: in the background and on surfaces.
TEST_F(SurfacesGl, ATurnedSkyTurnsAboutTheVerticalAxis) {
    std::vector<vec3> pixels;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) pixels.push_back(x >= 7 && x <= 8 ? vec3(8) : vec3(0.01f));
    input.lighting.environment = *renderer->createEnvironment({"sky", 16, 8, pixels});
    input.lighting.background = Background::environment;
    const auto towards = [&](const vec3& direction) {
        input.view.viewFromWorld = glm::lookAt(vec3(0), direction, vec3(0, 1, 0));
        return centre().x;
    };
    EXPECT_GT(towards({1, 0, 0}), 4);
    input.lighting.environmentRotation = kPi / 2;
    EXPECT_GT(towards({0, 0, -1}), 4);
    EXPECT_LT(towards({0, 0, 1}), 0.1f);
    EXPECT_LT(towards({1, 0, 0}), 0.1f);
    // A box between: its side towards -z is the bright one.
    MaterialDesc white;
    white.metallic = 0;
    addBox({0, 0, 0}, vec3(1), *renderer->createMaterial(white));
    const auto side = [&](const vec3& from) {
        input.view.viewFromWorld = glm::lookAt(from, vec3(0), vec3(0, 1, 0));
        return centre().x;
    };
    EXPECT_GT(side({0, 0, -3}), 4 * side({0, 0, 3}));
}

// Under a roof without end: shadowed as far as the map reaches, lit beyond.
TEST_F(SurfacesGl, BeyondTheShadowDistanceTheSunShines) {
    MaterialDesc white;
    white.metallic = 0;
    const MaterialHandle floor = *renderer->createMaterial(white);
    addBox({0, -1, 0}, {100, 1, 100}, floor).flags = 0;
    addBox({0, 8, 0}, {100, 0.5f, 100}, floor);
    const DirectionalLight sun{vec3(0, -1, 0), vec3(3), true};
    input.lighting.directional = {&sun, 1};
    input.settings.shadowDistance = 6;
    input.settings.shadowResolution = 256;
    const auto floorAhead = [&](float distance) {
        input.view.viewFromWorld = glm::lookAt(vec3(0, 1, 0), vec3(0, 0, -distance), vec3(0, 1, 0));
        return centre().x;
    };
    for (const uint32_t cascades : {1u, 2u, 4u}) {
        input.settings.shadowCascades = cascades;
        EXPECT_LT(floorAhead(3), 0.01f) << cascades;
        EXPECT_GT(floorAhead(60), 0.5f) << cascades;
    }
}

}  // namespace
}  // namespace rushlight
