// The test card: everything that a frame can hold, small enough to be rendered by every test.

#include "content/generator/square.h"

namespace rushlight::content {

using Json = nlohmann::ordered_json;

namespace {

Json plain(const std::string& name, const vec4& color, float metallic, float roughness) {
    const auto number = [](float x) { return std::floor(double(x) * 1e4 + 0.5) / 1e4; };
    return {
        {"name", name},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {number(color.x), number(color.y), number(color.z), number(color.w)}},
          {"metallicFactor", number(metallic)},
          {"roughnessFactor", number(roughness)}}}};
}

MeshBuilder sphere(float radius, int segments) {
    MeshBuilder b;
    b.use(Mat::bulbWarm);
    Profile profile;
    const int rings = segments / 2;
    for (int i = 0; i <= rings; ++i) {
        const double t = 0.5 * i / rings;
        profile.push_back({i == 0 || i == rings ? 0.0f : radius * float(sinTurns(t)),
                           -radius * float(cosTurns(t))});
    }
    b.lathe(profile, segments);
    return b;
}

MeshBuilder checker(int parity) {
    MeshBuilder b;
    b.use(Mat::bulbWarm);
    for (int z = -5; z < 5; ++z)
        for (int x = -5; x < 5; ++x) {
            if ((x + z + 10) % 2 != parity) continue;
            const float x0 = float(x), z0 = float(z);
            b.quad({x0, 0, z0 + 1}, {x0 + 1, 0, z0 + 1}, {x0 + 1, 0, z0}, {x0, 0, z0});
        }
    return b;
}

}  // namespace

Document buildTestCard() {
    Document d("testcard");
    d.addCamera("card", {0.0f, 2.2f, 7.4f}, {0.0f, 0.85f, 0.0f}, 42);
    const int sun = d.addNode(
        "sun", -1,
        {{0, 5, 0}, rotationTurns({0, 1, 0}, 0.09) * rotationTurns({1, 0, 0}, -0.13), vec3(1)});
    d.addLight(sun, {LightSpec::Kind::sun, {1.0f, 0.94f, 0.86f}, 2.6f});
    const int lamp = d.addNode("lamp", -1, at({-2.9f, 1.9f, 1.4f}));
    d.addLight(lamp, {LightSpec::Kind::point, {1.0f, 0.55f, 0.25f}, 7, 9});

    const float dark = 0.10f, bright = 0.55f;
    d.addNode(
        "floor.dark", -1, at(vec3(0)),
        d.addMeshWith(d.addPart("floor.dark", checker(0)),
                      d.addPlainMaterial(plain("floor.dark", {dark, dark, dark, 1}, 0, 0.45f)),
                      "floor.dark"));
    d.addNode("floor.bright", -1, at(vec3(0)),
              d.addMeshWith(
                  d.addPart("floor.bright", checker(1)),
                  d.addPlainMaterial(plain("floor.bright", {bright, bright, bright, 1}, 0, 0.7f)),
                  "floor.bright"));

    const int ball = d.addPart("sphere", sphere(0.42f, 32));
    for (int i = 0; i < 5; ++i) {
        const float rough = 0.05f + 0.225f * float(i), x = -2.2f + 1.1f * float(i);
        const std::string n = std::to_string(i + 1);
        const int metal = d.addPlainMaterial(
            plain("metal." + n, {0.95f, 0.72f, 0.38f, 1}, 1, rough));
        const int plastic = d.addPlainMaterial(
            plain("dielectric." + n, {0.62f, 0.10f, 0.09f, 1}, 0, rough));
        d.addNode("sphere.metal." + n, -1, at({x, 0.42f, -0.5f}),
                  d.addMeshWith(ball, metal, "sphere.metal." + n));
        d.addNode("sphere.dielectric." + n, -1, at({x, 1.52f, -0.9f}),
                  d.addMeshWith(ball, plastic, "sphere.dielectric." + n));
    }

    Json glow = plain("emissive", {0.1f, 0.1f, 0.1f, 1}, 0, 0.6f);
    glow["emissiveFactor"] = {0.35, 0.8, 1.0};
    glow["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 4.0;
    d.addNode("sphere.emissive", -1, at({2.95f, 0.32f, 0.9f}, 0, 0.6f),
              d.addMeshWith(ball, d.addPlainMaterial(glow), "sphere.emissive"));

    MeshBuilder pane;
    pane.use(Mat::bulbWarm).box({-0.65f, 0.02f, -0.02f}, {0.65f, 1.25f, 0.02f});
    Json glass = plain("pane", {0.25f, 0.65f, 0.45f, 0.4f}, 0, 0.1f);
    glass["alphaMode"] = "BLEND";
    d.addNode("pane", -1, at({1.45f, 0, 1.25f}, 0.04),
              d.addMeshWith(d.addPart("pane", pane), d.addPlainMaterial(glass), "pane"));

    MeshBuilder card;
    card.use(Mat::leaf).card({-0.6f, 0, 0}, {0.6f, 0, 0}, {0.6f, 1.2f, 0}, {-0.6f, 1.2f, 0});
    const int leafPicture = d.texture("mask");
    Json leaf = plain("mask", {1, 1, 1, 1}, 0, 0.7f);
    leaf["pbrMetallicRoughness"]["baseColorTexture"]["index"] = leafPicture;
    leaf["alphaMode"] = "MASK";
    leaf["alphaCutoff"] = 0.5;
    leaf["doubleSided"] = true;
    d.addNode("card", -1, at({-1.5f, 0, 1.3f}, -0.04),
              d.addMeshWith(d.addPart("card", card), d.addPlainMaterial(leaf), "card"));
    return d;
}

}  // namespace rushlight::content
