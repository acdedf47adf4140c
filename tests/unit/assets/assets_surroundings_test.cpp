// Light from around in files: EXT_lights_image_based, and reflection probes in nodes' extras.
#include "tests/unit/assets/small_gltf.h"

#include <OpenImageIO/imageio.h>

#include <cmath>

namespace rushlight::assets {
namespace {

using test::fullTriangle;
using test::Json;
using test::TempFolder;

void writePng(const std::filesystem::path& path, int size, int channels,
              const std::vector<uint8_t>& pixels) {
    auto out = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(out);
    OIIO::ImageSpec spec(size, size, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    ASSERT_TRUE(out->open(path.string(), spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, pixels.data()));
    out->close();
}

/// A triangle under a light of two levels, 4 and 2 texels: image 0 is the sharp level's, image 1
/// the rough one's.
struct LitGltf {
    test::SmallGltf gltf = fullTriangle();

    explicit LitGltf(const TempFolder& folder) {
        std::vector<uint8_t> sharp(4 * 4 * 4, 128);
        for (size_t i = 0; i < 16; ++i) sharp[i * 4 + 3] = 51;  // a fifth
        sharp[0] = 255;                                         // the top left texel, red
        writePng(folder.path() / "sharp.png", 4, 4, sharp);
        writePng(folder.path() / "rough.png", 2, 3, std::vector<uint8_t>(2 * 2 * 3, 188));
        gltf.json["images"] = Json::parse(R"([{"uri":"sharp.png"},{"uri":"rough.png"}])");
        gltf.json["extensionsUsed"] = {"EXT_lights_image_based"};
        gltf.json["extensions"]["EXT_lights_image_based"]["lights"] = Json::parse(R"([{
            "name":"hall","intensity":2,"rotation":[0,1,0,0],"specularImageSize":4,
            "irradianceCoefficients":[[1,2,3],[0,0,0],[0,0,0],[0.5,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,1]],
            "specularImages":[[0,0,0,0,0,0],[1,1,1,1,1,1]]}])");
        gltf.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
    }
    Json& light() { return gltf.json["extensions"]["EXT_lights_image_based"]["lights"][0]; }
};

TEST(AssetsSurroundings, AnImageBasedLightIsRead) {
    const TempFolder folder;
    LitGltf lit(folder);
    const auto model = loadModel(lit.gltf.save(folder), {});
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_TRUE(model->imageBasedLight);
    const ImageBasedLight& light = *model->imageBasedLight;
    EXPECT_EQ(light.name, "hall");
    EXPECT_EQ(light.intensity, 2);
    EXPECT_EQ(light.rotation.y, 1);
    EXPECT_EQ(light.irradiance[0], vec3(1, 2, 3));
    EXPECT_EQ(light.irradiance[8], vec3(0, 0, 1));
    EXPECT_EQ(light.size, 4u);
    EXPECT_EQ(light.levels, 2u);
    ASSERT_EQ(light.texels.size(), 6u * 16 + 6u * 4);
    // RGBD: half way up the sRGB curve is 0.2158, a fifth of alpha makes five times of it.
    EXPECT_NEAR(light.texels[0].x, 5 * 0.2158f, 0.01f);
    EXPECT_NEAR(light.texels[3].x, 5, 0.01f) << "seen from within, the left column is GL's last";
    EXPECT_NEAR(light.texels[16 + 3].x, 5, 0.01f) << "of every face";
    EXPECT_NEAR(light.texels[6 * 16].y, 0.5f, 0.01f) << "without alpha: as it is";
    ASSERT_EQ(model->fidelity.approximated.size(), 1u);
    EXPECT_NE(model->fidelity.approximated[0].find("EXT_lights_image_based"), std::string::npos);
}

TEST(AssetsSurroundings, WhatIsNoLightIsRefusedInASentence) {
    const TempFolder folder;
    const auto refusal = [&](auto change) {
        LitGltf lit(folder);
        change(lit);
        const auto model = loadModel(lit.gltf.save(folder), {});
        return model ? std::string() : model.error().text();
    };
    EXPECT_EQ(refusal([](LitGltf&) {}), "");
    const auto has = [&](auto change, const char* part) {
        const std::string text = refusal(change);
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has([](LitGltf& l) { l.light()["specularImageSize"] = 3; }, "no power of two");
    has([](LitGltf& l) { l.light()["specularImageSize"] = 4096; }, "specularImageSize");
    has([](LitGltf& l) { l.light().erase("specularImageSize"); }, "specularImageSize");
    has([](LitGltf& l) { l.light()["specularImages"][1].push_back(0); }, "7 faces instead of 6");
    has([](LitGltf& l) { l.light()["specularImages"][1][2] = 9; }, "9");
    has([](LitGltf& l) { l.light()["specularImages"][1][2] = -1; }, "image");
    has([](LitGltf& l) { l.light()["specularImages"] = Json::array(); }, "empty array");
    has([](LitGltf& l) { l.light()["specularImages"] = Json(4, l.light()["specularImages"][0]); },
        "4 levels");
    has([](LitGltf& l) { l.light()["irradianceCoefficients"].erase(0); },
        "8 elements instead of 9");
    has(
        [](LitGltf& l) {
            l.light()["irradianceCoefficients"][3] = {1, 2};
        },
        "2 elements instead of 3");
    has([](LitGltf& l) { l.light()["irradianceCoefficients"][3][0] = "x"; }, "out of range");
    has([](LitGltf& l) { l.light()["rotation"] = {0, 0, 0, 0.5}; }, "quaternion of length");
    has([](LitGltf& l) { l.light()["intensity"] = -1; }, "intensity");
    has(
        [](LitGltf& l) {
            l.gltf.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 1;
        },
        "light");
    has([](LitGltf& l) { l.gltf.json["extensions"].erase("EXT_lights_image_based"); }, "light");
    has([](LitGltf& l) { l.gltf.json["extensions"]["EXT_lights_image_based"]["lights"] = 3; },
        "not an array");
}

TEST(AssetsSurroundings, ImagesThatAreMissingOrOfAnotherSizeLeaveTheLightOut) {
    const TempFolder folder;
    for (const bool missing : {true, false}) {
        LitGltf lit(folder);
        if (missing)
            lit.gltf.json["images"][1]["uri"] = "nowhere.png";
        else
            lit.light()["specularImages"][1][5] = 0;
        const auto path = lit.gltf.save(folder);
        const auto refused = loadModel(path, {});
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().text().find(missing ? "nowhere.png" : "4 x 4"),
                  std::string::npos);
        LoadOptions lenient;
        lenient.missingImages = MissingImages::replace;
        const auto model = loadModel(path, lenient);
        ASSERT_TRUE(model) << model.error().text();
        EXPECT_FALSE(model->imageBasedLight);
        ASSERT_FALSE(model->fidelity.unsupported.empty());
        ASSERT_FALSE(model->warnings.empty());
        EXPECT_NE(model->warnings[0].find("image-based light 0 'hall'"), std::string::npos)
            << model->warnings[0];
        lenient.strict = true;
        EXPECT_FALSE(loadModel(path, lenient));
    }
}

TEST(AssetsSurroundings, ReflectionProbesAreReadFromExtras) {
    const TempFolder folder;
    auto gltf = fullTriangle();
    Json& node = gltf.json["nodes"][3];
    const auto load = [&](const char* extras) {
        node["extras"] = Json::parse(extras);
        return loadModel(gltf.save(folder), {});
    };
    auto model = load(
        R"({"rushlight":{"reflectionProbe":{"size":[4,2,6],"blend":0.5,"offset":[1,0,0],
        "intensity":2,"resolution":64},"other":1}})");
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_EQ(model->reflectionProbes.size(), 1u);
    const ReflectionProbe& probe = model->reflectionProbes[0];
    EXPECT_EQ(probe.node, 3);
    EXPECT_EQ(probe.size, vec3(4, 2, 6));
    EXPECT_EQ(probe.offset, vec3(1, 0, 0));
    EXPECT_EQ(probe.blend, vec3(0.5f, 0, 0.5f));
    EXPECT_EQ(probe.intensity, 2);
    EXPECT_EQ(probe.resolution, 64u);
    model = load(R"({"rushlight":{"reflectionProbe":{"size":[1,1,1],"blend":[1,2,3]}}})");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->reflectionProbes[0].blend, vec3(1, 2, 3));
    for (const char* others : {"[1]", "3", "{\"a\":null}", "\"text\""}) {
        model = load(others);
        ASSERT_TRUE(model) << model.error().text();
        EXPECT_TRUE(model->reflectionProbes.empty());
    }
    for (const char* bad :
         {R"({})", R"({"size":[0,1,1]})", R"({"size":[1,1]})", R"({"size":"x"})",
          R"({"size":[1,1,1],"blend":-1})", R"({"size":[1,1,1],"blend":[1]})",
          R"({"size":[1,1,1],"resolution":100})", R"({"size":[1,1,1],"resolution":65536})",
          R"({"size":[1,1,1],"offset":[1,0,0]})", R"({"size":[1,1,1],"intensity":-1})", R"(3)"}) {
        model = load((std::string("{\"rushlight\":{\"reflectionProbe\":") + bad + "}}").c_str());
        ASSERT_FALSE(model) << bad;
        EXPECT_NE(model.error().text().find("reflectionProbe"), std::string::npos)
            << model.error().text();
    }
}

}  // namespace
}  // namespace rushlight::assets
