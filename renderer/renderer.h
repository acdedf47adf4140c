#pragma once
// The one header an embedder includes. A guest in the host's context: no window, no thread, no
// global of its own; no GL state is assumed at entry; at exit the framebuffer, program, vertex
// array, buffer, texture-unit and sampler bindings are zero and the fixed state is GL's default
// (see renderer/README.md). A Renderer is used by one thread at a time: the one on which the
// host's context is current. With RendererDesc::renderThread that thread may execute frames, in
// serve(), while another one builds the next.

#include "engine/core/jobs.h"
#include "engine/core/log.h"
#include "engine/core/result.h"
#include "renderer/frame/captured_image.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/frame_options.h"
#include "renderer/frame/frame_report.h"
#include "renderer/frame/instance_facts.h"
#include "renderer/frame/quality.h"
#include "renderer/lighting/irradiance_volume.h"
#include "renderer/rhi/resources.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rushlight {

using GlLoadFunction = void* (*)(const char* name);

struct PrefilteredEnvironment;

struct RendererDesc {
    /// Returns the address of a GL function, as glfwGetProcAddress and eglGetProcAddress do. Null:
    /// the null backend, which accepts and counts everything and draws nothing.
    GlLoadFunction loadGl = nullptr;
    JobSystem* jobs = nullptr;  ///< null: everything on the calling thread. Must outlive the
                                ///< renderer.
    LogSink log = {};
    std::string cacheDirectory = {};   ///< program binaries and prefiltered environments; empty: no
                                       ///< cache on disk
    std::string shaderDirectory = {};  ///< read shaders from here instead of those compiled in;
                                       ///< enables reloadShaders()
    uint32_t framesInFlight = 2;  ///< 1 to 3: on the GPU; and as many between render() and serve()
    bool renderThread = false;    ///< serve() will be called; see there
    bool debugOutput = false;     ///< collect GL debug messages, see takeDebugMessages()
    /// Check every frame's commands before they are executed (CommandValidator); what is wrong is
    /// render()'s Error. Nothing: where the library is a debug build.
    std::optional<bool> validateCommands = {};
};

class Renderer {
public:
    /// Fails with ErrorKind::noContext when the context is not OpenGL 4.5 or lacks something that
    /// is needed (named).
    static Result<std::unique_ptr<Renderer>> create(const RendererDesc& desc);
    ~Renderer();

    // Resources. Creating copies the data; a bad description is an Error that names the label.
    // Destroying while frames in flight use the resource is safe.
    Result<MeshHandle> createMesh(const MeshDesc&);
    /// Many at once, faster: RendererDesc::jobs makes their levels of detail. `handles` is as long
    /// as `meshes`; an Error names the first bad one, and then none is made.
    Result<void> createMeshes(std::span<const MeshDesc> meshes, std::span<MeshHandle> handles);
    /// New vertex positions (and normals, tangents) for a mesh with the same number of vertices.
    /// Its triangles, and those of its levels of detail, stay.
    Result<void> updateMesh(MeshHandle, const MeshDesc&);
    Result<ImageHandle> createImage(const ImageDesc&);
    Result<MaterialHandle> createMaterial(const MaterialDesc&);
    Result<void> updateMaterial(MaterialHandle, const MaterialDesc&);
    Result<EnvironmentHandle> createEnvironment(const EnvironmentDesc&);
    Result<EnvironmentHandle> createPrefilteredEnvironment(const PrefilteredEnvironmentDesc&);
    /// The scene around a place as an environment, as for Lighting::reflectionProbes: six frames
    /// into images of the renderer's own, read back and prefiltered. Of `input` the view is not
    /// used, and what hangs on a view is off (reflections of the screen, the sun's disk, whose
    /// light is in the highlights, and overlays); an environment is the background. Its own
    /// reflectionProbes are mirrored as given: none for a first bounce, the first's for a second.
    /// Slow: for loading, or to be spread by the host. Wrong input is an Error as in render; as
    /// frames, captures move the worlds' previous transforms.
    Result<EnvironmentHandle> captureEnvironment(const FrameInput&, const vec3& position,
                                                 const CaptureDesc& = {});
    /// Anew, under the same handle. After an Error the old one stays.
    Result<void> recaptureEnvironment(EnvironmentHandle, const FrameInput&, const vec3& position,
                                      const CaptureDesc& = {});
    Result<DecalMaterialHandle> createDecalMaterial(const DecalMaterialDesc&);
    Result<LightProfileHandle> createLightProfile(const LightProfileDesc&);
    Result<LightCookieHandle> createLightCookie(const LightCookieDesc&);
    void destroy(MeshHandle);
    void destroy(ImageHandle);
    void destroy(MaterialHandle);
    void destroy(EnvironmentHandle);
    /// Copied. Baked by renderer/raytrace/probe_bake.h or read from a file; for
    /// Lighting::irradianceVolume.
    Result<IrradianceVolumeHandle> createIrradianceVolume(const IrradianceVolume&);
    /// Other light for the same grid and distances, as of a ProbeUpdater.
    Result<void> updateIrradianceVolume(IrradianceVolumeHandle, const IrradianceVolume&);
    void destroy(IrradianceVolumeHandle);
    void destroy(DecalMaterialHandle);
    void destroy(LightProfileHandle);
    void destroy(LightCookieHandle);

    /// What a view remembers from frame to frame, for View::state: exposure, where the camera and
    /// objects were, levels of detail, shadow maps. Any number of views may be rendered in one step
    /// and do not disturb each other; a frame that fails leaves its view as it was. Whoever renders
    /// one view needs none: View::state is zero for the default one. Environments are captured with
    /// one of the renderer's own.
    ViewHandle createView();
    void destroy(ViewHandle);

    // Worlds: instances that the renderer keeps, so that a frame costs what is seen and what
    // changed, not what exists. An instance that was updated moves from where its view saw it last;
    // Instance::previousTransform and kInstanceMoving are not looked at. A stale handle is an
    // Error, and then nothing is done.
    WorldHandle createWorld();
    void destroy(WorldHandle);
    /// Handles of the new instances into `out`, which is as long. A world holds at most 1,048,575.
    Result<void> addInstances(WorldHandle, std::span<const Instance>,
                              std::span<InstanceHandle> out);
    Result<void> updateInstances(WorldHandle, std::span<const InstanceHandle>,
                                 std::span<const Instance>);
    Result<void> removeInstances(WorldHandle, std::span<const InstanceHandle>);

    /// Builds the frame, records and executes it into the host's framebuffer. Wrong input (a view
    /// that is not finite, too many lights) is an Error and nothing is drawn; single bad instances
    /// are left out, counted in FrameReport::rejected and logged once. A target without width or
    /// height, as of a minimised window, is no error: nothing is built, drawn or reported. Once the
    /// context is lost every frame is an Error of ErrorKind::noContext.
    Result<void> render(const FrameInput&, const FrameTarget&, const FrameOptions& = {});

    /// As render, into an image of the renderer's own. The ticket is good until it is taken.
    Result<CaptureTicket> renderOffscreen(const FrameInput&, uint32_t width, uint32_t height,
                                          CaptureKind, const FrameOptions& = {});

    /// The captured image, or nothing while the GPU is not done (never, when `wait`; but nothing
    /// from a lost context).
    bool takeCapture(CaptureTicket, bool wait, CapturedImage& image);

    /// What the last render did. The GPU times are those of the last frame whose queries are back.
    /// Good until the next call of render, renderOffscreen or report.
    const FrameReport& report() const;

    // Answers for tools (renderer/answers); slow.

    /// All instances of the last frame, the kept world's first.
    std::vector<InstanceFacts> describeInstances() const;
    /// What a material was made of, without its label; of a zero handle the default. Nothing for a
    /// stale one.
    std::optional<MaterialDesc> describeMaterial(MaterialHandle) const;

    /// The commands of the last frame as text.
    std::string printCommands() const;
    /// The same with the commands' numbers from 1 and the labels of what they use.
    std::string printLabelledCommands() const;

    /// Loads changed shaders. An Error holds the messages; the last good programs stay in use.
    Result<uint32_t> reloadShaders();

    /// Blocks until the GPU is done.
    void finish();

    // The render-thread mode. The renderer is created, and later destroyed, where its context is
    // current; that thread calls serve() and another one everything else. render() then returns
    // when the frame is built and handed over: with framesInFlight frames waiting, it waits
    // (FrameReport::queueWaits). Creating and updating resources waits for the frames before it, so
    // it belongs to loading; a warm frame has none (FrameReport::synchronousCalls). Wrong use is an
    // Error, or logged where a function has no result: serving twice, using the renderer on two
    // threads at once, on the serving thread, or elsewhere than there when nobody serves any more.
    // Calls that come before the first serve() wait for it. While nobody serves, the thread of the
    // context uses it as without the mode.

    /// Executes frames as they come, until stopServing(). `afterFrame(user)` is called after each
    /// frame into the host's framebuffer: swap buffers there. What else it does on the context is
    /// as between two frames.
    Result<void> serve(void (*afterFrame)(void* user) = nullptr, void* user = nullptr);

    /// Any thread. Lets serve() execute what was handed over and return; waits for that, except
    /// from `afterFrame`.
    void stopServing();

    std::string_view deviceName() const;
    std::string_view deviceVersion() const;
    std::vector<std::string> takeDebugMessages();

private:
    Result<PrefilteredEnvironment> capture(const FrameInput&, const vec3& position,
                                           const CaptureDesc&);
    struct State;
    class Use;
    explicit Renderer(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

}  // namespace rushlight
