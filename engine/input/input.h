#pragma once
// What the player's hands do, with no window library in sight: an adapter of the host feeds it.

#include "engine/core/math.h"

#include <bitset>
#include <cstdint>

namespace rushlight {

enum class Key : uint8_t {
    none,
    // Letters and digits follow each other, so that keyOffset() can tell the n-th.
    a,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    digit0,
    digit1,
    digit2,
    digit3,
    digit4,
    digit5,
    digit6,
    digit7,
    digit8,
    digit9,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
    escape,
    tab,
    enter,
    space,
    backspace,
    remove,
    home,
    end,
    pageUp,
    pageDown,
    left,
    right,
    up,
    down,
    shift,
    control,
    alt,
    count
};

/// `first` + `offset`, both within one run of the enumeration (letters, digits, function keys).
constexpr Key keyOffset(Key first, int offset) { return Key(int(first) + offset); }

enum class MouseButton : uint8_t { left, right, middle, count };

/// The state of keyboard and mouse, and what changed since the last beginFrame(). One thread.
///
/// A key that goes down and up within one frame is reported as pressed and released, never lost.
class InputState {
public:
    /// Forgets what changed. Call once a frame, before the window's events are read.
    void beginFrame();

    // Fed by the adapter.
    void key(Key key, bool down);
    void button(MouseButton button, bool down);
    void mouseMovedTo(vec2 pixels);
    void scrolled(float steps);
    /// The next position gives no movement: the cursor was captured, released or taken elsewhere.
    void forgetMousePosition() { mouseKnown_ = false; }
    /// The window lost the focus: nothing is held any more.
    void releaseAll();

    // Read by the game.
    bool isDown(Key key) const { return down_[size_t(key)]; }
    bool wasPressed(Key key) const { return pressed_[size_t(key)]; }
    bool wasReleased(Key key) const { return released_[size_t(key)]; }
    bool isDown(MouseButton button) const { return down_[index(button)]; }
    bool wasPressed(MouseButton button) const { return pressed_[index(button)]; }
    bool wasReleased(MouseButton button) const { return released_[index(button)]; }
    /// 1, 0 or -1.
    float axis(Key negative, Key positive) const {
        return float(isDown(positive)) - float(isDown(negative));
    }
    vec2 mousePosition() const { return mousePosition_; }  ///< pixels from the top left
    vec2 mouseDelta() const { return mouseDelta_; }        ///< since beginFrame()
    float scroll() const { return scroll_; }  ///< steps since beginFrame(), up is positive

private:
    static constexpr size_t kKeys = size_t(Key::count);
    static constexpr size_t kStates = kKeys + size_t(MouseButton::count);
    static constexpr size_t index(MouseButton button) { return kKeys + size_t(button); }
    void set(size_t state, bool down);

    std::bitset<kStates> down_, pressed_, released_;
    vec2 mousePosition_{0};
    vec2 mouseDelta_{0};
    float scroll_ = 0;
    bool mouseKnown_ = false;
};

}  // namespace rushlight
