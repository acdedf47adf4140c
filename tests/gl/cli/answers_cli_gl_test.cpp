// rushlight diagnose and explain, as their users run them.
#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace rushlight {
namespace {

const std::string kCard = RUSHLIGHT_SOURCE "/content/testcard/testcard.gltf --size 128x72 ";

class AnswersCli : public testing::Test {
protected:
    Ended run(const std::string& arguments) const { return runTool(folder.path(), arguments); }
    nlohmann::json written() const {
        std::ifstream file(folder.path() + "/a.json");
        return nlohmann::json::parse(file);
    }
    std::string json() const { return " --json " + folder.path() + "/a.json"; }
    TemporaryDirectory folder;
};

TEST_F(AnswersCli, AFineFrameIsZero) {
    const Ended ended = run("diagnose " + kCard + json());
    EXPECT_EQ(ended.code, 0) << ended.output << ended.errors;
    EXPECT_TRUE(ended.output.starts_with("The frame is fine")) << ended.output;
    EXPECT_EQ(written()["frame"], "fine");
    EXPECT_TRUE(written()["findings"].empty());
}

TEST_F(AnswersCli, ABlackFrameIsOneAndItsCauseComesFirst) {
    const Ended dark = run("diagnose " + kCard + "--exposure 30" + json());
    EXPECT_EQ(dark.code, 1) << dark.output << dark.errors;
    EXPECT_NE(dark.output.find("1. exposure"), std::string::npos) << dark.output;
    const auto findings = written()["findings"];
    ASSERT_FALSE(findings.empty());
    EXPECT_EQ(findings[0]["cause"], "exposure");
    EXPECT_GT(findings[0]["score"], 0.5);
    const Ended away = run("diagnose " + kCard + "--eye 0,1,50 --target 0,1,90");
    EXPECT_EQ(away.code, 1);
    EXPECT_NE(away.output.find("1. behind-camera"), std::string::npos) << away.output;
}

TEST_F(AnswersCli, APixelIsTakenApart) {
    const Ended ended = run("explain " + kCard + "64,50" + json());
    EXPECT_EQ(ended.code, 0) << ended.errors;
    for (const char* part :
         {"pixel     64,50 of 128x72", "drawn     ", "= radiance", "= sum, of 255"})
        EXPECT_NE(ended.output.find(part), std::string::npos) << ended.output;
    const auto pixel = written();
    EXPECT_LE(pixel["error"].get<double>(), 1.0 / 255 + 1e-5);
    for (size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (const char* part : {"background", "ambient_diffuse", "ambient_specular", "emissive",
                                 "reflections", "fog", "blended", "bloom"})
            sum += pixel[part][c].get<double>();
        for (const auto& light : pixel["lights"]) sum += light["radiance"][c].get<double>();
        EXPECT_NEAR(sum, pixel["radiance"][c].get<double>(), 1e-5);
    }
}

}  // namespace
}  // namespace rushlight
