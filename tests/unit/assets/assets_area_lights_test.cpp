// Area lights in the extras of nodes.
#include "tests/unit/assets/small_gltf.h"

namespace rushlight::assets {
namespace {

using test::fullTriangle;
using test::Json;
using test::TempFolder;

TEST(AssetsAreaLights, AreReadFromExtras) {
    const TempFolder folder;
    auto gltf = fullTriangle();
    Json& node = gltf.json["nodes"][3];
    const auto load = [&](const char* light) {
        node["extras"]["rushlight"]["areaLight"] = Json::parse(light);
        return loadModel(gltf.save(folder), {});
    };
    auto model = load(R"({"shape":"rectangle","size":[2,3],"luminance":500,"color":[1,0.5,0],
        "twoSided":true,"range":7})");
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_EQ(model->areaLights.size(), 1u);
    const AreaLight& window = model->areaLights[0];
    EXPECT_EQ(window.node, 3);
    EXPECT_EQ(window.shape, AreaShape::rectangle);
    EXPECT_EQ(window.size, vec2(2, 3));
    EXPECT_EQ(window.luminance, 500);
    EXPECT_EQ(window.color, vec3(1, 0.5f, 0));
    EXPECT_TRUE(window.twoSided);
    EXPECT_EQ(window.range, 7);

    model = load(R"({"shape":"tube","radius":0.02,"length":1.2,"luminance":9000})");
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_EQ(model->areaLights[0].shape, AreaShape::tube);
    EXPECT_EQ(model->areaLights[0].radius, 0.02f);
    EXPECT_EQ(model->areaLights[0].length, 1.2f);
    EXPECT_EQ(model->areaLights[0].color, vec3(1));
    EXPECT_FALSE(model->areaLights[0].twoSided);

    for (const char* bad :
         {R"({})", R"(3)", R"({"shape":"cone","luminance":1})", R"({"shape":"disk","luminance":1})",
          R"({"shape":"disk","size":[1,0],"luminance":1})",
          R"({"shape":"disk","size":[1],"luminance":1})", R"({"shape":"rectangle","size":[1,1]})",
          R"({"shape":"sphere","luminance":1})", R"({"shape":"sphere","radius":1,"luminance":-1})",
          R"({"shape":"tube","radius":1,"luminance":1})",
          R"({"shape":"sphere","radius":1,"luminance":1,"color":[2,0,0]})",
          R"({"shape":"sphere","radius":1,"luminance":1,"twoSided":1})"}) {
        model = load(bad);
        ASSERT_FALSE(model) << bad;
        EXPECT_NE(model.error().text().find("areaLight"), std::string::npos)
            << model.error().text();
    }
}

}  // namespace
}  // namespace rushlight::assets
