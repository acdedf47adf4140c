// What a material's numbers do to its textures, under transforms that mirror, and how fast the
// G-buffer says things move.

#include "interop/encode.h"
#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

#include <cstring>

namespace rushlight {
namespace {

class MaterialsGl : public LitFrame {
protected:
    MaterialsGl() : LitFrame(16, 16) {}

    /// Fills the picture at z = -2, u towards +x, v towards -y; one texture coordinate all over.
    Instance& addSheet(MaterialHandle material, const vec2& uv = vec2(0.5f)) {
        const vec3 corners[] = {{-9, -9, -2}, {9, -9, -2}, {9, 9, -2}, {-9, 9, -2}};
        const std::vector<vec3> normals(4, {0, 0, 1});
        const std::vector<vec4> tangents(4, {1, 0, 0, 1});
        const std::vector<vec2> uvs(4, uv);
        const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
        MeshDesc desc;
        desc.label = "sheet";
        desc.positions = corners;
        desc.normals = normals;
        desc.tangents = tangents;
        desc.uv0 = uvs;
        desc.indices = indices;
        Instance sheet;
        sheet.mesh = *renderer->createMesh(desc);
        sheet.material = material;
        instances = {sheet};
        return instances[0];
    }
    ImageHandle texel(uint8_t r, uint8_t g, uint8_t b) {
        const std::vector<uint8_t> pixel = {r, g, b, 255};
        return *renderer->createImage({"one texel", 1, 1, false, pixel});
    }
    vec3 under(const vec3& towardsSun) {
        sun_ = {-glm::normalize(towardsSun), vec3(3)};
        input.lighting.directional = {&sun_, 1};
        return centre();
    }
    MaterialDesc chalk() const {
        MaterialDesc desc;
        desc.metallic = 0;
        return desc;
    }

private:
    DirectionalLight sun_;
};

// KHR_texture_transform: offset after rotation after scale; v grows downwards.
TEST_F(MaterialsGl, TexturesAreMovedTurnedAndScaled) {
    std::vector<uint8_t> pixels;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            pixels.insert(pixels.end(), {uint8_t(column * 85), uint8_t(row * 85), 0, 255});
    MaterialDesc desc;
    desc.unlit = true;
    TextureSlot& slot = desc.baseColorTexture;
    slot.image = *renderer->createImage({"places", 4, 4, false, pixels});
    slot.sampler.magnify = slot.sampler.minify = TextureFilter::nearest;
    const auto place = [&](const vec2& uv) {
        addSheet(*renderer->createMaterial(desc), uv);
        const vec3 color = centre();
        return ivec2(glm::round(vec2(color) * 3.0f));
    };
    const vec2 uv(0.125f, 0.375f);
    EXPECT_EQ(place(uv), ivec2(0, 1));
    slot.offset = {0.25f, 0.5f};
    EXPECT_EQ(place(uv), ivec2(1, 3));
    slot.offset = vec2(0);
    slot.scale = {5, 2};
    EXPECT_EQ(place(uv), ivec2(2, 3));
    slot.scale = vec2(1);
    slot.rotation = kPi / 2;  // to (v, -u)
    EXPECT_EQ(place(uv), ivec2(1, 3));
    slot.offset = {0.25f, 0.75f};
    slot.scale = {1, 2};  // (0.75, -0.125) and the offset
    EXPECT_EQ(place(uv), ivec2(0, 2));
}

TEST_F(MaterialsGl, ScaleOfNormalsAndStrengthOfOcclusionAreApart) {
    MaterialDesc desc = chalk();
    addSheet(*renderer->createMaterial(desc));
    const float flat = under({0, 1, 1}).x;
    desc.normalTexture.image = texel(128, 204, 230);  // (0, 0.6, 0.8): towards the sun
    desc.occlusionTexture.image = texel(0, 0, 0);
    desc.occlusionStrength = 0.5f;
    for (const float scale : {0.0f, 0.5f, 1.0f}) {
        desc.normalScale = scale;
        instances[0].material = *renderer->createMaterial(desc);
        const vec3 normal = glm::normalize(vec3(0, 0.6f * scale, 0.8f));
        const float cosine = glm::dot(normal, glm::normalize(vec3(0, 1, 1)));
        EXPECT_NEAR(under({0, 1, 1}).x / flat, cosine / std::sqrt(0.5f), 0.02f) << scale;
    }

    input.lighting.directional = {};
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
    desc.normalTexture = {};
    desc.normalScale = 1;
    for (const float strength : {0.0f, 0.25f, 0.5f, 1.0f}) {
        desc.occlusionStrength = strength;
        instances[0].material = *renderer->createMaterial(desc);
        const float lit = centre().x;
        desc.occlusionTexture.image = {};
        instances[0].material = *renderer->createMaterial(desc);
        EXPECT_NEAR(lit / centre().x, 1 - strength, 0.03f) << strength;
        desc.occlusionTexture.image = texel(0, 0, 0);
    }
}

// A mirrored thing under a mirrored sun.
TEST_F(MaterialsGl, AMirroredInstanceIsItsMirrorImage) {
    for (const ivec2 tilt : {ivec2(204, 128), ivec2(128, 204), ivec2(50, 180)}) {
        MaterialDesc desc = chalk();
        desc.normalTexture.image = texel(uint8_t(tilt.x), uint8_t(tilt.y), 230);
        Instance& sheet = addSheet(*renderer->createMaterial(desc));
        for (const vec3& sun : {vec3(1, 0, 1), vec3(0, 1, 1), vec3(-1, 0, 1), vec3(0, -1, 1)}) {
            const float plain = under(sun).x;
            sheet.worldFromLocal[0] *= -1.0f;
            EXPECT_NEAR(under(sun * vec3(-1, 1, 1)).x, plain, 0.03f * plain)
                << sun.x << " " << sun.y;
            sheet.worldFromLocal[0] *= -1.0f;
        }
    }
}

TEST_F(MaterialsGl, VelocityIsThePartOfThePictureThatAPlaceMoved) {
    constexpr float kDistance = 2;
    const vec2 perMetre = vec2(0.5f / (kDistance * std::tan(input.view.verticalFov / 2)));
    Instance& sheet = addSheet(*renderer->createMaterial(chalk()));
    sheet.flags = kInstanceMoving;
    const auto velocity = [&](const vec2& thing, const vec2& camera) {
        mat4x3 before(1);
        before[3] = -vec3(thing, 0);
        input.previousTransforms = {&before, 1};
        input.instances = instances;
        FrameOptions options;
        options.keepImages = true;
        CapturedImage image;
        // The view remembers where its camera was.
        const mat4 now = input.view.viewFromWorld;
        for (const mat4& viewFromWorld : {glm::translate(mat4(1), vec3(camera, 0)), now}) {
            input.view.viewFromWorld = viewFromWorld;
            const auto ticket = renderer->renderOffscreen(input, width, height, CaptureKind::hdr,
                                                          options);
            EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
        }
        for (const PassReport& pass : renderer->report().passes)
            for (const PassImage& written : pass.images)
                if (std::string_view(written.name) == "emissive-velocity-occlusion") {
                    const std::byte* texel = &written.texels[(size_t(8) * width + 8) * 4];
                    return interop::unpackVelocity(
                        vec3(float(texel[0]), float(texel[1]), float(texel[2])) / 255.0f);
                }
        ADD_FAILURE() << "there is no such image";
        return vec2(0);
    };
    const auto expectNear = [](const vec2& actual, const vec2& expected) {
        for (int c = 0; c < 2; ++c)
            EXPECT_NEAR(actual[c], expected[c], 0.002f + 0.002f * std::abs(expected[c]));
    };
    expectNear(velocity({0.3f, -0.2f}, {0, 0}), vec2(0.3f, -0.2f) * perMetre);
    expectNear(velocity({-0.05f, 0.6f}, {0, 0}), vec2(-0.05f, 0.6f) * perMetre);
    expectNear(velocity({0, 0}, {0.4f, 0.1f}), -vec2(0.4f, 0.1f) * perMetre);
    expectNear(velocity({0.4f, 0.1f}, {0.4f, 0.1f}), vec2(0));
}

}  // namespace
}  // namespace rushlight
