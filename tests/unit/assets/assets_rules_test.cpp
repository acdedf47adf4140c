// Each rule that a file can break, one by one: the unbroken file loads, the broken one is refused
// for that reason.
#include "tests/unit/assets/small_gltf.h"

#include <cstdint>
#include <limits>

namespace rushlight::test {
namespace {

using assets::loadModel;

struct Rule {
    const char* pointer;  ///< JSON pointer to what is replaced; "" patches nothing
    const char* value;    ///< JSON; "-" erases
    const char* reason;   ///< part of the message
};

void expectRefused(const std::vector<Rule>& rules) {
    for (const Rule& rule : rules) {
        SCOPED_TRACE(std::string(rule.pointer) + " = " + rule.value);
        const TempFolder folder;
        SmallGltf gltf = fullTriangle();
        const Json::json_pointer pointer(rule.pointer);
        if (std::string(rule.value) == "-")
            gltf.json.at(pointer.parent_pointer()).erase(pointer.back());
        else
            gltf.json[pointer] = Json::parse(rule.value);
        const auto model = loadModel(gltf.save(folder));
        ASSERT_FALSE(model.has_value());
        EXPECT_NE(model.error().message.find(rule.reason), std::string::npos)
            << model.error().message;
        EXPECT_EQ(model.error().kind, ErrorKind::badInput);
    }
}

TEST(AssetsRules, TheUnbrokenFileLoads) {
    const TempFolder folder;
    const auto model = loadModel(fullTriangle().save(folder), {.strict = true});
    ASSERT_TRUE(model.has_value()) << model.error().text();
}

TEST(AssetsRules, Asset) {
    expectRefused(
        {{"/asset", "-", "asset"},
         {"/asset/version", "-", "version"},
         {"/asset/version", "\"1.0\"", "1.0"},
         {"/asset/version", "\"two\"", "not of the form"},
         {"/asset/minVersion", "\"2.1\"", "2.1"},
         {"/extensionsRequired", "[\"KHR_nothing\"]", "uses KHR_nothing, which is not supported"},
         {"/extensionsRequired", "[\"KHR_draco_mesh_compression\"]",
          "uses KHR_draco_mesh_compression, which is not supported"}});
}

TEST(AssetsRules, BuffersAndViews) {
    expectRefused(
        {{"/buffers/0/uri", "\"../a.bin\"", "out of the folder"},
         {"/buffers/0/uri", "\"/etc/passwd\"", "absolute"},
         {"/buffers/0/uri", "\"http://example.com/a.bin\"", "scheme"},
         {"/buffers/0/uri", "\"a%2\"", "escape"},
         {"/buffers/0/uri", "\"missing.bin\"", "does not exist"},
         {"/buffers/0/uri", "\"data:application/octet-stream;base64,AAA\"", "bytes are there"},
         {"/buffers/0/uri", "\"data:application/octet-stream;base64,A*==\"", "base64"},
         {"/bufferViews/0/byteLength", "99999", "ends at byte"},
         {"/bufferViews/0/byteOffset", "18446744073709551615", "byteOffset"},
         {"/bufferViews/0/byteStride", "6", "multiple of four"},
         {"/bufferViews/0/byteStride", "256", "byteStride"},
         {"/bufferViews/0/buffer", "7", "only 1"}});
}

TEST(AssetsRules, Accessors) {
    expectRefused({{"/accessors/0/count", "4", "needs 48 bytes"},
                   {"/accessors/0/count", "4294967295", "limit"},
                   {"/accessors/0/count", "0", "count"},
                   {"/accessors/0/componentType", "5124", "componentType"},
                   {"/accessors/0/type", "\"VEC5\"", "VEC5"},
                   {"/accessors/0/byteOffset", "2", "multiple"},
                   {"/accessors/0/bufferView", "99", "bufferView"},
                   {"/accessors/0/min", "[0,0]", "min"},
                   {"/accessors/0/min", "-", "minimum and maximum"},
                   {"/accessors/0/normalized", "true", "normalised"},
                   {"/bufferViews/0/byteStride", "8", "byteStride"}});
}

// Three columns of three bytes begin at multiples of four: two such matrices take 23 bytes.
TEST(AssetsRules, ColumnsOfSmallMatricesArePadded) {
    for (const size_t bytes : {18u, 22u, 23u}) {
        const TempFolder folder;
        SmallGltf gltf = fullTriangle();
        const int accessor = gltf.add(std::vector<uint8_t>(bytes), 5121, "MAT3", 9);
        gltf.json["accessors"][size_t(accessor)]["count"] = 2;
        const auto model = assets::loadModel(gltf.save(folder));
        ASSERT_EQ(model.has_value(), bytes == 23) << bytes;
        if (model) continue;
        EXPECT_NE(model.error().text().find("needs 23 bytes"), std::string::npos)
            << model.error().text();
    }
}

TEST(AssetsRules, SparseAccessors) {
    const char* sparse = "/accessors/0/sparse";
    expectRefused(
        {{sparse,
          R"({"count":9,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":1}})",
          "not from 1 to 3"},
         {sparse,
          R"({"count":3,"indices":{"bufferView":4,"componentType":5121},"values":{"bufferView":1}})",
          "index 2 is 0 after 1"},
         {sparse,
          R"({"count":3,"indices":{"bufferView":5,"componentType":5125},"values":{"bufferView":1}})",
          "must increase"},
         {sparse,
          R"({"count":1,"indices":{"bufferView":3,"componentType":5126},"values":{"bufferView":1}})",
          "componentType"},
         {sparse,
          R"({"count":3,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":3}})",
          "values"}});
}

// Of three elements, 3 is one too high.
TEST(AssetsRules, ASparseIndexIsBelowTheCount) {
    for (const uint16_t last : {2, 3}) {
        const TempFolder folder;
        SmallGltf gltf = fullTriangle();
        gltf.add<uint16_t>({0, 1, last}, 5123, "SCALAR", 1);
        const size_t view = gltf.json["bufferViews"].size() - 1;
        gltf.json["accessors"][0]["sparse"] = {
            {"count", 3},
            {"indices", {{"bufferView", view}, {"componentType", 5123}}},
            {"values", {{"bufferView", 0}}}};
        const auto model = assets::loadModel(gltf.save(folder));
        ASSERT_EQ(model.has_value(), last == 2) << (model ? "" : model.error().text());
        if (model) continue;
        EXPECT_NE(model.error().text().find("is 3 after 1"), std::string::npos)
            << model.error().text();
    }
}

TEST(AssetsRules, Primitives) {
    const char* attributes = "/meshes/0/primitives/0/attributes";
    expectRefused(
        {{"/accessors/1/count", "2", "attribute NORMAL has 2 elements but POSITION has 3"},
         {"/meshes/0/primitives/0/indices", "0", "unsigned integers"},
         {"/meshes/0/primitives/0/indices", "42", "indices"},
         {"/meshes/0/primitives/0/mode", "7", "mode"},
         {"/meshes/0/primitives/0/material", "3", "material"},
         {"/meshes/0/primitives", "[]", "empty"},
         {attributes, "{}", "none"},
         {attributes, R"({"POSITION":0,"NORMAL":2})", "components"},
         {attributes, R"({"POSITION":0,"NORMALS":1})", "none that glTF"},
         {attributes, R"({"POSITION":0,"TEXCOORD_1":2})", "numbered"},
         {attributes, R"({"POSITION":0,"JOINTS_0":4})", "WEIGHTS"},
         {"/meshes/0/primitives/0/targets/0", R"({"TANGENT":9})", "does not have"},
         {"/meshes/0/weights", "[1,2]", "weights"}});
}

TEST(AssetsRules, IndexValues) {
    for (const uint16_t bad : {uint16_t(3), uint16_t(0xffff)}) {
        const TempFolder folder;
        SmallGltf gltf = fullTriangle();
        const size_t at = gltf.json["bufferViews"][3]["byteOffset"];
        std::memcpy(&gltf.bytes[at + 4], &bad, 2);
        const auto model = loadModel(gltf.save(folder));
        ASSERT_FALSE(model.has_value());
        EXPECT_NE(model.error().message.find("mesh 0 'roof' primitive 0: index 2 is "),
                  std::string::npos)
            << model.error().message;
    }
}

TEST(AssetsRules, NumbersThatAreNotFinite) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    const float bad = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(&gltf.bytes[4], &bad, 4);
    const auto model = loadModel(gltf.save(folder));
    ASSERT_FALSE(model.has_value());
    EXPECT_NE(model.error().message.find("not finite"), std::string::npos);
}

TEST(AssetsRules, NodesAndScenes) {
    expectRefused({{"/nodes/2/children", "[1]", "own ancestor"},
                   {"/nodes/0/children", "[2]", "as a child"},
                   {"/nodes/1/children", "[2,2]", "twice"},
                   {"/nodes/1/children", "[77]", "only 4"},
                   {"/nodes/0/mesh", "1", "mesh"},
                   {"/nodes/0/skin", "1", "skin"},
                   {"/nodes/3/camera", "1", "camera"},
                   {"/nodes/3/rotation", "[0,0,0,0.5]", "quaternion"},
                   {"/nodes/3/rotation", "[0,0,1]", "instead of 4"},
                   {"/nodes/2/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", "both a matrix"},
                   {"/nodes/3/scale", "[1,1,1e300]", "out of range"},
                   {"/scenes/0/nodes", "[2]", "no root"},
                   {"/scene", "1", "scene"}});
}

TEST(AssetsRules, MaterialsTexturesCamerasLights) {
    expectRefused(
        {{"/materials/0/pbrMetallicRoughness/roughnessFactor", "1.5", "out of range"},
         {"/materials/0/pbrMetallicRoughness/baseColorFactor", "[1,1,1]", "instead of 4"},
         {"/materials/0/alphaMode", "\"GLASS\"", "GLASS"},
         {"/materials/0/normalTexture", "{\"index\":0}", "only 0"},
         {"/materials/0/emissiveFactor", "[2,0,0]", "out of range"},
         {"/samplers", "[{\"wrapS\":1}]", "wrapS"},
         {"/samplers", "[{\"magFilter\":9984}]", "magFilter"},
         {"/images", "[{\"bufferView\":0}]", "mimeType"},
         {"/images", "[{}]", "either a uri or a bufferView"},
         {"/cameras/0/perspective/znear", "0", "out of range"},
         {"/cameras/0/perspective/zfar", "0.05", "beyond"},
         {"/cameras/0/type", "\"fisheye\"", "fisheye"},
         {"/extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"area"}]}})", "area"},
         {"/extensions",
          R"({"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{"innerConeAngle":1,"outerConeAngle":0.5}}]}})",
          "below its outerConeAngle"},
         {"/nodes/3/extensions", R"({"KHR_lights_punctual":{"light":0}})", "only 0"}});
}

TEST(AssetsRules, SkinsAndAnimations) {
    expectRefused({{"/skins/0/joints", "[1]", "uses joint 1"},
                   {"/skins/0/joints", "[1,1]", "twice"},
                   {"/skins/0/joints", "[0,1,2]", "inverse bind matrices"},
                   {"/skins/0/inverseBindMatrices", "0", "4 x 4"},
                   {"/animations/0/samplers/0/input", "0", "times"},
                   {"/animations/0/samplers/0/output", "2", "type"},
                   {"/animations/0/samplers/0/interpolation", "\"SPLINE\"", "SPLINE"},
                   {"/animations/0/samplers/0/interpolation", "\"CUBICSPLINE\"", "instead of 27"},
                   {"/accessors/8/count", "2", "instead of 9"},
                   {"/animations/0/channels/0/sampler", "1", "sampler"},
                   {"/animations/0/channels/0/target/path", "\"colour\"", "colour"},
                   {"/animations/0/channels/0/target/node", "9", "node"}});
}

TEST(AssetsRules, AnimationTimesIncrease) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    const float same = 0;
    std::memcpy(&gltf.bytes[gltf.json["bufferViews"][7]["byteOffset"].get<size_t>() + 4], &same, 4);
    const auto model = loadModel(gltf.save(folder));
    ASSERT_FALSE(model.has_value());
    EXPECT_NE(model.error().message.find("increasing"), std::string::npos);
}

TEST(AssetsRules, BinaryContainer) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["buffers"][0]["byteLength"] = gltf.bytes.size();
    const std::string good = gltf.glb();
    ASSERT_TRUE(loadModel(folder.write("good.glb", good)).has_value());
    const auto refused = [&](std::string bytes, const char* reason) {
        const auto model = loadModel(folder.write("bad.glb", bytes));
        ASSERT_FALSE(model.has_value()) << reason;
        EXPECT_NE(model.error().message.find(reason), std::string::npos) << model.error().message;
    };
    refused("", "empty");
    refused(gltf.glb(1), "version 1");
    refused(good.substr(0, good.size() - 4), "the file has");
    refused(good + "0000", "the file has");
    refused("glTF", "cut short");
    std::string wrongMagic = good, wrongLength = good, wrongChunk = good;
    wrongMagic[0] = 'x';
    refused(wrongMagic, "magic");
    wrongLength[15] = '\x7f';
    refused(wrongLength, "bytes follow");
    wrongChunk[16] = 'X';
    refused(wrongChunk, "not JSON");
}

TEST(AssetsRules, JsonText) {
    const TempFolder folder;
    const auto refused = [&](const std::string& text, const char* reason) {
        const auto model = loadModel(folder.write("a.gltf", text));
        ASSERT_FALSE(model.has_value()) << text.substr(0, 60);
        EXPECT_NE(model.error().message.find(reason), std::string::npos) << model.error().message;
    };
    refused("{", "parsed");
    refused("[]", "not a JSON object");
    refused("{\"asset\":{\"version\":\"2.0\"},\"asset\":{}}", "twice");
    refused("\xef\xbb\xbf{\"asset\":{\"version\":\"2.0\"}}", "byte order mark");
    refused(std::string(100000, '['), "nested");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":3}", "not an array");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[3]}", "not a JSON object");
}

TEST(AssetsRules, StrictRefusesWhatIsNotExact) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["materials"][0]["extensions"]["KHR_materials_clearcoat"] = Json::object();
    const auto path = gltf.save(folder);
    const auto model = loadModel(path);
    ASSERT_TRUE(model.has_value()) << model.error().text();
    ASSERT_EQ(model->fidelity.unsupported.size(), 1u);
    EXPECT_EQ(model->fidelity.unsupported[0], "material 0 'brick': KHR_materials_clearcoat");
    EXPECT_FALSE(loadModel(path, {.strict = true}).has_value());
}

TEST(AssetsRules, SymbolicLinksDoNotLeadOut) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["buffers"][0]["uri"] = "link.bin";
    std::filesystem::create_symlink("/etc/passwd", folder.path() / "link.bin");
    const auto model = loadModel(gltf.save(folder));
    ASSERT_FALSE(model.has_value());
    EXPECT_NE(model.error().message.find("out of the folder"), std::string::npos);
}

}  // namespace
}  // namespace rushlight::test
