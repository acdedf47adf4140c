// Light that goes through surfaces, as files say it.

#include "tests/unit/assets/small_gltf.h"

#include <cmath>

namespace rushlight::assets {
namespace {

using test::Json, test::SmallGltf, test::TempFolder;

struct Pane {
    TempFolder folder;
    SmallGltf gltf = test::fullTriangle();
    Json& extensions = gltf.json["materials"][0]["extensions"];

    void transmission(const Json& json) { extensions["KHR_materials_transmission"] = json; }
    Result<Model> load(const LoadOptions& options = {}) {
        return loadModel(gltf.save(folder), options);
    }
    Model loaded() {
        auto model = load();
        EXPECT_TRUE(model) << model.error().text();
        return model ? std::move(*model) : Model{};
    }
};

bool names(const std::vector<std::string>& properties, std::string_view text) {
    for (const std::string& property : properties)
        if (property.find(text) != std::string::npos) return true;
    return false;
}

TEST(AssetsTransmission, AFactorIsReadAndSaidToBeApproximated) {
    Pane pane;
    pane.transmission({{"transmissionFactor", 0.75}});
    const Model model = pane.loaded();
    EXPECT_EQ(model.materials[0].transmission, 0.75f);
    EXPECT_EQ(model.materials[0].transmissionColor, vec3(1));
    EXPECT_EQ(model.materials[0].transmissionTexture.image, -1);
    EXPECT_TRUE(names(model.fidelity.approximated,
                      "KHR_materials_transmission: what is behind is seen straight"));
    EXPECT_TRUE(model.fidelity.unsupported.empty());
    const auto strict = pane.load({.strict = true});
    ASSERT_FALSE(strict);
    EXPECT_NE(strict.error().message.find("KHR_materials_transmission"), std::string::npos);
}

TEST(AssetsTransmission, NoneIsExact) {
    Pane pane;
    pane.transmission(Json::object());
    const Model model = pane.loaded();
    EXPECT_EQ(model.materials[0].transmission, 0);
    EXPECT_TRUE(names(model.fidelity.exact, "KHR_materials_transmission"));
    EXPECT_TRUE(pane.load({.strict = true}));
}

TEST(AssetsTransmission, ATextureIsDataAndHasItsTransform) {
    Pane pane;
    pane.gltf.json["images"] = Json::parse(
        R"([{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=="}])");
    pane.gltf.json["textures"] = Json::parse(R"([{"source":0}])");
    pane.transmission(
        Json::parse(R"({"transmissionFactor":1,"transmissionTexture":{"index":0,"texCoord":1,
        "extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"texCoord":0}}}})"));
    const Model model = pane.loaded();
    const TextureUse& use = model.materials[0].transmissionTexture;
    ASSERT_EQ(use.image, 0);
    EXPECT_FALSE(model.images[0].isColor);
    EXPECT_EQ(use.uvSet, 0);
    EXPECT_EQ(use.offset, vec2(0.5f, 0.25f));
}

TEST(AssetsTransmission, WhatABodyAbsorbsIsOverItsThickness) {
    Pane pane;
    pane.transmission({{"transmissionFactor", 1}});
    pane.extensions["KHR_materials_volume"] = Json::parse(
        R"({"thicknessFactor":0.5,"attenuationDistance":0.25,"attenuationColor":[0.5,1,0.1]})");
    Model model = pane.loaded();
    EXPECT_LT(glm::distance(model.materials[0].transmissionColor, vec3(0.25f, 1, 0.01f)), 1e-6f);
    EXPECT_TRUE(names(model.fidelity.approximated, "KHR_materials_volume"));
    pane.extensions["KHR_materials_volume"].erase("attenuationDistance");
    EXPECT_EQ(pane.loaded().materials[0].transmissionColor, vec3(1)) << "it is infinite then";
    pane.extensions["KHR_materials_volume"]["thicknessFactor"] = 0;
    model = pane.loaded();
    EXPECT_TRUE(names(model.fidelity.exact, "KHR_materials_volume")) << "a pane";
}

TEST(AssetsTransmission, FilesMayRequireThem) {
    Pane pane;
    pane.transmission({{"transmissionFactor", 1}});
    pane.gltf.json["extensionsUsed"] = {"KHR_materials_transmission", "KHR_materials_volume"};
    pane.gltf.json["extensionsRequired"] = {"KHR_materials_transmission", "KHR_materials_volume"};
    EXPECT_TRUE(pane.load());
}

TEST(AssetsTransmission, BadNumbersAreErrors) {
    const auto refused = [](const char* extension, const char* json, const char* reason) {
        Pane pane;
        pane.extensions[extension] = Json::parse(json);
        const auto model = pane.load();
        ASSERT_FALSE(model) << json;
        EXPECT_NE(model.error().message.find(reason), std::string::npos) << model.error().message;
        EXPECT_NE(model.error().message.find("material 0"), std::string::npos)
            << model.error().message;
    };
    refused("KHR_materials_transmission", R"({"transmissionFactor":1.5})", "transmissionFactor");
    refused("KHR_materials_transmission", R"({"transmissionFactor":-0.1})", "transmissionFactor");
    refused("KHR_materials_transmission", R"({"transmissionFactor":"1"})", "transmissionFactor");
    refused("KHR_materials_transmission", R"({"transmissionTexture":{"index":7}})", "index");
    refused("KHR_materials_volume", R"({"attenuationDistance":0})", "attenuationDistance");
    refused("KHR_materials_volume", R"({"attenuationColor":[0,2,0]})", "attenuationColor");
    refused("KHR_materials_volume", R"({"thicknessFactor":-1})", "thicknessFactor");
}

}  // namespace
}  // namespace rushlight::assets
