#include "renderer/context/context_kinds.h"
#include "renderer/context/egl_library.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rushlight {
namespace {

/// Destroyed in reverse order: the context and its surface before the display.
class EglContext final : public Context {
public:
    EglContext(const EglLibrary& egl, ContextKind kind, EglDisplayUse display)
        : egl_(egl), kind_(kind), display_(std::move(display)) {}

    ~EglContext() override {
        egl_.makeCurrent(display_.get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) egl_.destroyContext(display_.get(), context_);
        if (surface_ != EGL_NO_SURFACE) egl_.destroySurface(display_.get(), surface_);
    }

    ContextKind kind() const override { return kind_; }
    void makeCurrent() override { makeCurrentWorked(); }
    GlLoader loader() const override { return loadThroughEgl; }

    /// Empty, or the reason why there is no context.
    std::string build(const ContextOptions& options);

private:
    bool makeCurrentWorked() {
        // The API is a setting of the thread, and another library may have bound OpenGL ES here.
        egl_.bindApi(EGL_OPENGL_API);
        return egl_.makeCurrent(display_.get(), surface_, surface_, context_);
    }
    std::string failure(const char* what) const {
        return std::string(what) + " (" + eglErrorText(egl_.getError()) + ").";
    }

    const EglLibrary& egl_;
    ContextKind kind_;
    EglDisplayUse display_;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

std::string EglContext::build(const ContextOptions& options) {
    const char* extensions = egl_.queryString(display_.get(), EGL_EXTENSIONS);
    const bool surfaceless = kind_ != ContextKind::eglPbuffer &&
                             hasWord(extensions ? extensions : "", "EGL_KHR_surfaceless_context");
    if (!egl_.bindApi(EGL_OPENGL_API)) return failure("EGL has no desktop OpenGL here");

    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                             surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl_.chooseConfig(display_.get(), wanted, &config, 1, &count) || count == 0)
        return failure("EGL has no OpenGL configuration here");

    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 options.debug ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    context_ = egl_.createContext(display_.get(), config, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) return failure("The driver refused OpenGL 4.5 core");

    if (!surfaceless) {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface_ = egl_.createPbufferSurface(display_.get(), config, size);
        if (surface_ == EGL_NO_SURFACE) return failure("EGL refused a pixel buffer of 1x1");
    }
    if (!makeCurrentWorked()) return failure("The context could not be made current");
    return {};
}

Result<std::unique_ptr<Context>> contextOn(const EglLibrary& egl, EGLDisplay display,
                                           ContextKind kind, const ContextOptions& options) {
    auto use = EglDisplayUse::open(egl, display, kind);
    if (!use) return tl::unexpected(use.error());
    auto context = std::make_unique<EglContext>(egl, kind, std::move(*use));
    if (std::string reason = context->build(options); !reason.empty())
        return fail(toText(kind), std::move(reason), ErrorKind::noContext);
    return context;
}

bool isSoftware(const EglLibrary& egl, EGLDeviceEXT device) {
    const char* extensions = egl.queryDeviceString ? egl.queryDeviceString(device, EGL_EXTENSIONS)
                                                   : nullptr;
    return extensions && hasWord(extensions, "EGL_MESA_device_software");
}

/// The first device that gives the context; Mesa lists its software device first, so GPUs are moved
/// before it.
Result<std::unique_ptr<Context>> contextOnDevice(const EglLibrary& egl,
                                                 const ContextOptions& options) {
    constexpr auto kKind = ContextKind::eglDevice;
    if (!egl.queryDevices || !egl.getPlatformDisplay ||
        !hasWord(egl.clientExtensions, "EGL_EXT_platform_device"))
        return fail(toText(kKind), "EGL lacks EGL_EXT_platform_device.", ErrorKind::noContext);
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (!egl.queryDevices(EGLint(devices.size()), devices.data(), &count) || count == 0)
        return fail(toText(kKind), "EGL lists no devices.", ErrorKind::noContext);

    std::stable_partition(devices.begin(), devices.begin() + count,
                          [&](EGLDeviceEXT device) { return !isSoftware(egl, device); });
    std::string reasons;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDisplay display = egl.getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT,
                                                          devices[size_t(i)], nullptr);
        auto context = contextOn(egl, display, kKind, options);
        if (context) return context;
        if (i > 0) reasons += ' ';
        reasons.append("Device ")
            .append(std::to_string(i))
            .append(": ")
            .append(context.error().message);
    }
    return fail(toText(kKind), std::move(reasons), ErrorKind::noContext);
}

Result<std::unique_ptr<Context>> contextWithoutSurface(const EglLibrary& egl,
                                                       const ContextOptions& options) {
    constexpr auto kKind = ContextKind::eglSurfaceless;
    if (!egl.getPlatformDisplay || !hasWord(egl.clientExtensions, "EGL_MESA_platform_surfaceless"))
        return fail(toText(kKind), "EGL lacks EGL_MESA_platform_surfaceless.",
                    ErrorKind::noContext);
    return contextOn(
        egl, egl.getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
        kKind, options);
}

}  // namespace

Result<std::unique_ptr<Context>> createEglContext(ContextKind kind, const ContextOptions& options) {
    const auto egl = openEgl();
    if (!egl) return tl::unexpected(egl.error());
    switch (kind) {
        case ContextKind::eglDevice: return contextOnDevice(**egl, options);
        case ContextKind::eglSurfaceless: return contextWithoutSurface(**egl, options);
        default: return contextOn(**egl, (*egl)->getDisplay(EGL_DEFAULT_DISPLAY), kind, options);
    }
}

}  // namespace rushlight
