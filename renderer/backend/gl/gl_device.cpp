#include "renderer/backend/gl/gl_device.h"

#include "renderer/backend/gl/gl_debug.h"
#include "renderer/backend/gl/gl_executor.h"
#include "renderer/rhi/validate.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace rushlight {
namespace {

constexpr GLenum kMaxTextureMaxAnisotropy = 0x84FF;  // GL_EXT_texture_filter_anisotropic, core 4.6

std::string textOf(const GlFunctions& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

GLint integerOf(const GlFunctions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

bool hasExtension(const GlFunctions& gl, const char* name) {
    const GLint count = integerOf(gl, GL_NUM_EXTENSIONS);
    for (GLint i = 0; i < count; ++i)
        if (std::strcmp(reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i))),
                        name) == 0)
            return true;
    return false;
}

float maxAnisotropyOf(const GlFunctions& gl) {
    if (!hasExtension(gl, "GL_EXT_texture_filter_anisotropic") &&
        !hasExtension(gl, "GL_ARB_texture_filter_anisotropic"))
        return 1;
    return float(integerOf(gl, kMaxTextureMaxAnisotropy));
}

DeviceLimits limitsOf(const GlFunctions& gl) {
    DeviceLimits limits;
    limits.textureSize = uint32_t(integerOf(gl, GL_MAX_TEXTURE_SIZE));
    limits.cubeSize = uint32_t(integerOf(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE));
    limits.textureLayers = uint32_t(integerOf(gl, GL_MAX_ARRAY_TEXTURE_LAYERS));
    return limits;
}

uint32_t offsetAlignmentOf(const GlFunctions& gl) {
    return uint32_t(std::max(integerOf(gl, GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT),
                             integerOf(gl, GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT)));
}

class GlDevice final : public Device {
public:
    GlDevice(std::unique_ptr<GlFunctions> functions, const GlDeviceDesc& desc)
        : functions_(std::move(functions)),
          gl_(*functions_),
          name_(textOf(gl_, GL_RENDERER)),
          version_(textOf(gl_, GL_VERSION)),
          limits_(limitsOf(gl_)),
          maxAnisotropy_(maxAnisotropyOf(gl_)),
          debug_(gl_, desc.debugOutput),
          state_(gl_),
          resources_(gl_),
          programs_(gl_, state_, desc.shaderDirectory, desc.cacheDirectory, desc.log),
          vertexArrays_(gl_, state_),
          ring_(gl_, desc.framesInFlight, offsetAlignmentOf(gl_)),
          timers_(gl_),
          readback_(gl_) {}
    ~GlDevice() override {
        for (const GlTexelUnit& unit : texelUnits_)
            if (unit.texture) gl_.DeleteTextures(1, &unit.texture);
    }

    Result<void> prepare() { return isLost() ? status_ : ring_.prepare(); }
    std::string_view name() const override { return name_; }
    std::string_view version() const override { return version_; }

    Result<BufferHandle> createBuffer(const BufferDesc& desc) override {
        if (isLost()) return tl::unexpected(status_.error());
        if (auto valid = validate(desc, limits_); !valid) return tl::unexpected(valid.error());
        return resources_.createBuffer(desc).map(
            [&](GlBuffer&& made) { return resources_.buffers.insert(std::move(made)); });
    }
    Result<TextureHandle> createTexture(const TextureDesc& desc) override {
        if (isLost()) return tl::unexpected(status_.error());
        if (auto valid = validate(desc, limits_); !valid) return tl::unexpected(valid.error());
        return resources_.createTexture(desc).map(
            [&](GlTexture&& made) { return resources_.textures.insert(std::move(made)); });
    }
    SamplerHandle createSampler(const SamplerDesc& desc) override;
    Result<PipelineHandle> createPipeline(const PipelineDesc& desc) override;
    void destroy(BufferHandle handle) override;
    void destroy(TextureHandle handle) override;
    void write(BufferHandle handle, uint64_t offset, std::span<const std::byte> data) override;
    void write(TextureHandle handle, const TextureRegion& region,
               std::span<const std::byte> data) override;
    void copy(BufferHandle from, BufferHandle to, uint64_t size) override;
    std::optional<BufferDesc> describe(BufferHandle handle) const override;
    std::optional<TextureDesc> describe(TextureHandle handle) const override;
    std::optional<SamplerDesc> describe(SamplerHandle handle) const override;
    std::optional<PipelineDesc> describe(PipelineHandle handle) const override;
    const PipelineSlots* slots(PipelineHandle handle) const override {
        const GlPipeline* pipeline = resources_.pipelines.find(handle);
        return pipeline ? &programs_.slots(pipeline->program) : nullptr;
    }
    void read(BufferHandle handle, uint64_t offset, std::span<std::byte> out) override;
    void read(TextureHandle handle, uint32_t mipLevel, uint32_t layer,
              std::span<std::byte> out) override;
    void execute(const CommandBuffer& commands, const ExecuteOptions& options,
                 ExecutionReport& report) override;
    bool takeReadback(uint32_t ticket, bool wait, ReadbackImage& image) override {
        return !isLost() && readback_.take(ticket, wait, image);
    }
    Result<void> status() const override { return status_; }
    Result<void> takeFailure() override { return std::exchange(failure_, {}); }
    uint64_t compiledPrograms() const override { return programs_.compiled(); }
    Result<uint32_t> reloadShaders() override { return programs_.reload(); }
    void finish() override { gl_.Finish(); }
    std::vector<std::string> takeDebugMessages() override { return debug_.take(); }

private:
    void forgetBuffer(GLuint name);
    bool isLost();
    void note(const Result<void>& outcome);

    std::unique_ptr<GlFunctions> functions_;
    GlFunctions& gl_;
    std::string name_, version_;
    DeviceLimits limits_;
    float maxAnisotropy_;
    GlDebug debug_;
    GlState state_;
    GlResources resources_;
    GlPrograms programs_;
    GlVertexArrays vertexArrays_;
    GlUploadRing ring_;
    GlTimers timers_;
    GlReadback readback_;
    GlTexelUnits texelUnits_{};
    Result<void> status_, failure_;
};

bool GlDevice::isLost() {
    if (!status_) return true;
    const GLenum reset = gl_.resetStatus();
    if (reset == GL_NO_ERROR) return false;
    const char* const whose = reset == GL_GUILTY_CONTEXT_RESET     ? "by something this context did"
                              : reset == GL_INNOCENT_CONTEXT_RESET ? "by something outside of it"
                                                                   : "for an unknown reason";
    status_ = fail("OpenGL",
                   std::string("the context was reset, ") + whose +
                       "; its objects are gone. Destroy the renderer and create another one "
                       "in a new context.",
                   ErrorKind::noContext);
    return true;
}

// Of a context that is gone that is the reason, and not what came of it.
void GlDevice::note(const Result<void>& outcome) {
    if (outcome || isLost()) return;
    if (failure_) failure_ = outcome;
}

SamplerHandle GlDevice::createSampler(const SamplerDesc& desc) {
    SamplerHandle equal;
    resources_.samplers.forEach([&](SamplerHandle handle, const GlSampler& sampler) {
        if (sampler.desc == desc) equal = handle;
    });
    return equal ? equal
                 : resources_.samplers.insert(resources_.createSampler(desc, maxAnisotropy_));
}

Result<PipelineHandle> GlDevice::createPipeline(const PipelineDesc& desc) {
    if (isLost()) return tl::unexpected(status_.error());
    if (Result<void> valid = validate(desc); !valid) return tl::unexpected(valid.error());
    return programs_.get(desc).map([&](uint32_t program) {
        return resources_.pipelines.insert(
            {program,
             desc.layout,
             desc.movingInstances,
             desc.lines,
             {desc.cull, desc.depthTest, desc.depthWrite, desc.depthClamp, desc.depthBias,
              desc.depthBiasSlope, desc.blend},
             std::string(desc.label)});
    });
}

std::optional<BufferDesc> GlDevice::describe(BufferHandle handle) const {
    const GlBuffer* buffer = resources_.buffers.find(handle);
    if (!buffer) return {};
    return BufferDesc{buffer->label, buffer->size, buffer->usage};
}

std::optional<TextureDesc> GlDevice::describe(TextureHandle handle) const {
    const GlTexture* t = resources_.textures.find(handle);
    if (!t) return {};
    return TextureDesc{t->label, t->kind, t->format, t->width, t->height, t->layers, t->mipLevels};
}

std::optional<SamplerDesc> GlDevice::describe(SamplerHandle handle) const {
    const GlSampler* sampler = resources_.samplers.find(handle);
    if (!sampler) return {};
    return sampler->desc;
}

std::optional<PipelineDesc> GlDevice::describe(PipelineHandle handle) const {
    const GlPipeline* pipeline = resources_.pipelines.find(handle);
    if (!pipeline) return {};
    PipelineDesc desc = programs_.describe(pipeline->program);
    desc.label = pipeline->label;
    desc.layout = pipeline->layout;
    desc.movingInstances = pipeline->movingInstances;
    desc.lines = pipeline->lines;
    desc.cull = pipeline->fixed.cull;
    desc.depthTest = pipeline->fixed.depthTest;
    desc.depthWrite = pipeline->fixed.depthWrite;
    desc.depthClamp = pipeline->fixed.depthClamp;
    desc.depthBias = pipeline->fixed.depthBias;
    desc.depthBiasSlope = pipeline->fixed.depthBiasSlope;
    desc.blend = pipeline->fixed.blend;
    return desc;
}

// GL keeps a deleted object's memory until the GPU is done with it; only names must be forgotten.

void GlDevice::forgetBuffer(GLuint name) {
    state_.forgetBuffer(name);
    vertexArrays_.forgetBuffer(name);
    for (GlTexelUnit& unit : texelUnits_)
        if (unit.buffer == name) unit.buffer = 0;
}

void GlDevice::destroy(BufferHandle handle) {
    const GlBuffer* buffer = resources_.buffers.find(handle);
    if (!buffer) return;
    forgetBuffer(buffer->name);
    gl_.DeleteBuffers(1, &buffer->name);
    resources_.buffers.erase(handle);
}

void GlDevice::destroy(TextureHandle handle) {
    const GlTexture* texture = resources_.textures.find(handle);
    if (!texture) return;
    resources_.forgetFramebuffers(handle);
    state_.forgetTexture(texture->name);
    gl_.DeleteTextures(1, &texture->name);
    resources_.textures.erase(handle);
}

void GlDevice::write(BufferHandle handle, uint64_t offset, std::span<const std::byte> data) {
    const GlBuffer& buffer = resources_.buffer(handle);
    RL_CHECK(offset <= buffer.size && data.size() <= buffer.size - offset,
             "a write goes beyond the end of its buffer");
    if (data.empty()) return;
    gl_.NamedBufferSubData(buffer.name, GLintptr(offset), GLsizeiptr(data.size()), data.data());
}

void GlDevice::write(TextureHandle handle, const TextureRegion& region,
                     std::span<const std::byte> data) {
    const GlTexture& texture = resources_.texture(handle);
    RL_CHECK(data.size() == byteSize(texture.format, region),
             "a texture write has not the bytes of its region");
    resources_.write(texture, region, data.data());
}

void GlDevice::copy(BufferHandle from, BufferHandle to, uint64_t size) {
    const GlBuffer& source = resources_.buffer(from);
    const GlBuffer& destination = resources_.buffer(to);
    RL_CHECK(size <= source.size && size <= destination.size,
             "a copy goes beyond the end of a buffer");
    if (size == 0) return;
    gl_.CopyNamedBufferSubData(source.name, destination.name, 0, 0, GLsizeiptr(size));
}

void GlDevice::read(BufferHandle handle, uint64_t offset, std::span<std::byte> out) {
    const GlBuffer& buffer = resources_.buffer(handle);
    RL_CHECK(offset <= buffer.size && out.size() <= buffer.size - offset,
             "a read goes beyond the end of its buffer");
    if (!out.empty())
        gl_.GetNamedBufferSubData(buffer.name, GLintptr(offset), GLsizeiptr(out.size()),
                                  out.data());
}

void GlDevice::read(TextureHandle handle, uint32_t mipLevel, uint32_t layer,
                    std::span<std::byte> out) {
    const auto desc = describe(handle);
    RL_CHECK(desc && mipLevel < desc->mipLevels && layer < desc->layers,
             "a read names a texture, mip level or layer that does not exist");
    RL_CHECK(out.size() == imageBytes(*desc, mipLevel),
             "a texture read has not the bytes of its image");
    readback_.read(resources_.texture(handle), layer, mipLevel, out);
}

void GlDevice::execute(const CommandBuffer& commands, const ExecuteOptions& options,
                       ExecutionReport& report) {
    using Clock = std::chrono::steady_clock;
    report.begin();
    if (options.timers) timers_.compareClocks();
    functions_->calls = 0;
    if (isLost()) return;
    state_.resetCount();

    const Result<void> room = ring_.begin(commands.data());
    if (const GLuint replaced = ring_.takeReplaced()) forgetBuffer(replaced);
    if (!room) return note(room);
    state_.invalidate();
    timers_.beginFrame(options.timers, options.frame, report.began);
    report.gpuFrame = timers_.newestFrame();
    GlExecutor executor(
        {gl_, state_, resources_, programs_, vertexArrays_, ring_, timers_, readback_, texelUnits_},
        options, report);
    visitCommands(commands, [&](const auto& command) {
        if (executor.outcome()) executor(command);
    });
    note(executor.outcome());
    timers_.endFrame();
    state_.resetToDefaults();
    ring_.end();
    gl_.Flush();

    report.glCalls = functions_->calls - executor.looking().calls;
    report.stateChanges = state_.changes() - executor.looking().changes;
    report.uploadedBytes = commands.data().size();
    report.waits = ring_.waits();
    report.cpuMs = std::chrono::duration<double, std::milli>(Clock::now() - report.began).count() -
                   executor.looking().ms;
}

}  // namespace

Result<std::unique_ptr<Device>> createGlDevice(const GlDeviceDesc& desc) {
    auto functions = std::make_unique<GlFunctions>();
    if (Result<void> loaded = functions->load(desc.load); !loaded)
        return tl::unexpected(loaded.error());
    auto device = std::make_unique<GlDevice>(std::move(functions), desc);
    if (Result<void> ready = device->prepare(); !ready) return tl::unexpected(ready.error());
    return std::unique_ptr<Device>(std::move(device));
}

}  // namespace rushlight
