#include "sandbox/viewer/input_script.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

TEST(InputScriptTest, HoldsAKeyFromPressToRelease) {
    auto script = InputScript::parse("s", "# a comment\n2 press w\n\n5 release w # done\n");
    ASSERT_TRUE(script) << script.error().text();
    InputState input;
    for (uint32_t frame = 0; frame < 8; ++frame) {
        input.beginFrame();
        script->play(frame, input);
        EXPECT_EQ(input.isDown(Key::w), frame >= 2 && frame < 5) << frame;
        EXPECT_EQ(input.wasPressed(Key::w), frame == 2) << frame;
    }
    EXPECT_EQ(script->lastFrame(), 5u);
}

TEST(InputScriptTest, TapsTurnsAndScrolls) {
    auto script = InputScript::parse("s", "1 tap f12\n1 turn 3 2 -1\n2 look 10 0\n2 scroll -2");
    ASSERT_TRUE(script) << script.error().text();
    InputState input;
    const vec2 expected[] = {{0, 0}, {2, -1}, {12, -1}, {2, -1}, {0, 0}};
    for (uint32_t frame = 0; frame < 5; ++frame) {
        input.beginFrame();
        script->play(frame, input);
        EXPECT_EQ(input.mouseDelta(), expected[frame]) << frame;
        EXPECT_EQ(input.wasPressed(Key::f12), frame == 1);
        EXPECT_EQ(input.scroll(), frame == 2 ? -2 : 0);
    }
    EXPECT_EQ(script->lastFrame(), 3u);
}

TEST(InputScriptTest, SaysWhatIsWrongAndWhere) {
    const std::pair<const char*, const char*> cases[] = {
        {"0 tap e\nhello", "s:2"},    {"-1 tap e", "s:1"},
        {"0 tap hyper", "'hyper'"},   {"0 jump", "'jump'"},
        {"0 look 3", "'look'"},       {"0 turn 0 1 1", "'turn'"},
        {"0 tap e e", "'tap'"},       {"5 tap e\n4 tap e", "4 follows 5"},
        {"99999999999 tap e", "s:1"}, {"0 turn -5 1 1", "'turn'"}};
    for (const auto& [text, expected] : cases) {
        const auto script = InputScript::parse("s", text);
        ASSERT_FALSE(script) << text;
        EXPECT_NE(script.error().text().find(expected), std::string::npos) << script.error().text();
    }
}

TEST(InputScriptTest, AFileThatIsNotThereIsAnError) {
    EXPECT_FALSE(InputScript::load("no/such/script.txt"));
}

TEST(InputScriptTest, TheWalkDemoIsValid) {
    const auto script = InputScript::parse("demo", kWalkDemo);
    ASSERT_TRUE(script) << script.error().text();
    EXPECT_GT(script->lastFrame(), 100u);
}

}  // namespace
}  // namespace rushlight
