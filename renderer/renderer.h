#pragma once
// The one header an embedder includes. A guest in the host's context: no window, no thread, no global of its own;
// no GL state is assumed at entry; at exit the framebuffer, program, vertex array, buffer, texture-unit and sampler
// bindings are zero and the fixed state is GL's default (see the README, "Embedding").
// A Renderer is used by one thread at a time: the one on which the host's context is current.

#include "engine/core/jobs.h"
#include "engine/core/log.h"
#include "engine/core/result.h"
#include "renderer/commands/resources.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/frame_report.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rushlight {

using GlLoadFunction = void* (*)(const char* name);

struct RendererDesc {
    /// Returns the address of a GL function, as glfwGetProcAddress and eglGetProcAddress do. Null: the null backend,
    /// which accepts and counts everything and draws nothing.
    GlLoadFunction loadGl = nullptr;
    JobSystem* jobs = nullptr;  ///< null: everything on the calling thread. Must outlive the renderer.
    LogSink log = {};
    std::string cacheDirectory = {};   ///< program binaries and prefiltered environments; empty: no cache on disk
    std::string shaderDirectory = {};  ///< read shaders from here instead of those compiled in; enables reloadShaders()
    uint32_t framesInFlight = 2;  ///< 1 to 3
    bool debugOutput = false;     ///< collect GL debug messages, see takeDebugMessages()
    /// Check every frame's commands before they are executed (CommandValidator); what is wrong is render()'s Error.
    /// Nothing: where the library is a debug build.
    std::optional<bool> validateCommands = {};
};

struct FrameOptions {
    bool hashPasses = false;  ///< fill PassReport::hashes; slow
    bool timers = true;       ///< GPU timer queries around each pass
    /// Gets the frame as an RLF file (renderer/commands/frame_file.h) before it is executed; slow.
    std::vector<std::byte>* savedFrame = nullptr;
};

/// Pixels that came back. Rows from the top of the picture.
struct CapturedImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba8;  ///< sRGB, straight alpha; or
    std::vector<float> rgba32f;  ///< linear radiance times exposure, premultiplied alpha
};

enum class CaptureKind : uint8_t {
    display,  ///< what is presented: tone mapped, 8 bit sRGB
    hdr,      ///< linear, before exposure and tone mapping
};

/// Names a capture that was asked for.
struct CaptureTicket {
    uint32_t value = 0;
    explicit operator bool() const { return value != 0; }
};

class Renderer {
public:
    /// Fails with ErrorKind::noContext when the context is not OpenGL 4.5 or lacks something that is needed (named).
    static Result<std::unique_ptr<Renderer>> create(const RendererDesc& desc);
    ~Renderer();

    // Resources. Creating copies the data; a bad description is an Error that names the label. Destroying while
    // frames in flight use the resource is safe.
    Result<MeshHandle> createMesh(const MeshDesc&);
    /// New vertex positions (and normals, tangents) for a mesh with the same number of vertices.
    Result<void> updateMesh(MeshHandle, const MeshDesc&);
    Result<ImageHandle> createImage(const ImageDesc&);
    Result<MaterialHandle> createMaterial(const MaterialDesc&);
    Result<void> updateMaterial(MaterialHandle, const MaterialDesc&);
    Result<EnvironmentHandle> createEnvironment(const EnvironmentDesc&);
    void destroy(MeshHandle);
    void destroy(ImageHandle);
    void destroy(MaterialHandle);
    void destroy(EnvironmentHandle);

    /// Builds the frame, records and executes it into the host's framebuffer. Wrong input (a size of zero, a view that
    /// is not finite, too many lights) is an Error and nothing is drawn; single bad instances are left out, counted
    /// in FrameReport::rejected and logged once.
    Result<void> render(const FrameInput&, const FrameTarget&, const FrameOptions& = {});

    /// As render, into an image of the renderer's own. The ticket is good until it is taken.
    Result<CaptureTicket> renderOffscreen(const FrameInput&, uint32_t width, uint32_t height,
                                          CaptureKind, const FrameOptions& = {});

    /// The captured image, or nothing while the GPU is not done (never, when `wait`).
    bool takeCapture(CaptureTicket, bool wait, CapturedImage& image);

    /// What the last render did. The GPU times are those of the last frame whose queries are back.
    const FrameReport& report() const;

    /// The commands of the last frame as text.
    std::string printCommands() const;

    /// Loads changed shaders. An Error holds the messages; the last good programs stay in use.
    Result<uint32_t> reloadShaders();

    /// Blocks until the GPU is done.
    void finish();

    std::string_view deviceName() const;
    std::string_view deviceVersion() const;
    std::vector<std::string> takeDebugMessages();

private:
    struct State;
    explicit Renderer(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

}  // namespace rushlight
