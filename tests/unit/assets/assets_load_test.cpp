// What loading makes of a valid file.
#include "tests/unit/assets/small_gltf.h"

namespace rushlight::test {
namespace {

using assets::loadModel;
using assets::Model;

Model mustLoad(SmallGltf& gltf, const TempFolder& folder) {
    auto model = loadModel(gltf.save(folder));
    EXPECT_TRUE(model.has_value()) << model.error().text();
    return model ? std::move(*model) : Model();
}

TEST(AssetsLoad, EverythingOfTheFullTriangle) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    const Model model = mustLoad(gltf, folder);
    ASSERT_EQ(model.geometries.size(), 1u);
    const assets::Geometry& geometry = model.geometries[0];
    EXPECT_EQ(geometry.positions[1], vec3(1, 0, 0));
    EXPECT_EQ(geometry.normals[2], vec3(0, 0, 1));
    EXPECT_EQ(geometry.uv0[2], vec2(0, 1));
    EXPECT_EQ(geometry.skin[0].weights, vec4(0.5f, 0.5f, 0, 0));
    EXPECT_EQ(geometry.skin[0].joints[1], 1);
    EXPECT_EQ(geometry.morphTargets[0].positions[0], vec3(0, 0, 1));
    EXPECT_EQ(geometry.bounds.high, vec3(1, 1, 0));
    EXPECT_EQ(model.materials[0].roughness, 0.5f);
    EXPECT_EQ(model.nodes[2].parent, 1);
    EXPECT_EQ(model.roots, (std::vector<int>{0, 1, 3}));
    EXPECT_EQ(model.skins[0].inverseBindMatrices[1][3], vec4(0, -1, 0, 1));
    EXPECT_EQ(model.animations[0].duration, 3);
    EXPECT_TRUE(model.fidelity.unsupported.empty());
}

TEST(AssetsLoad, MissingNormalsBecomeFlat) {
    const TempFolder folder;
    SmallGltf gltf;
    const int position = gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int indices = gltf.add<uint8_t>({0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 1);
    gltf.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", indices}}}}}};
    const Model model = mustLoad(gltf, folder);
    const assets::Geometry& geometry = model.geometries[0];
    ASSERT_EQ(geometry.positions.size(), 6u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(geometry.normals[size_t(i)], vec3(0, 0, 1));
    for (int i = 3; i < 6; ++i) EXPECT_EQ(geometry.normals[size_t(i)], vec3(1, 0, 0));
}

TEST(AssetsLoad, StripsAndFans) {
    for (const auto& [mode, expected] : {std::pair{5, std::vector<uint32_t>{0, 1, 2, 1, 3, 2}},
                                         std::pair{6, std::vector<uint32_t>{1, 2, 0, 2, 3, 0}}}) {
        const TempFolder folder;
        SmallGltf gltf;
        const int position = gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
        const int normal = gltf.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
        gltf.json["meshes"] = {
            {{"primitives",
              {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"mode", mode}}}}}};
        EXPECT_EQ(mustLoad(gltf, folder).geometries[0].indices, expected) << "mode " << mode;
    }
}

TEST(AssetsLoad, PointsAreListedAndLeftOut) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["meshes"][0]["primitives"][0]["mode"] = 0;
    const Model model = mustLoad(gltf, folder);
    EXPECT_TRUE(model.meshes[0].primitives.empty());
    ASSERT_EQ(model.fidelity.unsupported.size(), 1u);
    EXPECT_EQ(model.fidelity.unsupported[0],
              "mesh 0 'roof' primitive 0: primitive mode points (left out)");
}

TEST(AssetsLoad, SameAccessorsShareOneGeometry) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    Json other = gltf.json["meshes"][0];
    other["primitives"][0].erase("material");
    gltf.json["meshes"].push_back(other);
    const Model model = mustLoad(gltf, folder);
    EXPECT_EQ(model.geometries.size(), 1u);
    EXPECT_EQ(model.meshes[1].primitives[0].geometry, 0);
    EXPECT_EQ(model.meshes[1].primitives[0].material, -1);
}

TEST(AssetsLoad, SparseValuesReplaceAndZerosFill) {
    const TempFolder folder;
    SmallGltf gltf;
    const int base = gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int at = gltf.add<uint16_t>({2}, 5123, "SCALAR", 1);
    const int value = gltf.add<float>({0, 5, 0}, 5126, "VEC3", 3);
    const Json sparse = {{"count", 1},
                         {"indices", {{"bufferView", at}, {"componentType", 5123}}},
                         {"values", {{"bufferView", value}}}};
    gltf.json["accessors"][size_t(base)]["sparse"] = sparse;
    gltf.json["accessors"].push_back({{"componentType", 5126},
                                      {"count", 3},
                                      {"type", "VEC3"},
                                      {"sparse", sparse},
                                      {"min", {0, 0, 0}},
                                      {"max", {0, 5, 0}}});
    const auto mesh = [](int position) {
        return Json{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}};
    };
    gltf.json["meshes"] = {mesh(base), mesh(3)};
    const Model model = mustLoad(gltf, folder);
    EXPECT_EQ(model.geometries[0].positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}}));
    EXPECT_EQ(model.geometries[1].positions, (std::vector<vec3>{{0, 0, 0}, {0, 0, 0}, {0, 5, 0}}));
}

TEST(AssetsLoad, NormalisedAndStridedColours) {
    const TempFolder folder;
    SmallGltf gltf;
    const int position = gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int color = gltf.add<uint8_t>({255, 0, 51, 9, 0, 255, 102, 9, 0, 0, 255, 9}, 5121, "VEC3",
                                        4);
    gltf.json["bufferViews"][size_t(color)]["byteStride"] = 4;
    gltf.json["accessors"][size_t(color)]["normalized"] = true;
    gltf.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", position}, {"COLOR_0", color}}}}}}}};
    const Model model = mustLoad(gltf, folder);
    ASSERT_EQ(model.geometries[0].colors.size(), 3u);
    EXPECT_EQ(model.geometries[0].colors[0], vec4(1, 0, 0.2f, 1));
    EXPECT_EQ(model.geometries[0].colors[1], vec4(0, 1, 0.4f, 1));
}

TEST(AssetsLoad, SamplersKeepEachAxisAndFilter) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["images"] = {
        {{"uri",
          "data:image/"
          "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/"
          "pLvAAAAAElFTkSuQmCC"}}};
    gltf.json["samplers"] = {
        {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Model model = mustLoad(gltf, folder);
    const assets::Sampler& sampler = model.materials.at(0).baseColorTexture.sampler;
    EXPECT_EQ(sampler.wrapU, assets::Wrap::clampToEdge);
    EXPECT_EQ(sampler.wrapV, assets::Wrap::mirroredRepeat);
    EXPECT_EQ(sampler.magnify, assets::Filter::nearest);
    EXPECT_EQ(sampler.minify, assets::Filter::linear);
    EXPECT_EQ(sampler.mipmap, assets::Filter::nearest);
    EXPECT_TRUE(sampler.useMipmaps);
}

// glTF 2.0, section 3.6.2.2: c / 127 and c / 32767, and what is lower is -1.
TEST(AssetsLoad, NormalisedSignedIntegers) {
    const auto rotations = [](auto values, int componentType) {
        const TempFolder folder;
        SmallGltf gltf = fullTriangle();
        const int output = gltf.add(values, componentType, "VEC4", 4);
        gltf.json["accessors"][size_t(output)]["normalized"] = true;
        Json& animation = gltf.json["animations"][0];
        animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                         {"target", {{"node", 2}, {"path", "rotation"}}}});
        animation["samplers"].push_back({{"input", 7}, {"output", output}});
        const Model model = mustLoad(gltf, folder);
        return model.animations[0].channels.back().values;
    };
    const auto bytes = rotations(std::vector<int8_t>{0, 0, 0, 127, -128, 0, 0, 64, -127, 1, 0, 0},
                                 5120);
    const auto shorts = rotations(
        std::vector<int16_t>{0, 0, 0, 32767, -32768, 0, 0, 16384, -32767, 1, 0, 0}, 5122);
    ASSERT_EQ(bytes.size(), 12u);
    ASSERT_EQ(shorts.size(), 12u);
    for (const auto* values : {&bytes, &shorts}) {
        const bool isByte = values == &bytes;
        const float most = isByte ? 127 : 32767;
        EXPECT_EQ((*values)[3], 1);
        EXPECT_EQ((*values)[4], -1);
        EXPECT_EQ((*values)[7], (isByte ? 64 : 16384) / most);
        EXPECT_EQ((*values)[8], -1);
        EXPECT_EQ((*values)[9], 1 / most);
    }
}

TEST(AssetsLoad, UrisAreDecoded) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    folder.write("my data.bin", gltf.bytes);
    gltf.json["buffers"][0]["uri"] = "my%20data.bin";
    EXPECT_EQ(mustLoad(gltf, folder).geometries.size(), 1u);
}

TEST(AssetsLoad, LightsAndTheirNodes) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["extensionsUsed"] = {"KHR_lights_punctual"};
    gltf.json["extensions"] = Json::parse(
        R"({"KHR_lights_punctual":{"lights":[{"type":"spot","color":[1,0.5,0],"intensity":7,"range":3,
            "spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}},{"type":"directional"}]}})");
    gltf.json["nodes"][3]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    const Model model = mustLoad(gltf, folder);
    ASSERT_EQ(model.lights.size(), 2u);
    EXPECT_EQ(model.lights[0].type, assets::LightType::spot);
    EXPECT_EQ(model.lights[0].color, vec3(1, 0.5f, 0));
    EXPECT_EQ(model.lights[0].outerConeAngle, 0.4f);
    EXPECT_EQ(model.lights[1].intensity, 1);
    EXPECT_EQ(model.nodes[3].light, 1);
    EXPECT_EQ(model.fidelity.exact, (std::vector<std::string>{"KHR_lights_punctual"}));
}

TEST(AssetsLoad, InstancesBecomeNodes) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    const int places = gltf.add<float>({1, 2, 3, 4, 5, 6}, 5126, "VEC3", 3);
    gltf.json["nodes"][3]["mesh"] = 0;
    gltf.json["nodes"][3]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        places;
    const Model model = mustLoad(gltf, folder);
    ASSERT_EQ(model.nodes.size(), 6u);
    EXPECT_EQ(model.nodes[3].mesh, -1);
    EXPECT_EQ(model.nodes[3].children, (std::vector<int>{4, 5}));
    EXPECT_EQ(model.nodes[5].translation, vec3(4, 5, 6));
    EXPECT_EQ(model.nodes[5].mesh, 0);
}

TEST(AssetsLoad, MissingImagesAreRefusedOrReplaced) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["images"] = {{{"uri", "brick.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    const auto path = gltf.save(folder);
    const auto refused = loadModel(path);
    ASSERT_FALSE(refused.has_value());
    EXPECT_NE(refused.error().message.find("image 'brick.png'"), std::string::npos);
    const auto replaced = loadModel(path, {.missingImages = assets::MissingImages::replace});
    ASSERT_TRUE(replaced.has_value()) << replaced.error().text();
    EXPECT_EQ(replaced->warnings.size(), 1u);
    EXPECT_TRUE(replaced->images[0].isColor);
    EXPECT_EQ(replaced->images[0].pixels.size(),
              replaced->images[0].width * replaced->images[0].height * 4);
}

TEST(AssetsLoad, FilesThatAModelIsMadeOf) {
    const TempFolder folder;
    SmallGltf gltf = fullTriangle();
    gltf.json["images"] = {{{"uri", "b%20c.png"}},      {{"uri", "sub/a.png"}},
                           {{"uri", "b%20c.png"}},      {{"uri", "data:image/png;base64,AAAA"}},
                           {{"uri", "../outside.png"}}, {{"uri", "http://example.org/x.png"}},
                           {{"uri", "bad%2.png"}}};
    gltf.json["extensions"]["ANY_extension"]["profiles"] = {{{"uri", "lamp.ies"}}};
    const auto path = gltf.save(folder);
    std::vector<std::string> names;
    for (const auto& file : assets::namedFiles(path)) {
        EXPECT_TRUE(file.is_absolute());
        names.push_back(file.lexically_relative(std::filesystem::canonical(path.parent_path())));
    }
    std::erase_if(names, [](const std::string& name) { return name.ends_with(".bin"); });
    EXPECT_EQ(names, (std::vector<std::string>{"b c.png", "lamp.ies", "sub/a.png"}));
    EXPECT_TRUE(assets::namedFiles(path.parent_path() / "there is none.gltf").empty());
}

}  // namespace
}  // namespace rushlight::test
