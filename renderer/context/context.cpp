#include "renderer/context/context.h"

#include "engine/core/check.h"

#include "renderer/context/context_details.h"
#include "renderer/context/context_kinds.h"
#include "renderer/context/raster_threads.h"

#include <array>
#include <span>

namespace rushlight {
namespace {

constexpr std::array kKinds = {ContextKind::eglDevice, ContextKind::eglSurfaceless,
                               ContextKind::eglPbuffer, ContextKind::osmesa,
                               ContextKind::hiddenWindow};

std::span<const ContextKind> kindsOf(ContextChoice choice) {
    const std::span<const ContextKind> all = kKinds;
    switch (choice) {
        case ContextChoice::automatic: return all;
        case ContextChoice::egl: return all.first(3);
        case ContextChoice::osmesa: return all.subspan(3, 1);
        case ContextChoice::window: return all.subspan(4, 1);
    }
    return all;
}

Result<std::unique_ptr<Context>> createUnchecked(ContextKind kind, const ContextOptions& options) {
    switch (kind) {
        case ContextKind::eglDevice:
        case ContextKind::eglSurfaceless:
        case ContextKind::eglPbuffer: return createEglContext(kind, options);
        case ContextKind::osmesa: return createOsmesaContext(options);
        case ContextKind::hiddenWindow: return createHiddenWindowContext(options);
    }
    RL_CHECK(false, "a context kind is one of the enumeration");
}

}  // namespace

const char* toText(ContextKind kind) {
    switch (kind) {
        case ContextKind::eglDevice: return "egl-device";
        case ContextKind::eglSurfaceless: return "egl-surfaceless";
        case ContextKind::eglPbuffer: return "egl-pbuffer";
        case ContextKind::osmesa: return "osmesa";
        case ContextKind::hiddenWindow: return "window";
    }
    return "unknown";
}

Result<std::unique_ptr<Context>> createContext(ContextKind kind, const ContextOptions& options) {
    auto context = createUnchecked(kind, options);
    if (!context) return context;
    // A driver may hand out less than it was asked for.
    if (std::string reason = versionProblem((*context)->loader()); !reason.empty())
        return fail(toText(kind), std::move(reason), ErrorKind::noContext);
    if (options.pinRasterThreads) pinRasterThreads((*context)->loader());
    return context;
}

Result<std::unique_ptr<Context>> createOffscreenContext(ContextChoice choice,
                                                        const ContextOptions& options) {
    std::string reasons;
    for (ContextKind kind : kindsOf(choice)) {
        auto context = createContext(kind, options);
        if (context) return context;
        reasons += std::string(" ") + toText(kind) + ": " + context.error().message;
    }
    return fail("OpenGL 4.5 core",
                "No context could be made; `rushlight doctor` tells more." + reasons,
                ErrorKind::noContext);
}

std::vector<ContextAttempt> probeContexts() {
    std::vector<ContextAttempt> attempts;
    for (ContextKind kind : kKinds) {
        ContextAttempt& attempt = attempts.emplace_back();
        attempt.kind = kind;
        auto context = createContext(kind, {});
        attempt.worked = context.has_value();
        if (context)
            describeContext((*context)->loader(), attempt);
        else
            attempt.reason = context.error().message;
    }
    return attempts;
}

}  // namespace rushlight
