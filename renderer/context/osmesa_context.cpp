// OSMesa renders into memory of the caller with no window system. Mesa 25.1 removed it, so it is
// opened at run time and its few declarations are here, after its documentation
// (https://docs.mesa3d.org/osmesa.html).

#include "renderer/context/context_kinds.h"

#include <GL/glcorearb.h>
#include <dlfcn.h>

#include <array>

namespace rushlight {
namespace {

constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaDepthBits = 0x30;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaMajorVersion = 0x36;
constexpr int kOsmesaMinorVersion = 0x37;

struct OsmesaObject;

struct OsmesaLibrary {
    OsmesaObject* (*createContextAttribs)(const int* attributes, OsmesaObject* shared) = nullptr;
    void (*destroyContext)(OsmesaObject*) = nullptr;
    GLboolean (*makeCurrent)(OsmesaObject*, void* buffer, GLenum type, GLsizei width,
                             GLsizei height) = nullptr;
    void* (*getProcAddress)(const char* name) = nullptr;
    std::string reason;  ///< why it could not be opened, a sentence

    OsmesaLibrary();
};

template <class F>
bool find(void* library, F& function, const char* name) {
    function = reinterpret_cast<F>(dlsym(library, name));
    return function != nullptr;
}

OsmesaLibrary::OsmesaLibrary() {
    void* library = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"}) {
        library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library) break;
        reason += reason.empty() ? "OSMesa is not installed (" : "; ";
        reason += dlerror();
    }
    if (!library) {
        reason += ").";
        return;
    }
    reason.clear();
    if (!find(library, createContextAttribs, "OSMesaCreateContextAttribs") ||
        !find(library, destroyContext, "OSMesaDestroyContext") ||
        !find(library, makeCurrent, "OSMesaMakeCurrent") ||
        !find(library, getProcAddress, "OSMesaGetProcAddress"))
        reason = "This libOSMesa lacks OSMesaCreateContextAttribs; Mesa 11.2 or later has it.";
}

/// Opened once and kept: the driver does not survive being unloaded.
const OsmesaLibrary& osmesa() {
    static const OsmesaLibrary library;
    return library;
}

void* loadThroughOsmesa(const char* name) { return osmesa().getProcAddress(name); }

class OsmesaContext final : public Context {
public:
    explicit OsmesaContext(OsmesaObject* object) : object_(object) {}
    ~OsmesaContext() override {
        osmesa().makeCurrent(nullptr, nullptr, 0, 0, 0);
        osmesa().destroyContext(object_);
    }

    ContextKind kind() const override { return ContextKind::osmesa; }
    void makeCurrent() override { makeCurrentWorked(); }
    GlLoader loader() const override { return loadThroughOsmesa; }

    bool makeCurrentWorked() {
        return osmesa().makeCurrent(object_, pixels_.data(), GL_UNSIGNED_BYTE, kSize, kSize);
    }

private:
    static constexpr GLsizei kSize = 16;

    OsmesaObject* object_;
    // The default framebuffer, which nobody draws to.
    std::array<uint32_t, size_t(kSize) * kSize> pixels_{};
};

}  // namespace

Result<std::unique_ptr<Context>> createOsmesaContext(const ContextOptions&) {
    const char* object = toText(ContextKind::osmesa);
    if (!osmesa().reason.empty()) return fail(object, osmesa().reason, ErrorKind::noContext);
    const int attributes[] = {kOsmesaFormat,
                              GL_RGBA,
                              kOsmesaDepthBits,
                              0,
                              kOsmesaProfile,
                              kOsmesaCoreProfile,
                              kOsmesaMajorVersion,
                              4,
                              kOsmesaMinorVersion,
                              5,
                              0};
    OsmesaObject* handle = osmesa().createContextAttribs(attributes, nullptr);
    if (!handle) return fail(object, "OSMesa refused OpenGL 4.5 core.", ErrorKind::noContext);
    auto context = std::make_unique<OsmesaContext>(handle);
    if (!context->makeCurrentWorked())
        return fail(object, "The context could not be made current.", ErrorKind::noContext);
    return context;
}

}  // namespace rushlight
