#include "sandbox/viewer/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rushlight {
namespace {

Key toKey(int code) {
    if (code >= GLFW_KEY_A && code <= GLFW_KEY_Z) return keyOffset(Key::a, code - GLFW_KEY_A);
    if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return keyOffset(Key::digit0, code - GLFW_KEY_0);
    if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_9)
        return keyOffset(Key::digit0, code - GLFW_KEY_KP_0);
    if (code >= GLFW_KEY_F1 && code <= GLFW_KEY_F12) return keyOffset(Key::f1, code - GLFW_KEY_F1);
    switch (code) {
        case GLFW_KEY_ESCAPE: return Key::escape;
        case GLFW_KEY_TAB: return Key::tab;
        case GLFW_KEY_ENTER: return Key::enter;
        case GLFW_KEY_SPACE: return Key::space;
        case GLFW_KEY_BACKSPACE: return Key::backspace;
        case GLFW_KEY_DELETE: return Key::remove;
        case GLFW_KEY_HOME: return Key::home;
        case GLFW_KEY_END: return Key::end;
        case GLFW_KEY_PAGE_UP: return Key::pageUp;
        case GLFW_KEY_PAGE_DOWN: return Key::pageDown;
        case GLFW_KEY_LEFT: return Key::left;
        case GLFW_KEY_RIGHT: return Key::right;
        case GLFW_KEY_UP: return Key::up;
        case GLFW_KEY_DOWN: return Key::down;
        case GLFW_KEY_LEFT_SHIFT: return Key::shift;
        case GLFW_KEY_RIGHT_SHIFT: return Key::shift;
        case GLFW_KEY_LEFT_CONTROL: return Key::control;
        case GLFW_KEY_RIGHT_CONTROL: return Key::control;
        case GLFW_KEY_LEFT_ALT: return Key::alt;
        case GLFW_KEY_RIGHT_ALT: return Key::alt;
        default: return Key::none;
    }
}

MouseButton toButton(int code) {
    switch (code) {
        case GLFW_MOUSE_BUTTON_LEFT: return MouseButton::left;
        case GLFW_MOUSE_BUTTON_RIGHT: return MouseButton::right;
        case GLFW_MOUSE_BUTTON_MIDDLE: return MouseButton::middle;
        default: return MouseButton::count;
    }
}

InputState& inputOf(GLFWwindow* window) {
    return *static_cast<InputState*>(glfwGetWindowUserPointer(window));
}

void onKey(GLFWwindow* window, int code, int, int action, int) {
    inputOf(window).key(toKey(code), action != GLFW_RELEASE);
}
void onButton(GLFWwindow* window, int code, int action, int) {
    inputOf(window).button(toButton(code), action != GLFW_RELEASE);
}
void onMove(GLFWwindow* window, double x, double y) {
    inputOf(window).mouseMovedTo(vec2(float(x), float(y)));
}
void onScroll(GLFWwindow* window, double, double y) { inputOf(window).scrolled(float(y)); }
void onFocus(GLFWwindow* window, int focused) {
    if (!focused) inputOf(window).releaseAll();
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window, InputState& input) : window_(window), input_(input) {
    glfwSetWindowUserPointer(window, &input);
    glfwSetKeyCallback(window, onKey);
    glfwSetMouseButtonCallback(window, onButton);
    glfwSetCursorPosCallback(window, onMove);
    glfwSetScrollCallback(window, onScroll);
    glfwSetWindowFocusCallback(window, onFocus);
}

WindowInput::~WindowInput() {
    captureMouse(false);
    glfwSetKeyCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetWindowFocusCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

void WindowInput::poll() { glfwPollEvents(); }

void WindowInput::waitFor(double seconds) { glfwWaitEventsTimeout(seconds); }

void WindowInput::captureMouse(bool captured) {
    if (captured == captured_) return;
    captured_ = captured;
    glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (glfwRawMouseMotionSupported())
        glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, captured ? GLFW_TRUE : GLFW_FALSE);
    input_.forgetMousePosition();
}

vec2 WindowInput::pixelsPerUnit() const {
    int units[2] = {0, 0};
    int pixels[2] = {0, 0};
    glfwGetWindowSize(window_, &units[0], &units[1]);
    glfwGetFramebufferSize(window_, &pixels[0], &pixels[1]);
    if (units[0] <= 0 || units[1] <= 0) return vec2(1);
    return {float(pixels[0]) / float(units[0]), float(pixels[1]) / float(units[1])};
}

}  // namespace rushlight
