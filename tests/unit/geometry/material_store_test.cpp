// Images, their mip levels, and materials as the shaders read them.
#include "renderer/resources/material_store.h"

#include "renderer/materials/mip_chain.h"
#include "renderer/materials/surface_variant.h"
#include "tests/support/memory_device.h"

#include <gtest/gtest.h>
#include <glm/gtc/packing.hpp>

#include <bit>
#include <limits>

namespace rushlight {
namespace {

TEST(MipChain, LevelsGoDownToOneTexel) {
    EXPECT_EQ(mipLevelCount(1, 1), 1u);
    EXPECT_EQ(mipLevelCount(2, 1), 2u);
    EXPECT_EQ(mipLevelCount(256, 256), 9u);
    EXPECT_EQ(mipLevelCount(300, 7), 9u);
}

TEST(MipChain, ColoursAverageInLinearLight) {
    const std::vector<uint8_t> checker = {0,   0,   0,   0,   255, 255, 255, 255,
                                          255, 255, 255, 255, 0,   0,   0,   0};
    // Half the light is 0.5 linear: 188 in sRGB (IEC 61966-2-1). Alpha is not a colour.
    EXPECT_EQ(halveImage(checker, 2, 2, true), (std::vector<uint8_t>{188, 188, 188, 128}));
    EXPECT_EQ(halveImage(checker, 2, 2, false), (std::vector<uint8_t>{128, 128, 128, 128}));
}

TEST(MipChain, EvenColoursStayTheSame) {
    for (uint32_t value = 0; value < 256; ++value) {
        const std::vector<uint8_t> flat(4 * 4, uint8_t(value));
        for (bool srgb : {false, true})
            EXPECT_EQ(halveImage(flat, 2, 2, srgb), std::vector<uint8_t>(4, uint8_t(value)))
                << value;
    }
}

TEST(MipChain, OddSizesLoseNoTexel) {
    for (uint32_t bright = 0; bright < 3; ++bright) {
        std::vector<uint8_t> row(3 * 4, 0);
        for (size_t c = 0; c < 4; ++c) row[bright * 4 + c] = 255;
        EXPECT_GT(halveImage(row, 3, 1, false)[0], 60) << "column " << bright;
        EXPECT_GT(halveImage(row, 1, 3, false)[0], 60) << "row " << bright;
    }
}

class MaterialStoreTest : public testing::Test {
protected:
    MemoryDevice device;
    SerialJobs jobs;
    TextureStore textures{device, jobs};
    MaterialStore materials{device, textures};

    ImageHandle image(uint32_t side, bool srgb = false) {
        const std::vector<uint8_t> pixels(size_t(side) * side * 4, 77);
        return *textures.create({"image", side, side, srgb, pixels});
    }
    void flush() {
        const auto moved = textures.flush();
        ASSERT_TRUE(moved);
        ASSERT_TRUE(materials.flush(*moved));
    }
    uvec4 texel(MaterialHandle m, uint32_t i) {
        return device.read<uvec4>(materials.buffer().buffer, materials.find(m)->texel + i);
    }
    uint32_t flags(const MaterialDesc& desc) {
        return materials.find(*materials.create(desc))->surfaceFlags;
    }
};

TEST_F(MaterialStoreTest, FactorsArePackedAsTheShadersReadThem) {
    MaterialDesc desc;
    desc.baseColor = {0.25f, 0.5f, 0.75f, 1};
    desc.metallic = 0;
    desc.roughness = 1;
    desc.normalScale = 2;
    desc.occlusionStrength = 0.5f;
    desc.emissive = {1000, 1e9f, 0.125f};
    desc.alphaCutoff = 0.25f;
    const MaterialHandle m = *materials.create(desc);
    flush();
    const auto halves = [](uint32_t bits) { return glm::unpackHalf2x16(bits); };
    EXPECT_EQ(halves(texel(m, 0).x), vec2(0.25f, 0.5f));
    EXPECT_EQ(halves(texel(m, 0).y), vec2(0.75f, 1));
    EXPECT_EQ(glm::unpackUnorm2x16(texel(m, 0).z), vec2(0, 1));
    EXPECT_EQ(halves(texel(m, 0).w), vec2(2, 0.5f));
    EXPECT_EQ(halves(texel(m, 1).x), vec2(1000, 65504)) << "what a half cannot hold is clamped";
    EXPECT_EQ(halves(texel(m, 1).y), vec2(0.125f, 0.25f));
}

TEST_F(MaterialStoreTest, LayersAndUvSetsArePacked) {
    MaterialDesc desc;
    image(8);
    const ImageHandle a = image(8), b = image(8), c = image(16, true);
    desc.baseColorTexture.image = c;
    desc.normalTexture.image = a;
    desc.normalTexture.uvSet = 1;
    desc.occlusionTexture.image = b;
    const MaterialHandle m = *materials.create(desc);
    flush();
    EXPECT_EQ(texel(m, 1).z, textures.find(c)->layer | textures.find(a)->layer << 20);
    EXPECT_EQ(texel(m, 1).w, textures.find(b)->layer | 1u << 22);
    EXPECT_EQ(textures.find(a)->array, textures.find(b)->array) << "one size, one array";
    EXPECT_NE(textures.find(a)->layer, textures.find(b)->layer);
    const TextureSet& set = materials.textureSet(materials.find(m)->textureSet);
    EXPECT_EQ(set[0].texture, textures.find(c)->array);
    EXPECT_EQ(set[2].texture, textures.find(a)->array);
    EXPECT_FALSE(set[1].texture);
}

// KHR_texture_transform, its example: offset, then rotation counter-clockwise, then scale.
TEST_F(MaterialStoreTest, TransformsArePackedAsMatrices) {
    MaterialDesc desc;
    desc.baseColorTexture.image = image(4);
    desc.baseColorTexture.offset = {0.5f, 0.25f};
    desc.baseColorTexture.rotation = kPi / 2;
    desc.baseColorTexture.scale = {2, 3};
    const MaterialHandle m = *materials.create(desc);
    flush();
    ASSERT_TRUE(materials.find(m)->surfaceFlags & kUvTransforms);
    const uvec4 bits = texel(m, 2), offset = texel(m, 3);
    const auto f = [](uint32_t x) { return std::bit_cast<float>(x); };
    const auto apply = [&](vec2 uv) {
        return vec2(f(bits.x), f(bits.y)) * uv.x + vec2(f(bits.z), f(bits.w)) * uv.y +
               vec2(f(offset.x), f(offset.y));
    };
    EXPECT_LT(glm::distance(apply({0, 0}), vec2(0.5f, 0.25f)), 1e-6f);
    EXPECT_LT(glm::distance(apply({1, 0}), vec2(0.5f, 0.25f - 2)), 1e-6f);
    EXPECT_LT(glm::distance(apply({0, 1}), vec2(0.5f + 3, 0.25f)), 1e-6f);
}

TEST_F(MaterialStoreTest, FlagsNameWhatTheShaderNeeds) {
    MaterialDesc desc;
    EXPECT_EQ(flags(desc), 0u);
    desc.occlusionTexture.image = desc.metallicRoughnessTexture.image = image(4);
    EXPECT_EQ(flags(desc), uint32_t(kMetallicRoughnessTexture | kOcclusionInMetallicRoughness));
    desc.occlusionTexture.uvSet = 1;
    EXPECT_EQ(flags(desc), uint32_t(kMetallicRoughnessTexture | kOcclusionTexture | kSecondUv));
    desc = {};
    desc.emissiveTexture.image = image(4, true);
    EXPECT_EQ(flags(desc), 0u) << "a factor of zero";
    desc.emissive = vec3(1);
    EXPECT_EQ(flags(desc), uint32_t(kEmissive | kEmissiveTexture));
    desc.unlit = true;
    EXPECT_EQ(flags(desc), uint32_t(kUnlit));
    desc = {};
    desc.alphaMode = AlphaMode::mask;
    desc.doubleSided = true;
    EXPECT_EQ(flags(desc), uint32_t(kAlphaMask | kDoubleSided));
}

TEST_F(MaterialStoreTest, LightGoesThroughAndIsBlendedWithWhatIsBehind) {
    MaterialDesc desc;
    desc.transmissionTexture.image = image(4);
    EXPECT_EQ(flags(desc), 0u) << "a factor of zero";
    desc.transmission = 0.5f;
    EXPECT_EQ(flags(desc), uint32_t(kBlend | kTransmission | kTransmissionTexture));
    desc.alphaMode = AlphaMode::mask;
    EXPECT_EQ(flags(desc), uint32_t(kBlend | kTransmission | kTransmissionTexture | kAlphaMask));
    desc.unlit = true;
    EXPECT_EQ(flags(desc), uint32_t(kAlphaMask | kUnlit));
    for (const float bad : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity()}) {
        MaterialDesc wrong;
        wrong.transmission = bad;
        const auto refused = materials.create(wrong);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().message.find("not within 0 to 1"), std::string::npos);
        wrong = {};
        wrong.transmissionColor.y = bad;
        EXPECT_FALSE(materials.create(wrong));
    }
}

TEST_F(MaterialStoreTest, AnImageThatIsDestroyedLeavesItsMaterials) {
    MaterialDesc desc;
    desc.baseColorTexture.image = image(4);
    const MaterialHandle m = *materials.create(desc);
    flush();
    textures.destroy(desc.baseColorTexture.image);
    flush();
    const GpuMaterial& gpu = *materials.find(m);
    EXPECT_EQ(gpu.surfaceFlags, 0u);
    EXPECT_FALSE(materials.textureSet(gpu.textureSet)[0].texture);
    EXPECT_TRUE(device.textures.empty());
}

TEST_F(MaterialStoreTest, UpdatesReplaceAndStaleHandlesAreErrors) {
    const MaterialHandle m = *materials.create({});
    MaterialDesc desc;
    desc.baseColor = vec4(0.5f);
    ASSERT_TRUE(materials.update(m, desc));
    flush();
    EXPECT_EQ(glm::unpackHalf2x16(texel(m, 0).x), vec2(0.5f));
    materials.destroy(m);
    EXPECT_FALSE(materials.update(m, desc));
    EXPECT_EQ(materials.find(m), nullptr);
    EXPECT_NE(materials.find({}), nullptr) << "a zero handle is glTF's default material";
    desc.label = "rust";
    desc.roughness = std::numeric_limits<float>::quiet_NaN();
    const auto made = materials.create(desc);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().text().find("rust"), std::string::npos);
    desc.roughness = 1;
    desc.normalTexture.uvSet = 2;
    EXPECT_FALSE(materials.create(desc));
    desc.normalTexture = {};
    desc.normalTexture.image = image(4);
    textures.destroy(desc.normalTexture.image);
    EXPECT_FALSE(materials.create(desc));
}

TEST_F(MaterialStoreTest, ImagesAreUploadedWithAllLevels) {
    const ImageHandle handle = image(8);
    flush();
    ASSERT_EQ(device.uploads.size(), 4u);
    for (uint32_t level = 0; level < 4; ++level) {
        EXPECT_EQ(device.uploads[level].region.mipLevel, level);
        EXPECT_EQ(device.uploads[level].data.size(), size_t(64 >> 2 * level) * 4);
        EXPECT_EQ(device.uploads[level].data[0], std::byte(77));
    }
    EXPECT_EQ(device.textures.at(textures.find(handle)->array).mipLevels, 4u);
    flush();
    EXPECT_EQ(device.uploads.size(), 4u) << "once";
}

TEST_F(MaterialStoreTest, BadImagesAreErrorsThatNameTheLabel) {
    const std::vector<uint8_t> pixels(16);
    const auto refused = [&](uint32_t width, uint32_t height) {
        const auto made = textures.create({"poster", width, height, true, pixels});
        return !made && made.error().text().find("poster") != std::string::npos;
    };
    EXPECT_FALSE(refused(2, 2));
    EXPECT_TRUE(refused(0, 2));
    EXPECT_TRUE(refused(2, 0));
    EXPECT_TRUE(refused(2, 3));
    EXPECT_TRUE(refused(1, 2));
    EXPECT_TRUE(refused(16385, 1));
    EXPECT_TRUE(refused(65536, 65536)) << "whose size in 32 bits is zero";
}

}  // namespace
}  // namespace rushlight
