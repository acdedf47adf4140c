#pragma once
// The GL objects behind the handles, and the framebuffers made of them.

#include "renderer/backend/gl/gl_state.h"
#include "renderer/rhi/commands/commands.h"

#include <string>
#include <vector>

namespace rushlight {

struct GlBuffer {
    GLuint name = 0;
    uint64_t size = 0;
    BufferUsage usage = BufferUsage::vertex;
    std::string label;
};

struct GlTexture {
    GLuint name = 0;
    TextureKind kind = TextureKind::texture2d;
    Format format = Format::none;
    uint32_t width = 0, height = 0, layers = 0, mipLevels = 0;
    std::string label;
};

struct GlSampler {
    GLuint name = 0;
    SamplerDesc desc;
};

struct GlPipeline {
    uint32_t program = 0;  ///< index into GlPrograms
    VertexLayout layout = VertexLayout::none;
    bool movingInstances = false;
    bool lines = false;
    GlFixedState fixed;
    std::string label;
};

/// What distinguishes one framebuffer object from another.
struct GlAttachments {
    struct One {
        TextureHandle texture;
        uint16_t mipLevel = 0;
        uint16_t layer = 0;
        bool operator==(const One&) const = default;
    };
    std::array<One, kMaxColorAttachments> colors{};
    One depth;
    bool operator==(const GlAttachments&) const = default;
};

class GlResources {
public:
    explicit GlResources(const GlFunctions& gl) : gl_(gl) {}
    ~GlResources();

    Pool<GlBuffer, BufferTag> buffers;
    Pool<GlTexture, TextureTag> textures;
    Pool<GlSampler, SamplerTag> samplers;
    Pool<GlPipeline, PipelineTag> pipelines;

    Result<GlBuffer> createBuffer(const BufferDesc& desc);
    Result<GlTexture> createTexture(const TextureDesc& desc);
    GlSampler createSampler(const SamplerDesc& desc, float maxAnisotropy);
    void write(const GlTexture& texture, const TextureRegion& region, const void* data);

    // What a command names; a handle that does not exist is our bug.
    const GlBuffer& buffer(BufferHandle handle) const;
    const GlTexture& texture(TextureHandle handle) const;

    /// The framebuffer with a pass's attachments, made on first use and kept until one of them is
    /// destroyed. An Error where the driver cannot draw into them together.
    Result<GLuint> framebuffer(const BeginPass& pass);
    void forgetFramebuffers(TextureHandle texture);

private:
    struct Framebuffer {
        GlAttachments attachments;
        GLuint name = 0;
    };
    Result<GLuint> createFramebuffer(const GlAttachments& attachments, const BeginPass& pass);
    void attach(GLuint framebuffer, GLenum point, const GlAttachments::One& one);
    tl::unexpected<Error> incomplete(const BeginPass& pass, GLenum status) const;

    const GlFunctions& gl_;
    std::vector<Framebuffer> framebuffers_;
};

}  // namespace rushlight
