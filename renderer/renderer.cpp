#include "renderer/renderer.h"

#include "renderer/backend/gl/gl_device.h"
#include "renderer/backend/null/null_device.h"
#include "renderer/frame_renderer.h"

#include <algorithm>
#include <cstring>

#include <glm/gtc/packing.hpp>

namespace rushlight {

struct Renderer::State {
    std::unique_ptr<Device> device;
    SerialJobs serialJobs;
    std::unique_ptr<FrameRenderer> frames;
    uint32_t lastTicket = 0;
    ReadbackImage readback;
};

namespace {

#ifdef NDEBUG
constexpr bool kDebugBuild = false;
#else
constexpr bool kDebugBuild = true;
#endif

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
            std::memcpy(to.rgba8.data() + y * row,
                        from.bytes.data() + (from.height - 1 - y) * row, row);
        return;
    }
    RL_CHECK(from.format == Format::rgba16f, "a capture is RGBA8 or RGBA16F");
    to.rgba32f.resize(rowTexels * from.height * 4);
    for (uint32_t y = 0; y < from.height; ++y) {
        const std::byte* in = from.bytes.data() + (from.height - 1 - y) * rowTexels * 8;
        float* out = to.rgba32f.data() + y * rowTexels * 4;
        for (size_t x = 0; x < rowTexels * 4; ++x) {
            uint16_t half;
            std::memcpy(&half, in + x * 2, 2);
            out[x] = glm::unpackHalf1x16(half);
        }
    }
}

}  // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Renderer::~Renderer() {
    if (state_ && state_->device) state_->device->finish();
}

Result<std::unique_ptr<Renderer>> Renderer::create(const RendererDesc& desc) {
    auto state = std::make_unique<State>();
    if (desc.framesInFlight < 1 || desc.framesInFlight > 3)
        return fail("renderer", "framesInFlight is " + std::to_string(desc.framesInFlight) +
                                    "; it must be 1 to 3.",
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
    JobSystem& jobs = desc.jobs ? *desc.jobs : state->serialJobs;
    state->frames = std::make_unique<FrameRenderer>(*state->device, jobs, desc.log,
                                                    desc.cacheDirectory);
    state->frames->setValidation(desc.validateCommands.value_or(kDebugBuild));
    return std::unique_ptr<Renderer>(new Renderer(std::move(state)));
}

Result<MeshHandle> Renderer::createMesh(const MeshDesc& desc) {
    return state_->frames->geometry.create(desc);
}
Result<void> Renderer::updateMesh(MeshHandle mesh, const MeshDesc& desc) {
    state_->frames->forgetCaches();
    return state_->frames->geometry.update(mesh, desc);
}
Result<ImageHandle> Renderer::createImage(const ImageDesc& desc) {
    return state_->frames->textures.create(desc);
}
Result<MaterialHandle> Renderer::createMaterial(const MaterialDesc& desc) {
    return state_->frames->materials.create(desc);
}
Result<void> Renderer::updateMaterial(MaterialHandle material, const MaterialDesc& desc) {
    return state_->frames->materials.update(material, desc);
}
Result<EnvironmentHandle> Renderer::createEnvironment(const EnvironmentDesc& desc) {
    return state_->frames->environments.create(desc);
}
void Renderer::destroy(MeshHandle mesh) {
    state_->frames->forgetCaches();
    state_->frames->geometry.destroy(mesh);
}
void Renderer::destroy(ImageHandle image) { state_->frames->textures.destroy(image); }
void Renderer::destroy(MaterialHandle material) { state_->frames->materials.destroy(material); }
void Renderer::destroy(EnvironmentHandle e) { state_->frames->environments.destroy(e); }

Result<void> Renderer::render(const FrameInput& input, const FrameTarget& target,
                              const FrameOptions& options) {
    FrameOutput output;
    output.target = target;
    return state_->frames->render(input, output, options);
}

Result<CaptureTicket> Renderer::renderOffscreen(const FrameInput& input, uint32_t width,
                                                uint32_t height, CaptureKind kind,
                                                const FrameOptions& options) {
    FrameOutput output;
    output.target.width = width;
    output.target.height = height;
    output.offscreen = true;
    output.hdr = kind == CaptureKind::hdr;
    output.ticket = ++state_->lastTicket;
    if (auto ok = state_->frames->render(input, output, options); !ok)
        return tl::unexpected(ok.error());
    return CaptureTicket{output.ticket};
}

bool Renderer::takeCapture(CaptureTicket ticket, bool wait, CapturedImage& image) {
    if (!state_->device->takeReadback(ticket.value, wait, state_->readback)) return false;
    convert(state_->readback, image);
    return true;
}

const FrameReport& Renderer::report() const { return state_->frames->report(); }
std::string Renderer::printCommands() const { return print(state_->frames->commands()); }
Result<uint32_t> Renderer::reloadShaders() {
    state_->frames->forgetCaches();
    return state_->device->reloadShaders();
}
void Renderer::finish() { state_->device->finish(); }
std::string_view Renderer::deviceName() const { return state_->device->name(); }
std::string_view Renderer::deviceVersion() const { return state_->device->version(); }
std::vector<std::string> Renderer::takeDebugMessages() {
    return state_->device->takeDebugMessages();
}

}  // namespace rushlight
