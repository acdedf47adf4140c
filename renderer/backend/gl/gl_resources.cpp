#include "renderer/backend/gl/gl_resources.h"

#include "renderer/backend/gl/gl_enums.h"
#include "renderer/backend/gl/gl_readback.h"
#include "renderer/backend/gl/gl_storage.h"

#include <algorithm>
#include <cstdio>

namespace rushlight {
namespace {

// GL_TEXTURE_MAX_ANISOTROPY, core since 4.6; the same value in GL_EXT_texture_filter_anisotropic.
constexpr GLenum kMaxAnisotropy = 0x84FE;

GlAttachments attachmentsOf(const BeginPass& pass) {
    GlAttachments attachments;
    for (uint32_t i = 0; i < pass.colorCount; ++i)
        attachments.colors[i] = {pass.colors[i].texture, pass.colors[i].mipLevel,
                                 pass.colors[i].layer};
    attachments.depth = {pass.depth.texture, 0, pass.depth.layer};
    return attachments;
}

// Samplers are shared by all that need an equal one: named after what they do.
std::string labelOf(const SamplerDesc& desc) {
    constexpr const char* kWraps[] = {"repeat", "clamp", "mirror"};
    const auto filter = [](TextureFilter f) {
        return f == TextureFilter::linear ? "linear" : "nearest";
    };
    std::string label = std::string("sampler ") + filter(desc.minify);
    if (desc.useMipmaps) label += std::string(" mip ") + filter(desc.mipmap);
    label += std::string(" ") + kWraps[size_t(desc.wrapU)];
    if (desc.wrapV != desc.wrapU) label += std::string("/") + kWraps[size_t(desc.wrapV)];
    if (desc.compareGreaterEqual) label += " compare";
    return label;
}

}  // namespace

GlResources::~GlResources() {
    for (const Framebuffer& framebuffer : framebuffers_)
        gl_.DeleteFramebuffers(1, &framebuffer.name);
    buffers.forEach([&](BufferHandle, GlBuffer& buffer) { gl_.DeleteBuffers(1, &buffer.name); });
    textures.forEach(
        [&](TextureHandle, GlTexture& texture) { gl_.DeleteTextures(1, &texture.name); });
    samplers.forEach(
        [&](SamplerHandle, GlSampler& sampler) { gl_.DeleteSamplers(1, &sampler.name); });
}

Result<GlBuffer> GlResources::createBuffer(const BufferDesc& desc) {
    GlBuffer buffer{0, desc.size, desc.usage, std::string(desc.label)};
    gl_.CreateBuffers(1, &buffer.name);
    if (auto made = makeBufferStorage(gl_, buffer.name, desc.label, desc.size,
                                      GL_DYNAMIC_STORAGE_BIT);
        !made) {
        gl_.DeleteBuffers(1, &buffer.name);
        return tl::unexpected(made.error());
    }
    return buffer;
}

Result<GlTexture> GlResources::createTexture(const TextureDesc& desc) {
    GlTexture texture{0,           desc.kind,   desc.format,    desc.width,
                      desc.height, desc.layers, desc.mipLevels, std::string(desc.label)};
    const GLenum target = glTarget(desc.kind);
    gl_.CreateTextures(target, 1, &texture.name);
    if (auto made = makeTextureStorage(gl_, texture.name, target, desc); !made) {
        gl_.DeleteTextures(1, &texture.name);
        return tl::unexpected(made.error());
    }
    // Read without a sampler object a texture is fetched from; integer formats are incomplete when
    // filtered.
    gl_.TextureParameteri(texture.name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TextureParameteri(texture.name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

GlSampler GlResources::createSampler(const SamplerDesc& desc, float maxAnisotropy) {
    GlSampler sampler{0, desc};
    gl_.CreateSamplers(1, &sampler.name);
    const auto set = [&](GLenum name, GLenum value) {
        gl_.SamplerParameteri(sampler.name, name, GLint(value));
    };
    set(GL_TEXTURE_WRAP_S, glWrap(desc.wrapU));
    set(GL_TEXTURE_WRAP_T, glWrap(desc.wrapV));
    set(GL_TEXTURE_MAG_FILTER, glMagnify(desc.magnify));
    set(GL_TEXTURE_MIN_FILTER, glMinify(desc));
    if (desc.compareGreaterEqual) {
        set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        set(GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    }
    const float anisotropy = std::min(desc.maxAnisotropy, maxAnisotropy);
    if (anisotropy > 1) gl_.SamplerParameterf(sampler.name, kMaxAnisotropy, anisotropy);
    gl_.label(GL_SAMPLER, sampler.name, labelOf(desc));
    return sampler;
}

void GlResources::write(const GlTexture& texture, const TextureRegion& region, const void* data) {
    const GlFormat& format = glFormat(texture.format);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    setPixelUnpacking(gl_, 1);
    if (texture.kind == TextureKind::texture2d)
        gl_.TextureSubImage2D(texture.name, GLint(region.mipLevel), 0, 0, GLsizei(region.width),
                              GLsizei(region.height), format.external, format.type, data);
    else
        gl_.TextureSubImage3D(texture.name, GLint(region.mipLevel), 0, 0, GLint(region.layer),
                              GLsizei(region.width), GLsizei(region.height),
                              GLsizei(region.layerCount), format.external, format.type, data);
    setPixelUnpacking(gl_, 4);
}

const GlBuffer& GlResources::buffer(BufferHandle handle) const {
    const GlBuffer* found = buffers.find(handle);
    RL_CHECK(found, "a command names a buffer that does not exist");
    return *found;
}

const GlTexture& GlResources::texture(TextureHandle handle) const {
    const GlTexture* found = textures.find(handle);
    RL_CHECK(found, "a command names a texture that does not exist");
    return *found;
}

Result<GLuint> GlResources::framebuffer(const BeginPass& pass) {
    const GlAttachments attachments = attachmentsOf(pass);
    const auto found = std::ranges::find(framebuffers_, attachments, &Framebuffer::attachments);
    if (found != framebuffers_.end()) return found->name;
    return createFramebuffer(attachments, pass);
}

tl::unexpected<Error> GlResources::incomplete(const BeginPass& pass, GLenum status) const {
    std::string targets;
    const auto add = [&](TextureHandle handle) {
        if (!handle) return;
        const GlTexture& target = texture(handle);
        targets += (targets.empty() ? "" : ", ") + target.label + " (" + toText(target.format) +
                   ", " + std::to_string(target.width) + "x" + std::to_string(target.height) + ")";
    };
    for (uint32_t i = 0; i < pass.colorCount; ++i) add(pass.colors[i].texture);
    add(pass.depth.texture);
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", status);
    return fail(std::string("pass '") + pass.name + "'",
                "OpenGL cannot draw into its targets, " + targets +
                    ": the framebuffer is not complete (" + code + ").");
}

void GlResources::attach(GLuint framebuffer, GLenum point, const GlAttachments::One& one) {
    const GlTexture& target = texture(one.texture);
    if (target.kind == TextureKind::texture2d)
        gl_.NamedFramebufferTexture(framebuffer, point, target.name, one.mipLevel);
    else
        gl_.NamedFramebufferTextureLayer(framebuffer, point, target.name, one.mipLevel, one.layer);
}

Result<GLuint> GlResources::createFramebuffer(const GlAttachments& attachments,
                                              const BeginPass& pass) {
    GLuint name = 0;
    gl_.CreateFramebuffers(1, &name);
    gl_.label(GL_FRAMEBUFFER, name, pass.name);
    std::array<GLenum, kMaxColorAttachments> drawBuffers{};
    for (uint32_t i = 0; i < pass.colorCount; ++i) {
        if (!attachments.colors[i].texture) continue;
        drawBuffers[i] = GL_COLOR_ATTACHMENT0 + i;
        attach(name, drawBuffers[i], attachments.colors[i]);
    }
    if (attachments.depth.texture) attach(name, GL_DEPTH_ATTACHMENT, attachments.depth);
    gl_.NamedFramebufferDrawBuffers(name, GLsizei(kMaxColorAttachments), drawBuffers.data());
    const GLenum status = gl_.CheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        gl_.DeleteFramebuffers(1, &name);
        return incomplete(pass, status);
    }
    framebuffers_.push_back({attachments, name});
    return name;
}

void GlResources::forgetFramebuffers(TextureHandle handle) {
    std::erase_if(framebuffers_, [&](const Framebuffer& framebuffer) {
        const GlAttachments& used = framebuffer.attachments;
        const bool uses = used.depth.texture == handle ||
                          std::ranges::find(used.colors, handle, &GlAttachments::One::texture) !=
                              used.colors.end();
        if (uses) gl_.DeleteFramebuffers(1, &framebuffer.name);
        return uses;
    });
}

}  // namespace rushlight
