// Decals: what they change, where, and what they leave alone.

#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kSide = 128;

/// A white floor of 20 metres seen straight from above, 10 metres of it across; lit evenly.
class DecalsGl : public LitFrame {
protected:
    DecalsGl() : LitFrame(kSide, kSide) {}

    void SetUp() override {
        LitFrame::SetUp();
        paintFloor({});
        lookDown(5, 8);
        input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
        paint.material = *renderer->createDecalMaterial({.label = "paint"});
        lieFlat(paint, {0, 0}, 1);
    }
    void paintFloor(MaterialDesc material) {
        material.metallic = 0;
        instances.clear();
        addBox({0, -1, 0}, {20, 1, 20}, *renderer->createMaterial(material));
    }

    /// Thrown downwards on the floor: the decal's z is up, its picture's up is -z.
    static void lieFlat(Decal& decal, const vec2& at, float halfSide) {
        decal.worldFromDecal[0] = vec3(halfSide, 0, 0);
        decal.worldFromDecal[1] = vec3(0, 0, -halfSide);
        decal.worldFromDecal[2] = vec3(0, 0.5f, 0);
        decal.worldFromDecal[3] = vec3(at.x, 0, at.y);
    }
    CapturedImage render(std::span<const Decal> decals) {
        input.decals = decals;
        return LitFrame::render();
    }
    /// At a place of the floor, in metres.
    static vec3 at(const CapturedImage& image, float x, float z) {
        const uint32_t column = uint32_t((x + 5) * kSide / 10),
                       row = uint32_t((z + 5) * kSide / 10);
        return pixelOf(image, column, row);
    }

    Decal paint;
};

TEST_F(DecalsGl, ColourLiesWithinTheBoxAlone) {
    paint.baseColor = {1, 0.04f, 0.04f, 1};
    const CapturedImage bare = render({}), painted = render({&paint, 1});
    for (const vec2 inside : {vec2(0), vec2(0.9f, -0.9f), vec2(-0.9f, 0.9f)})
        EXPECT_LT(at(painted, inside.x, inside.y).y, 0.4f * at(bare, 0, 0).y);
    for (const vec2 outside : {vec2(1.1f, 0), vec2(0, -1.1f), vec2(-1.2f, 1.2f), vec2(4, 4)})
        EXPECT_EQ(at(painted, outside.x, outside.y), at(bare, outside.x, outside.y));
    // One that hovers over the floor does not touch it.
    paint.worldFromDecal[3].y = 0.6f;
    EXPECT_EQ(render({&paint, 1}).rgba32f, bare.rgba32f);
    // Nor one that is thrown up from below.
    lieFlat(paint, {0, 0}, 1);
    paint.worldFromDecal[2] = -paint.worldFromDecal[2];
    EXPECT_EQ(render({&paint, 1}).rgba32f, bare.rgba32f);
}

TEST_F(DecalsGl, LaterOnesLieOverEarlierOnesByTheirCover) {
    Decal two[] = {paint, paint};
    two[0].baseColor = {1, 0, 0, 1};
    two[1].baseColor = {0, 1, 0, 0.5f};
    lieFlat(two[1], {1, 0}, 1);
    const CapturedImage image = render(two);
    const vec3 red = at(image, -0.5f, 0), both = at(image, 0.5f, 0), half = at(image, 1.5f, 0);
    EXPECT_GT(red.x, 5 * red.y);
    EXPECT_NEAR(both.x, both.y, 0.05f * both.x);
    EXPECT_NEAR(half.x, both.x, 0.05f * half.x);
    EXPECT_GT(half.y, 1.5f * half.x);
    std::swap(two[0], two[1]);
    const vec3 swapped = at(render(two), 0.5f, 0);
    EXPECT_GT(swapped.x, 5 * swapped.y);
}

TEST_F(DecalsGl, ThePictureStandsUprightAndItsAlphaCuts) {
    // Top left red, top right green, bottom left blue, bottom right clear.
    std::vector<uint8_t> pixels(64 * 64 * 4, 0);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            uint8_t* p = &pixels[(y * 64 + x) * 4];
            const uint32_t quarter = (y / 32) * 2 + x / 32;
            if (quarter < 3) p[quarter] = p[3] = 255;
        }
    paint.material = *renderer->createDecalMaterial(
        {.label = "quarters",
         .baseColor = {
             .label = "quarters", .width = 64, .height = 64, .srgb = true, .pixels = pixels}});
    const CapturedImage bare = render({}), image = render({&paint, 1});
    EXPECT_GT(at(image, -0.5f, -0.5f).x, 5 * at(image, -0.5f, -0.5f).y);
    EXPECT_GT(at(image, 0.5f, -0.5f).y, 5 * at(image, 0.5f, -0.5f).x);
    EXPECT_GT(at(image, -0.5f, 0.5f).z, 5 * at(image, -0.5f, 0.5f).x);
    EXPECT_EQ(at(image, 0.5f, 0.5f), at(bare, 0.5f, 0.5f));
}

TEST_F(DecalsGl, NormalsAndRoughnessAreReplacedByTheirShares) {
    // A slope to the right: the decal's x.
    std::vector<uint8_t> slope(16 * 4);
    for (size_t i = 0; i < slope.size(); i += 4)
        slope[i] = 217, slope[i + 1] = 128, slope[i + 2] = 217, slope[i + 3] = 255;
    paint.material = *renderer->createDecalMaterial(
        {.label = "slope", .normal = {.label = "slope", .width = 4, .height = 4, .pixels = slope}});
    paint.baseColorShare = paint.roughnessShare = 0;
    DirectionalLight sun;
    sun.direction = {-std::sqrt(0.5f), -std::sqrt(0.5f), 0};
    sun.castsShadow = false;
    input.lighting.directional = {&sun, 1};
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0);
    const CapturedImage bare = render({}), tilted = render({&paint, 1});
    // Facing the sun instead of 45 degrees off.
    EXPECT_NEAR(at(tilted, 0, 0).x / at(bare, 0, 0).x, std::sqrt(2.0f), 0.12f);
    paint.normalShare = 0;
    EXPECT_EQ(render({&paint, 1}).rgba32f, bare.rgba32f);
    // A mirror-like puddle sends the sun elsewhere than up.
    paint.roughnessShare = 1;
    paint.roughness = 0.1f;
    EXPECT_LT(at(render({&paint, 1}), 0, 0).x, at(bare, 0, 0).x);
}

TEST_F(DecalsGl, BlendedSurfacesCarryThemToo) {
    MaterialDesc glass;
    glass.baseColor = {1, 1, 1, 0.999f};
    glass.alphaMode = AlphaMode::blend;
    paintFloor(glass);
    paint.baseColor = {1, 0.04f, 0.04f, 1};
    const CapturedImage image = render({&paint, 1});
    EXPECT_LT(at(image, 0, 0).y, 0.4f * at(image, 3, 0).y);
}

TEST_F(DecalsGl, ThoseOutOfSightChangeNoPixel) {
    const CapturedImage without = render({});
    lieFlat(paint, {100, 100}, 1);
    EXPECT_EQ(render({&paint, 1}).rgba32f, without.rgba32f);
    const std::vector<Decal> tooMany(kMaxDecals + 1, paint);
    input.decals = tooMany;
    EXPECT_FALSE(renderer->renderOffscreen(input, kSide, kSide, CaptureKind::hdr));
}

}  // namespace
}  // namespace rushlight
