#pragma once
// EGL as it is found at run time: nothing links to it, so a program starts on a machine that has
// none.

#include "renderer/context/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>
#include <string_view>

namespace rushlight {

struct EglLibrary {
    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLQUERYSTRINGPROC queryString = nullptr;
    PFNEGLGETDISPLAYPROC getDisplay = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLTERMINATEPROC terminate = nullptr;
    PFNEGLGETERRORPROC getError = nullptr;
    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLCHOOSECONFIGPROC chooseConfig = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;
    PFNEGLCREATEPBUFFERSURFACEPROC createPbufferSurface = nullptr;
    PFNEGLDESTROYSURFACEPROC destroySurface = nullptr;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;

    // Extensions; null when absent.
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;

    std::string clientExtensions;
};

/// The library, opened once a process and kept. ErrorKind::noContext with dlopen's reason.
Result<const EglLibrary*> openEgl();

/// The address of a GL function through eglGetProcAddress; after openEgl has worked.
void* loadThroughEgl(const char* name);

/// Whether a space-separated list has this word.
bool hasWord(std::string_view list, std::string_view word);

/// "EGL_BAD_MATCH", or the number of an unknown code.
std::string eglErrorText(EGLint code);

/// An initialised display. Every caller of eglGetPlatformDisplay with the same arguments gets the
/// same one, and one eglTerminate ends it for all, so uses are counted process-wide.
class EglDisplayUse {
public:
    static Result<EglDisplayUse> open(const EglLibrary&, EGLDisplay, ContextKind);
    EglDisplayUse(EglDisplayUse&& other) noexcept;
    EglDisplayUse& operator=(EglDisplayUse&&) = delete;
    ~EglDisplayUse();
    EGLDisplay get() const { return display_; }

private:
    EglDisplayUse(const EglLibrary& egl, EGLDisplay display) : egl_(&egl), display_(display) {}
    const EglLibrary* egl_;
    EGLDisplay display_;
};

}  // namespace rushlight
