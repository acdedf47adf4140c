#include "engine/input/input.h"

namespace rushlight {

void InputState::beginFrame() {
    pressed_.reset();
    released_.reset();
    mouseDelta_ = vec2(0);
    scroll_ = 0;
}

void InputState::set(size_t state, bool down) {
    if (down_[state] == down) return;  // key repeat
    down_[state] = down;
    (down ? pressed_ : released_)[state] = true;
}

void InputState::key(Key key, bool down) {
    if (key != Key::none && key < Key::count) set(size_t(key), down);
}

void InputState::button(MouseButton button, bool down) {
    if (button < MouseButton::count) set(index(button), down);
}

void InputState::mouseMovedTo(vec2 pixels) {
    if (mouseKnown_) mouseDelta_ += pixels - mousePosition_;
    mousePosition_ = pixels;
    mouseKnown_ = true;
}

void InputState::scrolled(float steps) { scroll_ += steps; }

void InputState::releaseAll() {
    for (size_t state = 0; state < kStates; ++state) set(state, false);
    mouseKnown_ = false;
}

}  // namespace rushlight
