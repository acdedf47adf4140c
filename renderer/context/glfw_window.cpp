#include "renderer/context/context_details.h"
#include "renderer/context/context_kinds.h"
#include "renderer/context/raster_threads.h"
#include "renderer/context/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace rushlight {
namespace {

std::string& collectedErrors() {
    static std::string errors;
    return errors;
}

/// While it lives GLFW's errors are collected; the callback of the host comes back after it. Main
/// thread only, as GLFW itself.
class ErrorCollector {
public:
    ErrorCollector() {
        collectedErrors().clear();
        previous_ = glfwSetErrorCallback([](int, const char* description) {
            if (!collectedErrors().empty()) collectedErrors() += "; ";
            collectedErrors() += description;
        });
    }
    ~ErrorCollector() { glfwSetErrorCallback(previous_); }
    ErrorCollector(const ErrorCollector&) = delete;
    ErrorCollector& operator=(const ErrorCollector&) = delete;

    std::string sentence(const char* what) const {
        std::string text = what;
        if (!collectedErrors().empty()) text += " (" + collectedErrors() + ")";
        return text + ".";
    }

private:
    GLFWerrorfun previous_;
};

/// GLFW counts no initialisations: the last window ends it.
uint32_t liveWindows = 0;

void* loadThroughGlfw(const char* name) {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

class GlfwWindow final : public Window {
public:
    /// The window with its context current, or the reason.
    static Result<std::unique_ptr<GlfwWindow>> open(const WindowOptions& options);

    ~GlfwWindow() override {
        if (glfwGetCurrentContext() == window_) glfwMakeContextCurrent(nullptr);
        if (window_) glfwDestroyWindow(window_);
        if (--liveWindows == 0) glfwTerminate();
    }

    GLFWwindow* native() override { return window_; }
    GlLoader loader() const override { return loadThroughGlfw; }
    void swapBuffers() override { glfwSwapBuffers(window_); }
    bool shouldClose() const override { return glfwWindowShouldClose(window_) != 0; }
    void framebufferSize(uint32_t& width, uint32_t& height) const override {
        int w = 0;
        int h = 0;
        glfwGetFramebufferSize(window_, &w, &h);
        width = uint32_t(w);
        height = uint32_t(h);
    }

private:
    /// Takes part in the count from here on, whether or not the window can be made.
    GlfwWindow() { ++liveWindows; }
    GLFWwindow* window_ = nullptr;
};

void setHints(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.context.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    // The frame is drawn into images of the renderer's own; the window takes the finished colours
    // alone.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

Result<std::unique_ptr<GlfwWindow>> GlfwWindow::open(const WindowOptions& options) {
    const char* object = toText(ContextKind::hiddenWindow);
    const ErrorCollector errors;
    if (!glfwInit())
        return fail(object, errors.sentence("GLFW could not start"), ErrorKind::noContext);
    std::unique_ptr<GlfwWindow> window(new GlfwWindow);
    setHints(options);
    window->window_ = glfwCreateWindow(int(options.width), int(options.height),
                                       options.title.c_str(), nullptr, nullptr);
    if (!window->window_)
        return fail(object, errors.sentence("GLFW could not open a window with OpenGL 4.5 core"),
                    ErrorKind::noContext);
    glfwMakeContextCurrent(window->window_);
    glfwSwapInterval(options.verticalSync ? 1 : 0);
    return window;
}

class HiddenWindowContext final : public Context {
public:
    explicit HiddenWindowContext(std::unique_ptr<GlfwWindow> window) : window_(std::move(window)) {}
    ContextKind kind() const override { return ContextKind::hiddenWindow; }
    void makeCurrent() override { glfwMakeContextCurrent(window_->native()); }
    GlLoader loader() const override { return window_->loader(); }

private:
    std::unique_ptr<GlfwWindow> window_;
};

}  // namespace

Result<std::unique_ptr<Window>> createWindow(const WindowOptions& options) {
    auto window = GlfwWindow::open(options);
    if (!window) return tl::unexpected(window.error());
    if (std::string reason = versionProblem((*window)->loader()); !reason.empty())
        return fail(options.title, std::move(reason), ErrorKind::noContext);
    if (options.context.pinRasterThreads) pinRasterThreads((*window)->loader());
    return window;
}

Result<std::unique_ptr<Context>> createHiddenWindowContext(const ContextOptions& options) {
    WindowOptions hidden;
    hidden.width = 16;
    hidden.height = 16;
    hidden.verticalSync = false;
    hidden.visible = false;
    hidden.context = options;
    auto window = GlfwWindow::open(hidden);
    if (!window) return tl::unexpected(window.error());
    return std::make_unique<HiddenWindowContext>(std::move(*window));
}

}  // namespace rushlight
