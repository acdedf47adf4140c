#pragma once
// GLFW's events as engine/input's state: the one file pair of the viewer that knows the window
// library.

#include "engine/input/input.h"

struct GLFWwindow;

namespace rushlight {

/// Listens to one window for as long as it lives. Main thread.
class WindowInput {
public:
    /// Takes the window's user pointer and its input callbacks.
    WindowInput(GLFWwindow* window, InputState& input);
    ~WindowInput();
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;

    /// Reads what happened since the last call.
    void poll();
    /// As poll, but sleeps until something happens or `seconds` have passed.
    void waitFor(double seconds);

    /// Hides the cursor and lets it move without end, for looking around.
    void captureMouse(bool captured);
    bool isMouseCaptured() const { return captured_; }

    /// Framebuffer pixels per unit of mouse position; 1 except on scaled displays.
    vec2 pixelsPerUnit() const;

private:
    GLFWwindow* window_;
    InputState& input_;
    bool captured_ = false;
};

}  // namespace rushlight
