// Files that bring the light around them: the tool, and frames for tests, use an image-based light
// and capture reflection probes.

#include "renderer/testing/frame.h"
#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace rushlight {
namespace {

using Json = nlohmann::json;

/// 2 x 2 texels of mid grey.
constexpr const char* kGrey =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAADklEQVR4nGPYAwYMEAoAPb4I0c/"
    "S0MAAAAAASUVORK5CYII=";

class SurroundingsCli : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::copy(RUSHLIGHT_SOURCE "/content/testcard", folder.path());
        json = Json::parse(bytes("testcard.gltf"));
    }
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    std::string bytes(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void save() const { std::ofstream(path("lit.gltf"), std::ios::binary) << json.dump(); }
    Ended capture(const std::string& name, const std::string& more = "") const {
        return runTool(folder.path(), "capture " + path("lit.gltf") + " --size 64x48 --stats " +
                                          path("stats.json") + " -o " + path(name) + " " + more);
    }
    std::string fidelity() const { return Json::parse(bytes("stats.json"))["fidelity"].dump(); }

    void addLight(const char* image, double red) {
        const int first = json.contains("images") ? int(json["images"].size()) : 0;
        json["images"].push_back({{"uri", image}});
        const std::vector<int> face(6, first);
        std::vector<std::vector<double>> harmonics(9, {0, 0, 0});
        harmonics[0] = {red, 1, 1};
        json["extensionsUsed"].push_back("EXT_lights_image_based");
        json["extensions"]["EXT_lights_image_based"]["lights"] = {
            {{"irradianceCoefficients", harmonics},
             {"specularImageSize", 2},
             {"specularImages", {face}}}};
        json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
    }

    TemporaryDirectory folder;
    Json json;
};

TEST_F(SurroundingsCli, AnImageBasedLightLightsWhereNoEnvironmentIsNamed) {
    addLight(kGrey, 4);
    save();
    const Ended lit = capture("lit.png");
    ASSERT_EQ(lit.code, 0) << lit.errors;
    EXPECT_NE(fidelity().find("EXT_lights_image_based"), std::string::npos) << fidelity();
    ASSERT_EQ(capture("off.png", "--ambient 0,0,0 --environment-intensity 0").code, 0);
    EXPECT_FALSE(bytes("lit.png") == bytes("off.png"));
    ASSERT_EQ(capture("again.png", "--threads 1").code, 0);
    EXPECT_TRUE(bytes("lit.png") == bytes("again.png"));
    EXPECT_EQ(capture("strict.png", "--strict").code, 3) << "its levels are resampled";

    json["extensions"]["EXT_lights_image_based"]["lights"][0]["specularImageSize"] = 4;
    save();
    const Ended wrong = capture("wrong.png");
    EXPECT_EQ(wrong.code, 3);
    EXPECT_NE(wrong.errors.find("2 x 2 pixels"), std::string::npos) << wrong.errors;
}

TEST_F(SurroundingsCli, ReflectionProbesOfNodesAreCaptured) {
    json["nodes"].push_back(
        {{"name", "probe"},
         {"translation", {0, 1, 0}},
         {"extras",
          {{"rushlight", {{"reflectionProbe", {{"size", {20, 20, 20}}, {"resolution", 32}}}}}}}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    save();
    const Ended on = capture("on.png");
    ASSERT_EQ(on.code, 0) << on.errors;
    EXPECT_EQ(on.errors, "");
    EXPECT_NE(fidelity().find("reflection probes of extras.rushlight"), std::string::npos);
    ASSERT_EQ(capture("off.png", "--reflection-probes off").code, 0);
    EXPECT_FALSE(bytes("on.png") == bytes("off.png"));
    ASSERT_EQ(capture("again.png", "--reflection-probes on --threads 1").code, 0);
    EXPECT_TRUE(bytes("on.png") == bytes("again.png"));
    // Files without any are what they are either way.
    json["nodes"].back().erase("extras");
    save();
    ASSERT_EQ(capture("plain.png").code, 0);
    EXPECT_TRUE(bytes("plain.png") == bytes("off.png"));

    json["nodes"].back()["extras"] = {{"rushlight", {{"reflectionProbe", {{"size", {0, 1, 1}}}}}}};
    save();
    const Ended wrong = capture("wrong.png");
    EXPECT_EQ(wrong.code, 3);
    EXPECT_NE(wrong.errors.find("extras.rushlight.reflectionProbe"), std::string::npos)
        << wrong.errors;
}

/// The mean of red, green and blue of a test's frame of lit.gltf, 0 to 255.
vec3 meanOfTestFrame(const std::string& scene) {
    const auto offscreen = golden::Offscreen::create();
    EXPECT_TRUE(offscreen) << offscreen.error().text();
    SceneView view;
    view.width = 64, view.height = 48;
    const auto frame = (*offscreen)->renderScene(scene, view);
    EXPECT_TRUE(frame) << frame.error().text();
    vec3 sum(0);
    for (size_t i = 0; i < frame->image.rgba8.size(); ++i)
        if (i % 4 < 3) sum[int(i % 4)] += frame->image.rgba8[i];
    return sum / float(64 * 48);
}

TEST_F(SurroundingsCli, FramesForTestsHaveTheFilesSurroundings) {
    addLight(kGrey, 0.5);
    save();
    const vec3 bluish = meanOfTestFrame(path("lit.gltf"));
    auto& light = json["extensions"]["EXT_lights_image_based"]["lights"][0];
    light["irradianceCoefficients"][0] = {4, 1, 1};
    save();
    const vec3 red = meanOfTestFrame(path("lit.gltf"));
    EXPECT_GT(red.r, bluish.r + 10);
    EXPECT_NEAR(red.b, bluish.b, 1);
    light["intensity"] = 0.25;
    save();
    EXPECT_LT(meanOfTestFrame(path("lit.gltf")).b, red.b - 10);

    json["nodes"].push_back(
        {{"name", "probe"},
         {"translation", {0, 1, 0}},
         {"extras",
          {{"rushlight", {{"reflectionProbe", {{"size", {20, 20, 20}}, {"resolution", 32}}}}}}}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    light["intensity"] = 1;
    save();
    EXPECT_GT(glm::length(meanOfTestFrame(path("lit.gltf")) - red), 0.5f);
}

TEST_F(SurroundingsCli, AreaLightsOfNodesShineForwards) {
    const auto place = [&](const char* turn, const Json& scale) {
        json["nodes"].push_back(
            {{"name", "window"},
             {"translation", {0, 6, 0}},
             {"rotation", Json::parse(turn)},
             {"scale", scale},
             {"extras",
              {{"rushlight",
                {{"areaLight", {{"shape", "rectangle"}, {"size", {4, 4}}, {"luminance", 20}}}}}}}});
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        save();
        json["scenes"][0]["nodes"].erase(json["scenes"][0]["nodes"].size() - 1);
        json["nodes"].erase(json["nodes"].size() - 1);
    };
    save();
    ASSERT_EQ(capture("none.png").code, 0);
    place("[-0.70710678, 0, 0, 0.70710678]", {1, 1, 1});  // -z turned to -y
    ASSERT_EQ(capture("down.png").code, 0);
    EXPECT_NE(fidelity().find("area lights of extras.rushlight"), std::string::npos);
    EXPECT_FALSE(bytes("down.png") == bytes("none.png"));
    place("[0.70710678, 0, 0, 0.70710678]", {1, 1, 1});
    ASSERT_EQ(capture("up.png").code, 0);
    EXPECT_TRUE(bytes("up.png") == bytes("none.png")) << "nothing is above it";
    place("[-0.70710678, 0, 0, 0.70710678]", {1, 0, 1});
    const Ended flat = capture("flat.png");
    ASSERT_EQ(flat.code, 0) << flat.errors;
    EXPECT_NE(fidelity().find("The area light of node"), std::string::npos) << fidelity();
    EXPECT_TRUE(bytes("flat.png") == bytes("none.png"));
}

}  // namespace
}  // namespace rushlight
