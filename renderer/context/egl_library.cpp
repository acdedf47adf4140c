#include "renderer/context/egl_library.h"

#include <dlfcn.h>

#include <map>
#include <mutex>
#include <utility>

namespace rushlight {
namespace {

template <class F>
bool find(void* library, F& function, const char* name) {
    function = reinterpret_cast<F>(dlsym(library, name));
    return function != nullptr;
}

template <class F>
void findExtension(const EglLibrary& egl, F& function, const char* name) {
    function = reinterpret_cast<F>(egl.getProcAddress(name));
}

/// Fills `egl`; returns the reason when that fails. Never closed: drivers do not survive being
/// unloaded.
std::string openOnce(EglLibrary& egl) {
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library) return std::string("EGL is not installed (") + dlerror() + ").";
    const bool complete = find(library, egl.getProcAddress, "eglGetProcAddress") &&
                          find(library, egl.queryString, "eglQueryString") &&
                          find(library, egl.getDisplay, "eglGetDisplay") &&
                          find(library, egl.initialize, "eglInitialize") &&
                          find(library, egl.terminate, "eglTerminate") &&
                          find(library, egl.getError, "eglGetError") &&
                          find(library, egl.bindApi, "eglBindAPI") &&
                          find(library, egl.chooseConfig, "eglChooseConfig") &&
                          find(library, egl.createContext, "eglCreateContext") &&
                          find(library, egl.destroyContext, "eglDestroyContext") &&
                          find(library, egl.createPbufferSurface, "eglCreatePbufferSurface") &&
                          find(library, egl.destroySurface, "eglDestroySurface") &&
                          find(library, egl.makeCurrent, "eglMakeCurrent");
    if (!complete) return "libEGL.so.1 lacks a function of EGL 1.4.";
    if (const char* extensions = egl.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS))
        egl.clientExtensions = extensions;
    if (hasWord(egl.clientExtensions, "EGL_EXT_platform_base"))
        findExtension(egl, egl.getPlatformDisplay, "eglGetPlatformDisplayEXT");
    if (hasWord(egl.clientExtensions, "EGL_EXT_device_enumeration"))
        findExtension(egl, egl.queryDevices, "eglQueryDevicesEXT");
    if (hasWord(egl.clientExtensions, "EGL_EXT_device_query"))
        findExtension(egl, egl.queryDeviceString, "eglQueryDeviceStringEXT");
    return {};
}

struct OpenedEgl {
    EglLibrary egl;
    std::string reason;
    OpenedEgl() { reason = openOnce(egl); }
};

const OpenedEgl& opened() {
    static const OpenedEgl once;
    return once;
}

struct DisplayUses {
    std::mutex mutex;
    std::map<EGLDisplay, uint32_t> counts;
};

DisplayUses& displayUses() {
    static DisplayUses uses;
    return uses;
}

}  // namespace

Result<const EglLibrary*> openEgl() {
    if (!opened().reason.empty()) return fail("EGL", opened().reason, ErrorKind::noContext);
    return &opened().egl;
}

void* loadThroughEgl(const char* name) {
    return reinterpret_cast<void*>(opened().egl.getProcAddress(name));
}

bool hasWord(std::string_view list, std::string_view word) {
    for (size_t at = list.find(word); at != list.npos; at = list.find(word, at + 1)) {
        const size_t end = at + word.size();
        if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
            return true;
    }
    return false;
}

std::string eglErrorText(EGLint code) {
    switch (code) {
        case EGL_SUCCESS: return "EGL_SUCCESS";
        case EGL_NOT_INITIALIZED: return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ACCESS: return "EGL_BAD_ACCESS";
        case EGL_BAD_ALLOC: return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE: return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG: return "EGL_BAD_CONFIG";
        case EGL_BAD_CONTEXT: return "EGL_BAD_CONTEXT";
        case EGL_BAD_DISPLAY: return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH: return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER: return "EGL_BAD_PARAMETER";
        case EGL_BAD_SURFACE: return "EGL_BAD_SURFACE";
        case EGL_CONTEXT_LOST: return "EGL_CONTEXT_LOST";
        default: return "EGL error " + std::to_string(code);
    }
}

Result<EglDisplayUse> EglDisplayUse::open(const EglLibrary& egl, EGLDisplay display,
                                          ContextKind kind) {
    if (display == EGL_NO_DISPLAY)
        return fail(toText(kind), "EGL has no display of this kind.", ErrorKind::noContext);
    DisplayUses& uses = displayUses();
    const std::lock_guard lock(uses.mutex);
    if (uses.counts[display] == 0 && !egl.initialize(display, nullptr, nullptr)) {
        uses.counts.erase(display);
        return fail(
            toText(kind),
            "The EGL display could not be initialised (" + eglErrorText(egl.getError()) + ").",
            ErrorKind::noContext);
    }
    ++uses.counts[display];
    return EglDisplayUse(egl, display);
}

EglDisplayUse::EglDisplayUse(EglDisplayUse&& other) noexcept
    : egl_(other.egl_), display_(std::exchange(other.display_, EGL_NO_DISPLAY)) {}

EglDisplayUse::~EglDisplayUse() {
    if (display_ == EGL_NO_DISPLAY) return;
    DisplayUses& uses = displayUses();
    const std::lock_guard lock(uses.mutex);
    if (--uses.counts[display_] > 0) return;
    uses.counts.erase(display_);
    egl_->terminate(display_);
}

}  // namespace rushlight
