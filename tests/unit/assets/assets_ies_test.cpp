// IES files: every form that can be read, and what is refused.
#include "engine/assets/ies.h"
#include "tests/unit/assets/small_gltf.h"

#include <algorithm>
#include <cmath>

namespace rushlight::test {
namespace {

using assets::LightProfile;
using assets::loadModel;
using assets::luminousFlux;
using assets::parseIes;

/// An even light of 100 candela in steps of 45 degrees.
std::string evenFile(const std::string& horizontals, int count,
                     const std::string& head = "IESNA:LM-63-2002\r\n") {
    std::string text = head + "TILT=NONE\r\n1 -1 1 5 " + std::to_string(count) +
                       " 1 2 0 0 0\r\n1 1 40\r\n0 45 90 135 180\r\n" + horizontals + "\r\n";
    for (int i = 0; i < count; ++i) text += "100 100 100 100 100\r\n";
    return text;
}

LightProfile mustParse(const std::string& text) {
    const auto profile = parseIes("test.ies", text);
    EXPECT_TRUE(profile) << profile.error().text();
    return profile ? *profile : LightProfile();
}

std::string problemOf(const std::string& text) {
    const auto profile = parseIes("test.ies", text);
    EXPECT_FALSE(profile) << text;
    return profile ? std::string() : profile.error().text();
}

TEST(Ies, EveryEditionIsRead) {
    for (const char* head :
         {"", "A lamp of 1986\nwith free text\n", "IESNA91\n[TEST] 1\n[MANUFAC] someone\n",
          "IESNA:LM-63-1995\n[TEST] 1\n", "IESNA:LM-63-2002\n[TEST] 1\n[MORE] and more\n",
          "IES:LM-63-2019\n"}) {
        const LightProfile profile = mustParse(evenFile("0", 1, head));
        EXPECT_EQ(profile.verticalAngles, (std::vector<float>{0, 45, 90, 135, 180})) << head;
        EXPECT_EQ(profile.candela.size(), 5u) << head;
        EXPECT_EQ(profile.largestCandela, 100) << head;
    }
}

TEST(Ies, EverySymmetryHasTheSameFlux) {
    for (const auto& [angles, count] :
         {std::pair("0", 1), std::pair("0 90", 2), std::pair("0 60 90", 3),
          std::pair("0 90 180", 3), std::pair("90 180 270", 3), std::pair("0 90 180 270 360", 5)}) {
        const LightProfile profile = mustParse(evenFile(angles, count));
        EXPECT_EQ(profile.horizontalAngles.size(), size_t(count)) << angles;
        EXPECT_NEAR(luminousFlux(profile), 4 * 3.14159265358979 * 100, 0.01) << angles;
    }
}

TEST(Ies, CandelaIsMultipliedAndFluxIsItsIntegral) {
    // A Lambertian emitter of 400 candela gives 400 pi lumens; here 100 times 2 times 2.
    std::string text = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 2 91 1 1 2 0 0 0\n2 1 40\n";
    for (int i = 0; i <= 90; ++i) text += std::to_string(i) + (i % 7 ? " " : "\n");
    text += "\n0\n";
    for (int i = 0; i <= 90; ++i)
        text += std::to_string(100 * std::cos(i * 3.14159265358979 / 180)) + ",";
    const LightProfile profile = mustParse(text);
    EXPECT_NEAR(profile.candela[0], 400, 1e-3);
    EXPECT_NEAR(profile.candela[60], 200, 1e-3);
    EXPECT_NEAR(luminousFlux(profile), 400 * 3.14159265358979, 1.0);
}

TEST(Ies, TiltFactorsAreSkippedAndNumbersMayBreakAnywhere) {
    const LightProfile profile = mustParse(
        "IESNA:LM-63-1995\nTILT=INCLUDE\n1\n3\n0 45 90\n1.0 .9\n.8\n1 -1 +1.5\n2 2 1 1 0\n0 0\n1 1 "
        "1e1\n0 90 0\n90 1\n2 3 4\n\x1a\n");
    EXPECT_EQ(profile.candela, (std::vector<float>{1.5f, 3, 4.5f, 6}));
    EXPECT_EQ(profile.horizontalAngles, (std::vector<float>{0, 90}));
}

/// Of type A or B, 1 candela more each degree of both angles, the horizontal ones ten times so; -90
/// to 90 both ways.
std::string slopedFile(int type, bool mirrored) {
    std::string text = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 7 ";
    text.append(mirrored ? "4 " : "7 ").append(std::to_string(type));
    text += " 2 0 0 0\n1 1 40\n-90 -60 -30 0 30 60 90\n";
    const int first = mirrored ? 0 : -90;
    for (int h = first; h <= 90; h += 30) text.append(std::to_string(h)).append(1, ' ');
    for (int h = first; h <= 90; h += 30)
        for (int v = -90; v <= 90; v += 30)
            text.append(1, '\n').append(std::to_string(1000 + v + 10 * h));
    return text;
}

float candelaOf(const LightProfile& p, float vertical, float horizontal) {
    const auto v = std::ranges::find_if(p.verticalAngles,
                                        [&](float a) { return std::abs(a - vertical) < 1e-3f; });
    const auto h = std::ranges::find(p.horizontalAngles, horizontal);
    EXPECT_TRUE(v != p.verticalAngles.end() && h != p.horizontalAngles.end())
        << vertical << " " << horizontal;
    return p.candela[size_t(h - p.horizontalAngles.begin()) * p.verticalAngles.size() +
                     size_t(v - p.verticalAngles.begin())];
}

TEST(Ies, TypeAHasVerticalPlanesAndItsZeroIsTheHorizon) {
    const LightProfile p = mustParse(slopedFile(3, false));
    EXPECT_EQ(candelaOf(p, 90, 0), 1000);
    EXPECT_EQ(candelaOf(p, 0, 0), 910) << "straight down is -90";
    EXPECT_EQ(candelaOf(p, 120, 60), 1630);
    EXPECT_EQ(candelaOf(p, 120, 300), 430);
    EXPECT_EQ(candelaOf(p, 90, 90), 1900);
    EXPECT_EQ(candelaOf(p, 90, 90.01f), 0) << "it is dark behind";
    EXPECT_EQ(candelaOf(mustParse(slopedFile(3, true)), 120, 300), 1630) << "mirrored";
}

TEST(Ies, TypeBHasPlanesAboutAHorizontalAxisAndItsZeroIsDown) {
    const LightProfile p = mustParse(slopedFile(2, false));
    EXPECT_NEAR(candelaOf(p, 0, 0), 1000, 0.1f);
    EXPECT_NEAR(candelaOf(p, 40, 0), 1040, 0.1f);
    EXPECT_NEAR(candelaOf(p, 40, 90), 1400, 0.1f);
    EXPECT_NEAR(candelaOf(p, 40, 270), 600, 0.1f);
    // sin h = sin 45 sin 30, tan v = tan 45 cos 30
    EXPECT_NEAR(candelaOf(p, 45, 30), 1000 + 40.8934f + 207.0481f, 0.1f);
    EXPECT_NEAR(candelaOf(mustParse(slopedFile(2, true)), 40, 270), 1400, 0.1f) << "mirrored";
    EXPECT_NEAR(luminousFlux(p), 2 * 3.14159265 * 1000, 30)
        << "a half of all around, evenly but for what cancels";
}

TEST(Ies, WhatIsWrongIsSaid) {
    const std::string head = "IESNA:LM-63-2002\nTILT=NONE\n", one = "1 1 40\n";
    const auto expect = [](const std::string& text, const char* part) {
        const std::string problem = problemOf(text);
        EXPECT_NE(problem.find(part), std::string::npos) << problem;
        EXPECT_EQ(problem.rfind("test.ies: ", 0), 0u) << problem;
    };
    expect("", "TILT=");
    expect("hello", "TILT=");
    expect("TILT=other.tlt\n", "other.tlt");
    expect("TILT=INCLUDE\n7\n", "geometry is 7");
    expect(head, "ends before its number of lamps");
    expect(head + "1 1 abc", "'abc'");
    expect(head + "1 1 nan", "'nan'");
    expect(head + "1 1 1e999", "'1e999'");
    expect(head + "1 1 1 1 1 1 2 0 0 0 " + one, "vertical angles is 1");
    expect(head + "1 1 1 2.5 1 1 2 0 0 0 " + one, "vertical angles is 2.5");
    expect(head + "1 1 1 1000000 1 1 2 0 0 0 " + one, "1000000");
    expect(head + "1 1 1 2000 2000 1 2 0 0 0 " + one, "2000 by 2000");
    expect(head + "1 1 1 2 -3 1 2 0 0 0 " + one, "horizontal angles is -3");
    expect(head + "1 1 1 2 2 4 2 0 0 0 " + one, "photometric type is 4");
    expect(head + "1 1 1 2 2 2 2 0 0 0 " + one + "-91 90 0 90 1 1 1 1", "-91");
    expect(head + "1 1 1 2 2 2 2 0 0 0 " + one + "-90 80 0 90 1 1 1 1", "80");
    expect(head + "1 1 1 2 2 3 2 0 0 0 " + one + "-90 90 -45 90 1 1 1 1", "-45");
    expect(head + "1 1 1 2 1 3 2 0 0 0 " + one + "-90 90 90 1 1", "90");
    expect(head + "1 1 0 2 1 1 2 0 0 0 " + one, "multiplier");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "90 0 0 1 1", "vertical angles");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 181 0 1 1", "181");
    expect(head + "1 1 1 2 2 1 2 0 0 0 " + one + "0 90 0 45 1 1 1 1", "45");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 90 30 1 1", "30");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 90 0 1 -1", "-1");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 90 0 0 0", "0");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 90 0 1", "ends before");
    expect(head + "1 1 1 2 1 1 2 0 0 0 " + one + "0 90 0 1 1 1", "follows");
    expect(std::string(9 << 20, ' '), "limit");
}

TEST(Ies, NoPrefixOrByteOfAFileDoesHarm) {
    const std::string whole = evenFile("0 90", 2);
    for (size_t i = 0; i < whole.size(); ++i) {
        (void)parseIes("cut.ies", whole.substr(0, i));
        for (const char c : {'\0', '-', '9', '\xff'}) {
            std::string changed = whole;
            changed[i] = c;
            const auto profile = parseIes("changed.ies", changed);
            if (!profile) continue;
            EXPECT_EQ(profile->candela.size(),
                      profile->verticalAngles.size() * profile->horizontalAngles.size());
        }
    }
}

/// Three nodes: with EXT_lights_ies, with a spot, and with both.
SmallGltf lampFile() {
    SmallGltf gltf = fullTriangle();
    gltf.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_lights_ies"};
    gltf.json["extensions"] = {{"EXT_lights_ies", {{"lights", {{{"uri", "even%20lamp.ies"}}}}}},
                               {"KHR_lights_punctual",
                                {{"lights",
                                  {{{"type", "spot"},
                                    {"intensity", 7},
                                    {"spot", Json::object()},
                                    {"extras", {{"rushlight", {{"lightProfile", 0}}}}}}}}}}};
    Json& nodes = gltf.json["nodes"];
    nodes[0]["extensions"]["EXT_lights_ies"] = {
        {"light", 0}, {"multiplier", 0.5}, {"color", {1, 0.5, 0.25}}};
    nodes[1]["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    nodes[2]["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    nodes[2]["extensions"]["EXT_lights_ies"] = {{"light", 0}};
    nodes[2]["extras"]["rushlight"] = {{"lightProfile", 0}, {"useProfileCandela", true}};
    return gltf;
}

TEST(GltfLightProfiles, AreLightsOfTheirOwnOrShapeThoseOfNodes) {
    const TempFolder folder;
    folder.write("even lamp.ies", evenFile("0", 1));
    SmallGltf gltf = lampFile();
    const auto model = loadModel(gltf.save(folder));
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_EQ(model->lightProfiles.size(), 1u);
    const assets::Light& own = model->lights[size_t(model->nodes[0].light)];
    EXPECT_EQ(own.type, assets::LightType::point);
    EXPECT_EQ(own.intensity, 50);
    EXPECT_EQ(own.color, vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(own.profile, 0);
    const assets::Light& spot = model->lights[size_t(model->nodes[1].light)];
    EXPECT_EQ(spot.intensity, 7);
    EXPECT_EQ(spot.profile, 0);
    const assets::Light& absolute = model->lights[size_t(model->nodes[2].light)];
    EXPECT_EQ(absolute.intensity, 700);
    EXPECT_EQ(absolute.type, assets::LightType::spot);
    const assets::Node& holder = model->nodes.back();
    EXPECT_EQ(holder.parent, 2);
    EXPECT_EQ(model->lights[size_t(holder.light)].intensity, 100);
    EXPECT_TRUE(model->fidelity.unsupported.empty());
    EXPECT_NE(
        std::find(model->fidelity.exact.begin(), model->fidelity.exact.end(), "EXT_lights_ies"),
        model->fidelity.exact.end());
}

TEST(GltfLightProfiles, WhatIsNotAppliedIsListed) {
    const TempFolder folder;
    folder.write("even lamp.ies",
                 "TILT=INCLUDE\n1 2 0 90 1 0.8\n1 -1 1 2 1 1 2 0 0 0 1 1 40 0 90 0 1 1\n");
    SmallGltf gltf = lampFile();
    const auto model = loadModel(gltf.save(folder));
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_EQ(model->fidelity.approximated.size(), 1u);
    EXPECT_NE(model->fidelity.approximated[0].find("tilt"), std::string::npos);
}

TEST(GltfLightProfiles, BadOnesAreErrors) {
    const auto problem = [](SmallGltf& gltf, const std::string& ies) {
        const TempFolder folder;
        folder.write("even lamp.ies", ies);
        const auto model = loadModel(gltf.save(folder));
        return model ? std::string() : model.error().message;
    };
    const std::string good = evenFile("0", 1);
    SmallGltf gltf = lampFile();
    EXPECT_EQ(problem(gltf, good), "");
    EXPECT_NE(problem(gltf, "no lamp").find("TILT="), std::string::npos);
    gltf.json["extensions"]["EXT_lights_ies"]["lights"][0]["uri"] = "nowhere.ies";
    EXPECT_NE(problem(gltf, good).find("nowhere.ies"), std::string::npos);
    gltf = lampFile();
    gltf.json["extensions"]["EXT_lights_ies"]["lights"][0]["bufferView"] = 0;
    EXPECT_NE(problem(gltf, good).find("either a uri or a bufferView"), std::string::npos);
    gltf = lampFile();
    gltf.json["nodes"][0]["extensions"]["EXT_lights_ies"]["light"] = 1;
    EXPECT_NE(problem(gltf, good).find("EXT_lights_ies"), std::string::npos);
    gltf = lampFile();
    gltf.json["nodes"][2]["extras"]["rushlight"]["lightCookie"] = 99;
    EXPECT_NE(problem(gltf, good).find("lightCookie"), std::string::npos);
    gltf = lampFile();
    gltf.json["nodes"][0]["extensions"]["EXT_lights_ies"]["multiplier"] = 3e38;
    EXPECT_NE(problem(gltf, good).find("candela"), std::string::npos);
}

}  // namespace
}  // namespace rushlight::test
