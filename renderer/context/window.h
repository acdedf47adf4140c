#pragma once

#include "renderer/context/context.h"

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace rushlight {

/// A window with a context, GLFW underneath. Its events are read through `native()` by
/// engine/input.
class Window {
public:
    virtual ~Window() = default;
    virtual GLFWwindow* native() = 0;
    virtual GlLoader loader() const = 0;
    virtual void swapBuffers() = 0;
    virtual bool shouldClose() const = 0;
    virtual void framebufferSize(uint32_t& width, uint32_t& height) const = 0;  ///< pixels; 0 while
                                                                                ///< minimised
};

struct WindowOptions {
    std::string title = "Rushlight";
    uint32_t width = 1280;
    uint32_t height = 720;
    bool verticalSync = true;
    bool visible = true;
    ContextOptions context;
};

/// ErrorKind::noContext with GLFW's own reason (no display, no GL 4.5).
Result<std::unique_ptr<Window>> createWindow(const WindowOptions&);

}  // namespace rushlight
