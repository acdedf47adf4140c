#pragma once
// Makes an OpenGL 4.5 core context without a window system, or with one. Nothing else in the
// project creates one.

#include "engine/core/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rushlight {

using GlLoader = void* (*)(const char* name);

enum class ContextKind : uint8_t { eglDevice, eglSurfaceless, eglPbuffer, osmesa, hiddenWindow };
const char* toText(ContextKind kind);  ///< "egl-device", "egl-surfaceless", "egl-pbuffer",
                                       ///< "osmesa", "window"

/// What `--context` says.
enum class ContextChoice : uint8_t { automatic, egl, osmesa, window };

struct ContextOptions {
    bool debug = false;             ///< a debug context, with GL_KHR_debug output
    bool pinRasterThreads = false;  ///< put each llvmpipe raster thread on a core of its own (for
                                    ///< tools, not libraries)
};

/// A current context. Destroying it makes no context current. Used on the thread that made it.
class Context {
public:
    virtual ~Context() = default;
    virtual ContextKind kind() const = 0;
    virtual void makeCurrent() = 0;
    /// Address of a GL function, for RendererDesc::loadGl. Valid while this context lives.
    virtual GlLoader loader() const = 0;
};

/// One attempt to make a context: why it failed, or that it worked.
struct ContextAttempt {
    ContextKind kind;
    bool worked = false;
    std::string reason;  ///< a full sentence, when it did not work
    std::string glVendor;
    std::string glRenderer;
    std::string glVersion;
    std::string glslVersion;
    std::vector<std::string> missing;  ///< wanted extensions or limits that are absent: what is
                                       ///< reduced, in sentences
};

/// Tries one kind.
Result<std::unique_ptr<Context>> createContext(ContextKind, const ContextOptions&);

/// Tries, in order, EGL device, EGL surfaceless, EGL pbuffer, OSMesa, hidden window (or those
/// `choice` allows). The Error's message tells why each failed. ErrorKind::noContext.
Result<std::unique_ptr<Context>> createOffscreenContext(ContextChoice choice,
                                                        const ContextOptions&);

/// Tries every kind, one after the other, for `rushlight doctor`.
std::vector<ContextAttempt> probeContexts();

}  // namespace rushlight
