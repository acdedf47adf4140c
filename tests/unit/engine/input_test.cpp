#include "engine/input/input.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

TEST(InputStateTest, PressIsSeenForOneFrameAndHeldOn) {
    InputState input;
    input.beginFrame();
    input.key(Key::w, true);
    EXPECT_TRUE(input.wasPressed(Key::w));
    EXPECT_TRUE(input.isDown(Key::w));
    input.beginFrame();
    input.key(Key::w, true);  // the repeat of a held key
    EXPECT_FALSE(input.wasPressed(Key::w));
    EXPECT_TRUE(input.isDown(Key::w));
    input.key(Key::w, false);
    EXPECT_TRUE(input.wasReleased(Key::w));
    EXPECT_FALSE(input.isDown(Key::w));
}

TEST(InputStateTest, ATapWithinOneFrameIsNotLost) {
    InputState input;
    input.beginFrame();
    input.key(Key::e, true);
    input.key(Key::e, false);
    EXPECT_TRUE(input.wasPressed(Key::e));
    EXPECT_TRUE(input.wasReleased(Key::e));
    EXPECT_FALSE(input.isDown(Key::e));
}

TEST(InputStateTest, KeysAndButtonsDoNotShareStates) {
    InputState input;
    for (int key = 1; key < int(Key::count); ++key) input.key(Key(key), true);
    EXPECT_FALSE(input.isDown(MouseButton::left));
    input.button(MouseButton::right, true);
    EXPECT_TRUE(input.wasPressed(MouseButton::right));
    EXPECT_FALSE(input.isDown(MouseButton::middle));
}

TEST(InputStateTest, UnknownKeysAreIgnored) {
    InputState input;
    input.key(Key::none, true);
    input.key(Key::count, true);
    EXPECT_FALSE(input.isDown(Key::none));
    EXPECT_FALSE(input.isDown(MouseButton::left));
}

TEST(InputStateTest, TheFirstMousePositionIsNoMovement) {
    InputState input;
    input.mouseMovedTo({500, 300});
    EXPECT_EQ(input.mouseDelta(), vec2(0));
    input.mouseMovedTo({510, 295});
    input.mouseMovedTo({511, 295});
    EXPECT_EQ(input.mouseDelta(), vec2(11, -5));
    input.beginFrame();
    EXPECT_EQ(input.mouseDelta(), vec2(0));
    input.forgetMousePosition();
    input.mouseMovedTo({0, 0});
    EXPECT_EQ(input.mouseDelta(), vec2(0));
}

TEST(InputStateTest, ScrollAddsUpWithinAFrame) {
    InputState input;
    input.scrolled(1);
    input.scrolled(0.5f);
    EXPECT_EQ(input.scroll(), 1.5f);
    input.beginFrame();
    EXPECT_EQ(input.scroll(), 0);
}

TEST(InputStateTest, LosingTheFocusReleasesEverything) {
    InputState input;
    input.key(Key::w, true);
    input.button(MouseButton::left, true);
    input.beginFrame();
    input.releaseAll();
    EXPECT_TRUE(input.wasReleased(Key::w));
    EXPECT_FALSE(input.isDown(MouseButton::left));
}

TEST(InputStateTest, AnAxisIsTheDifferenceOfItsKeys) {
    InputState input;
    input.key(Key::d, true);
    EXPECT_EQ(input.axis(Key::a, Key::d), 1);
    input.key(Key::a, true);
    EXPECT_EQ(input.axis(Key::a, Key::d), 0);
}

TEST(KeyTest, RunsOfTheEnumerationAreContiguous) {
    EXPECT_EQ(keyOffset(Key::a, 25), Key::z);
    EXPECT_EQ(keyOffset(Key::digit0, 9), Key::digit9);
    EXPECT_EQ(keyOffset(Key::f1, 11), Key::f12);
}

}  // namespace
}  // namespace rushlight
