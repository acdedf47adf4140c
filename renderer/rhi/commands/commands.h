#pragma once
// The commands of a frame: an enum value and a plain struct each, in one linear arena. They hold
// handles and offsets, never pointers into the host, so a buffer is a value: it can be printed,
// compared and kept.

#include "renderer/rhi/resources.h"

#include <cstdint>

namespace rushlight {

/// A range of a buffer. A zero handle means the command buffer's own data block.
struct BufferRange {
    BufferHandle buffer;
    uint32_t reserved = 0;
    uint64_t offset = 0;
    uint64_t size = 0;
};

enum class LoadOp : uint8_t { keep, clear, discard };

struct ColorAttachment {
    TextureHandle texture;  ///< zero in slot 0 of a pass with no depth: the frame's target
    uint16_t mipLevel = 0;
    uint16_t layer = 0;
    LoadOp load = LoadOp::discard;
    uint8_t reserved[3] = {};
    vec4 clear{0};
};

struct DepthAttachment {
    TextureHandle texture;
    uint16_t layer = 0;
    LoadOp load = LoadOp::keep;
    uint8_t readOnly = 0;  ///< 1: tested, not written; the pass may sample it
    float clear = 0;       ///< reversed Z: 0 is infinitely far
};

inline constexpr uint32_t kMaxColorAttachments = 4;

enum class CommandType : uint16_t {
    beginPass,
    endPass,
    setPipeline,
    setViewport,
    setScissor,
    setVertexStream,
    setIndexStream,
    bindUniforms,
    bindTexelBuffer,
    bindTexture,
    draw,
    drawIndexed,
    multiDrawIndexed,
    readback,
    declareImage,
    count
};

/// Opens a pass: its targets, its place in the report, its debug group, its timer.
struct BeginPass {
    static constexpr CommandType kType = CommandType::beginPass;
    char name[32] = {};
    uint32_t passIndex = 0;      ///< position in FrameReport::passes
    uint32_t colorCount = 0;     ///< 0 with no depth texture either: no targets at all
    uint32_t toFrameTarget = 0;  ///< 1: draws into the host's framebuffer, attachments are ignored
    uint32_t width = 0;
    uint32_t height = 0;
    ColorAttachment colors[kMaxColorAttachments];
    DepthAttachment depth;
};
struct EndPass {
    static constexpr CommandType kType = CommandType::endPass;
    uint32_t passIndex = 0;
};
/// In a pass, before all else: an image that the pass reads or writes, under the name that the
/// frame knows it by (one texture may be several images of a frame). Draws nothing;
/// CommandValidator and messages use it.
struct DeclareImage {
    static constexpr CommandType kType = CommandType::declareImage;
    TextureHandle texture;
    uint32_t write = 0;  ///< 1: a target of the pass, 0: sampled
    char name[40] = {};
};
struct SetPipeline {
    static constexpr CommandType kType = CommandType::setPipeline;
    PipelineHandle pipeline;
};
/// In pixels, origin as GL: y = 0 is the row with the lowest texture coordinate v.
struct SetViewport {
    static constexpr CommandType kType = CommandType::setViewport;
    int32_t x = 0, y = 0, width = 0, height = 0;
};
/// width 0: the scissor test is off. Reset to off by BeginPass.
struct SetScissor {
    static constexpr CommandType kType = CommandType::setScissor;
    int32_t x = 0, y = 0, width = 0, height = 0;
};
struct SetVertexStream {
    static constexpr CommandType kType = CommandType::setVertexStream;
    uint32_t slot = 0;  ///< RL_STREAM_* of shaders/interop/bindings.h
    uint32_t stride = 0;
    BufferRange range;  ///< its size is not used: the draws decide what is read
};
struct SetIndexStream {
    static constexpr CommandType kType = CommandType::setIndexStream;
    BufferRange range;  ///< uint32 indices; its size is not used
};
struct BindUniforms {
    static constexpr CommandType kType = CommandType::bindUniforms;
    uint32_t slot = 0;
    uint32_t reserved = 0;
    BufferRange range;
};
/// Makes a range readable as a samplerBuffer / usamplerBuffer of `format`, at a texture unit.
struct BindTexelBuffer {
    static constexpr CommandType kType = CommandType::bindTexelBuffer;
    uint32_t slot = 0;
    Format format = Format::rgba32f;
    uint8_t reserved[3] = {};
    BufferRange range;
};
struct BindTexture {
    static constexpr CommandType kType = CommandType::bindTexture;
    uint32_t slot = 0;
    TextureHandle texture;
    SamplerHandle sampler;
};
struct Draw {
    static constexpr CommandType kType = CommandType::draw;
    uint32_t vertexCount = 0;
    uint32_t instanceCount = 1;
    uint32_t firstVertex = 0;
};
struct DrawIndexed {
    static constexpr CommandType kType = CommandType::drawIndexed;
    DrawIndexedCommand command{};
};
/// `drawCount` DrawIndexedCommand at `commands`; the counters are filled by who records.
struct MultiDrawIndexed {
    static constexpr CommandType kType = CommandType::multiDrawIndexed;
    uint32_t drawCount = 0;
    uint32_t triangleCount = 0;
    BufferRange commands;
};
/// Copies a texture (or, with a zero handle, the frame target) for the host; see
/// Device::takeReadback.
struct Readback {
    static constexpr CommandType kType = CommandType::readback;
    TextureHandle texture;
    uint32_t layer = 0;
    uint32_t mipLevel = 0;
    uint32_t ticket = 0;
};

const char* toText(CommandType type);

}  // namespace rushlight
