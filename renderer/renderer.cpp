#include "renderer/renderer.h"

#include "renderer/backend/gl/gl_device.h"
#include "renderer/backend/null/null_device.h"
#include "renderer/pipeline/capture_cube.h"
#include "renderer/pipeline/frame_pipeline.h"
#include "renderer/rhi/half_floats.h"
#include "renderer/rhi/threaded_device.h"

#include <algorithm>
#include <atomic>
#include <cstring>

#include <glm/gtc/packing.hpp>

namespace rushlight {

struct Renderer::State {
    LogSink log;
    std::unique_ptr<Device> device;
    ThreadedDevice* threaded = nullptr;  // `device`, in the render-thread mode
    std::atomic<bool> used{false};
    SerialJobs serialJobs;
    JobSystem* hostJobs = nullptr;
    std::unique_ptr<FramePipeline> frames;
    uint32_t lastTicket = 0;
    ViewHandle captureView;  // of captureEnvironment
    ReadbackImage readback;

    JobSystem& jobs() { return hostJobs ? *hostJobs : serialJobs; }
};

namespace {

#ifdef NDEBUG
constexpr bool kDebugBuild = false;
#else
constexpr bool kDebugBuild = true;
#endif

vec4 linearTexel(Format format, const std::byte* bytes) {
    const auto read = [bytes]<class T>(T value) {
        std::memcpy(&value, bytes, sizeof value);
        return value;
    };
    if (format == Format::depth32f) return {read(0.0f), 0, 0, 1};
    RL_CHECK(format == Format::r11g11b10f, "a capture is RGBA8, RGBA16F, R11G11B10F or a depth");
    return {glm::unpackF2x11_1x10(read(uint32_t(0))), 1};
}

// From rows at v = 0 (the bottom) to rows from the top.
void convert(const ReadbackImage& from, CapturedImage& to) {
    to.width = from.width;
    to.height = from.height;
    to.rgba8.clear();
    to.rgba32f.clear();
    const size_t rowTexels = from.width;
    if (from.format == Format::rgba8) {
        to.rgba8.resize(from.bytes.size());
        const size_t row = rowTexels * 4;
        for (uint32_t y = 0; y < from.height; ++y)
            std::memcpy(to.rgba8.data() + y * row, from.bytes.data() + (from.height - 1 - y) * row,
                        row);
        return;
    }
    to.rgba32f.resize(rowTexels * from.height * 4);
    const size_t texel = bytesPerTexel(from.format);
    for (uint32_t y = 0; y < from.height; ++y) {
        const std::byte* in = from.bytes.data() + (from.height - 1 - y) * rowTexels * texel;
        float* out = to.rgba32f.data() + y * rowTexels * 4;
        if (from.format == Format::rgba16f) {
            floatsFromHalves({in, rowTexels * texel}, {out, rowTexels * 4});
            continue;
        }
        for (size_t x = 0; x < rowTexels; ++x, in += texel, out += 4) {
            const vec4 color = linearTexel(from.format, in);
            std::memcpy(out, &color, sizeof color);
        }
    }
}

}  // namespace

// One call of a public function. Not good when the call is wrong use: then nothing may be done.
class Renderer::Use {
public:
    explicit Use(State& state) : state_(state) {
        if (state_.used.exchange(true)) {
            ok_ = fail("renderer", "two threads use it at the same time.", ErrorKind::wrongUse);
            return;
        }
        holds_ = true;
        if (state_.threaded) ok_ = state_.threaded->enter();
    }
    ~Use() {
        if (ok_ && state_.threaded) state_.threaded->leave();
        if (holds_) state_.used = false;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    explicit operator bool() const { return ok_.has_value(); }
    tl::unexpected<Error> error() const { return tl::unexpected(ok_.error()); }
    /// For functions that have no result to say it in.
    bool goodOrLogged() const {
        if (!ok_) state_.log(LogLevel::error, ok_.error().text());
        return ok_.has_value();
    }

private:
    State& state_;
    Result<void> ok_;
    bool holds_ = false;
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Renderer::~Renderer() {
    stopServing();  // nobody may
    if (state_ && state_->device) state_->device->finish();
}

Result<std::unique_ptr<Renderer>> Renderer::create(const RendererDesc& desc) {
    auto state = std::make_unique<State>();
    if (desc.framesInFlight < 1 || desc.framesInFlight > 3)
        return fail(
            "renderer",
            "framesInFlight is " + std::to_string(desc.framesInFlight) + "; it must be 1 to 3.",
            ErrorKind::wrongUse);
    if (desc.loadGl) {
        GlDeviceDesc gl;
        gl.load = desc.loadGl;
        gl.log = desc.log;
        gl.cacheDirectory = desc.cacheDirectory;
        gl.shaderDirectory = desc.shaderDirectory;
        gl.framesInFlight = desc.framesInFlight;
        gl.debugOutput = desc.debugOutput;
        auto device = createGlDevice(gl);
        if (!device) return tl::unexpected(device.error());
        state->device = std::move(*device);
    } else {
        state->device = createNullDevice();
    }
    state->log = desc.log;
    if (desc.renderThread) {
        auto threaded = std::make_unique<ThreadedDevice>(std::move(state->device),
                                                         desc.framesInFlight);
        state->threaded = threaded.get();
        state->device = std::move(threaded);
    }
    state->hostJobs = desc.jobs;
    state->frames = std::make_unique<FramePipeline>(*state->device, state->jobs(), desc.log,
                                                    desc.cacheDirectory);
    state->frames->setValidation(desc.validateCommands.value_or(kDebugBuild));
    return std::unique_ptr<Renderer>(new Renderer(std::move(state)));
}

Result<MeshHandle> Renderer::createMesh(const MeshDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.geometry.create(desc);
}
Result<void> Renderer::createMeshes(std::span<const MeshDesc> meshes,
                                    std::span<MeshHandle> handles) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->createMeshes(meshes, handles);
}
Result<void> Renderer::updateMesh(MeshHandle mesh, const MeshDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.geometry.update(mesh, desc);
}
Result<ImageHandle> Renderer::createImage(const ImageDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.textures.create(desc);
}
Result<MaterialHandle> Renderer::createMaterial(const MaterialDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.materials.create(desc);
}
Result<void> Renderer::updateMaterial(MaterialHandle material, const MaterialDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.materials.update(material, desc);
}
Result<EnvironmentHandle> Renderer::createEnvironment(const EnvironmentDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.environments.create(desc);
}
Result<EnvironmentHandle> Renderer::createPrefilteredEnvironment(
    const PrefilteredEnvironmentDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    const auto converted = convertPrefiltered(desc, state_->jobs());
    if (!converted) return tl::unexpected(converted.error());
    return state_->frames->stores.environments.create(*converted);
}
Result<PrefilteredEnvironment> Renderer::capture(const FrameInput& input, const vec3& position,
                                                 const CaptureDesc& desc) {
    const auto render = [&](const FrameInput& face, uint32_t size,
                            CapturedImage& image) -> Result<void> {
        const auto ticket = renderOffscreen(face, size, size, CaptureKind::hdr, {.timers = false});
        if (!ticket) return tl::unexpected(ticket.error());
        if (!takeCapture(*ticket, true, image))
            return fail("capture of an environment", "the context was lost.", ErrorKind::noContext);
        return {};
    };
    FrameInput seen = input;
    {
        const Use use(*state_);
        if (!use) return use.error();
        if (!state_->captureView) state_->captureView = state_->frames->createView();
        seen.view.state = state_->captureView;
    }
    auto cube = captureCube(seen, position, desc, render);
    if (!cube) return tl::unexpected(cube.error());
    return prefilterCube(std::move(*cube), state_->jobs());
}
Result<EnvironmentHandle> Renderer::captureEnvironment(const FrameInput& input,
                                                       const vec3& position,
                                                       const CaptureDesc& desc) {
    const auto captured = capture(input, position, desc);
    if (!captured) return tl::unexpected(captured.error());
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.environments.create(*captured);
}
Result<void> Renderer::recaptureEnvironment(EnvironmentHandle environment, const FrameInput& input,
                                            const vec3& position, const CaptureDesc& desc) {
    {
        const Use use(*state_);
        if (!use) return use.error();
        if (!state_->frames->stores.environments.find(environment))
            return fail("environment", "the handle is stale or none.", ErrorKind::wrongUse);
    }
    const auto captured = capture(input, position, desc);
    if (!captured) return tl::unexpected(captured.error());
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.environments.update(environment, *captured);
}
Result<DecalMaterialHandle> Renderer::createDecalMaterial(const DecalMaterialDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.decals.create(desc);
}
Result<LightProfileHandle> Renderer::createLightProfile(const LightProfileDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.lightPatterns.create(desc);
}
Result<LightCookieHandle> Renderer::createLightCookie(const LightCookieDesc& desc) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.lightPatterns.create(desc);
}
void Renderer::destroy(MeshHandle mesh) {
    const Use use(*state_);
    if (!use.goodOrLogged()) return;
    state_->frames->stores.geometry.destroy(mesh);
}
void Renderer::destroy(ImageHandle image) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.textures.destroy(image);
}
void Renderer::destroy(MaterialHandle material) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.materials.destroy(material);
}
void Renderer::destroy(EnvironmentHandle e) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.environments.destroy(e);
}
void Renderer::destroy(DecalMaterialHandle material) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.decals.destroy(material);
}
void Renderer::destroy(LightProfileHandle profile) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.lightPatterns.destroy(profile);
}
void Renderer::destroy(LightCookieHandle cookie) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.lightPatterns.destroy(cookie);
}

Result<IrradianceVolumeHandle> Renderer::createIrradianceVolume(const IrradianceVolume& volume) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.irradianceVolumes.create(volume);
}
Result<void> Renderer::updateIrradianceVolume(IrradianceVolumeHandle handle,
                                              const IrradianceVolume& volume) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.irradianceVolumes.update(handle, volume);
}
void Renderer::destroy(IrradianceVolumeHandle volume) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.irradianceVolumes.destroy(volume);
}

ViewHandle Renderer::createView() {
    const Use use(*state_);
    return use.goodOrLogged() ? state_->frames->createView() : ViewHandle{};
}
void Renderer::destroy(ViewHandle view) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->destroy(view);
}

WorldHandle Renderer::createWorld() {
    const Use use(*state_);
    return use.goodOrLogged() ? state_->frames->stores.worlds.create() : WorldHandle{};
}
void Renderer::destroy(WorldHandle world) {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->frames->stores.worlds.destroy(world);
}
Result<void> Renderer::addInstances(WorldHandle world, std::span<const Instance> instances,
                                    std::span<InstanceHandle> out) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.worlds.add(world, instances, out);
}
Result<void> Renderer::updateInstances(WorldHandle world, std::span<const InstanceHandle> handles,
                                       std::span<const Instance> instances) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.worlds.update(world, handles, instances);
}
Result<void> Renderer::removeInstances(WorldHandle world, std::span<const InstanceHandle> handles) {
    const Use use(*state_);
    if (!use) return use.error();
    return state_->frames->stores.worlds.remove(world, handles);
}

Result<void> Renderer::render(const FrameInput& input, const FrameTarget& target,
                              const FrameOptions& options) {
    const Use use(*state_);
    if (!use) return use.error();
    if (target.width == 0 || target.height == 0) return {};
    return state_->frames->render(input, target, nullptr, options);
}

Result<CaptureTicket> Renderer::renderOffscreen(const FrameInput& input, uint32_t width,
                                                uint32_t height, CaptureKind kind,
                                                const FrameOptions& options) {
    const Use use(*state_);
    if (!use) return use.error();
    FrameTarget target;
    target.width = width;
    target.height = height;
    const CaptureRequest capture{kind, ++state_->lastTicket};
    if (auto ok = state_->frames->render(input, target, &capture, options); !ok)
        return tl::unexpected(ok.error());
    return CaptureTicket{capture.ticket};
}

bool Renderer::takeCapture(CaptureTicket ticket, bool wait, CapturedImage& image) {
    const Use use(*state_);
    if (!use.goodOrLogged()) return false;
    if (!state_->device->takeReadback(ticket.value, wait, state_->readback)) return false;
    convert(state_->readback, image);
    return true;
}

const FrameReport& Renderer::report() const { return state_->frames->report(); }
std::vector<InstanceFacts> Renderer::describeInstances() const {
    const Use use(*state_);
    return use.goodOrLogged() ? state_->frames->describeInstances() : std::vector<InstanceFacts>{};
}
std::optional<MaterialDesc> Renderer::describeMaterial(MaterialHandle material) const {
    const Use use(*state_);
    const MaterialDesc* desc = use.goodOrLogged()
                                   ? state_->frames->stores.materials.describe(material)
                                   : nullptr;
    return desc ? std::optional(*desc) : std::nullopt;
}
std::string Renderer::printCommands() const { return print(state_->frames->commands()); }
std::string Renderer::printLabelledCommands() const {
    const Use use(*state_);
    if (!use.goodOrLogged()) return {};
    std::string text;
    const auto print = [&] { text = printNumbered(state_->frames->commands(), *state_->device); };
    state_->device->runInOrder([](void* f) { (*static_cast<decltype(print)*>(f))(); },
                               const_cast<void*>(static_cast<const void*>(&print)));
    return text;
}
Result<uint32_t> Renderer::reloadShaders() {
    const Use use(*state_);
    if (!use) return use.error();
    state_->frames->forgetImages();
    return state_->device->reloadShaders();
}
void Renderer::finish() {
    const Use use(*state_);
    if (use.goodOrLogged()) state_->device->finish();
}

Result<void> Renderer::serve(void (*afterFrame)(void* user), void* user) {
    if (!state_->threaded)
        return fail("renderer", "serve() needs RendererDesc::renderThread.", ErrorKind::wrongUse);
    return state_->threaded->serve(afterFrame, user);
}
void Renderer::stopServing() {
    if (state_->threaded) state_->threaded->stopServing();
}

std::string_view Renderer::deviceName() const { return state_->device->name(); }
std::string_view Renderer::deviceVersion() const { return state_->device->version(); }
std::vector<std::string> Renderer::takeDebugMessages() {
    const Use use(*state_);
    if (!use.goodOrLogged()) return {};
    return state_->device->takeDebugMessages();
}

}  // namespace rushlight
