#include "renderer/backend/gl/gl_executor.h"

#include "engine/core/hash.h"
#include "renderer/backend/gl/gl_enums.h"

#include <cstring>
#include <utility>

namespace rushlight {
namespace {

const void* asOffset(GLintptr offset) { return reinterpret_cast<const void*>(offset); }

std::string_view nameOf(const BeginPass& pass) {
    return {pass.name, strnlen(pass.name, sizeof pass.name)};
}

}  // namespace

GlExecutor::Source GlExecutor::resolve(const BufferRange& range) const {
    if (!range.buffer) return {parts_.ring.buffer(), parts_.ring.base() + GLintptr(range.offset)};
    const GlBuffer& buffer = parts_.resources.buffer(range.buffer);
    RL_CHECK(range.offset <= buffer.size && range.size <= buffer.size - range.offset,
             "a command names a range outside of its buffer");
    return {buffer.name, GLintptr(range.offset)};
}

// ---- passes
// ------------------------------------------------------------------------------------------------------

void GlExecutor::operator()(const BeginPass& command) {
    RL_CHECK(!pass_, "a pass begins inside of another");
    passBegan_ = counted();
    const bool anyTexture = command.depth.texture || command.colors[0].texture;
    toFrameTarget_ = command.toFrameTarget || (command.colorCount > 0 && !anyTexture);
    GLuint framebuffer = 0;
    if (!toFrameTarget_ && anyTexture) {
        const Result<GLuint> found = parts_.resources.framebuffer(command);
        if (!found) {
            outcome_ = tl::unexpected(found.error());
            return;
        }
        framebuffer = *found;
    }
    pass_ = &command;
    if (report_.passes.size() <= command.passIndex) report_.passes.resize(command.passIndex + 1);
    if (options_.debugGroups) {
        const std::string_view name = nameOf(command);
        gl_.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, command.passIndex, GLsizei(name.size()),
                           name.data());
    }
    if (options_.timers) parts_.timers.beginPass(nameOf(command));

    if (toFrameTarget_) {
        state_.bindFramebuffer(options_.target.framebuffer);
    } else if (anyTexture) {
        state_.bindFramebuffer(framebuffer);
        load(command, framebuffer);
    }
    state_.setScissor({});
    state_.setViewport({0, 0, int32_t(command.width), int32_t(command.height)});
}

void GlExecutor::load(const BeginPass& pass, GLuint framebuffer) {
    state_.setScissor({});  // clears obey the scissor and the depth mask
    std::array<GLenum, kMaxColorAttachments + 1> discarded{};
    GLsizei discardCount = 0;
    for (uint32_t i = 0; i < pass.colorCount; ++i) {
        const ColorAttachment& color = pass.colors[i];
        if (!color.texture) continue;
        if (color.load == LoadOp::clear) clearColor(framebuffer, i, color);
        if (color.load == LoadOp::discard)
            discarded[size_t(discardCount++)] = GL_COLOR_ATTACHMENT0 + i;
    }
    if (pass.depth.texture && pass.depth.load == LoadOp::clear) {
        state_.setDepthWrite(true);
        gl_.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &pass.depth.clear);
    }
    if (pass.depth.texture && pass.depth.load == LoadOp::discard)
        discarded[size_t(discardCount++)] = GL_DEPTH_ATTACHMENT;
    if (discardCount)
        gl_.InvalidateNamedFramebufferData(framebuffer, discardCount, discarded.data());
}

void GlExecutor::clearColor(GLuint framebuffer, uint32_t slot, const ColorAttachment& color) {
    if (!isInteger(parts_.resources.texture(color.texture).format)) {
        gl_.ClearNamedFramebufferfv(framebuffer, GL_COLOR, GLint(slot), &color.clear.x);
        return;
    }
    const uvec4 value(color.clear);
    gl_.ClearNamedFramebufferuiv(framebuffer, GL_COLOR, GLint(slot), &value.x);
}

void GlExecutor::operator()(const EndPass& command) {
    RL_CHECK(pass_ && pass_->passIndex == command.passIndex, "a pass ends that did not begin");
    PassExecution& result = report_.passes[command.passIndex];
    if (options_.timers) parts_.timers.endPass();
    if (options_.debugGroups) gl_.PopDebugGroup();
    if (options_.timers) {
        const GlTimers::Time time = parts_.timers.newest(command.passIndex, nameOf(*pass_));
        result.gpuBeginMs = time.beginMs;
        result.gpuMs = time.milliseconds;
    }
    const Count ended = counted();
    result.cpuBeginMs = passBegan_.ms - looking_.ms;
    result.cpuMs = ended.ms - passBegan_.ms;
    result.glCalls = ended.calls - passBegan_.calls;
    result.stateChanges = ended.changes - passBegan_.changes;
    if (options_.hashAttachments || options_.keepAttachments) {
        lookInto(*pass_, result);
        const Count looked = counted();
        looking_.calls += looked.calls - ended.calls;
        looking_.changes += looked.changes - ended.changes;
        looking_.ms += looked.ms - ended.ms;
    }
    pass_ = nullptr;
    pipeline_ = nullptr;
}

void GlExecutor::lookInto(const BeginPass& pass, PassExecution& result) {
    if (toFrameTarget_) {
        look(result, parts_.readback.readTarget(state_, options_.target));
        return;
    }
    for (uint32_t i = 0; i < pass.colorCount; ++i)
        if (const ColorAttachment& color = pass.colors[i]; color.texture)
            look(result, parts_.readback.readImage(parts_.resources.texture(color.texture),
                                                   color.layer, color.mipLevel));
    if (pass.depth.texture)
        look(result, parts_.readback.readImage(parts_.resources.texture(pass.depth.texture),
                                               pass.depth.layer, 0));
}

void GlExecutor::look(PassExecution& result, ReadbackImage image) const {
    if (options_.hashAttachments)
        result.attachmentHashes.push_back(hashBytes(image.bytes.data(), image.bytes.size()));
    if (options_.keepAttachments) result.attachments.push_back(std::move(image));
}

// ---- state
// -------------------------------------------------------------------------------------------------------

void GlExecutor::operator()(const SetPipeline& command) {
    pipeline_ = parts_.resources.pipelines.find(command.pipeline);
    RL_CHECK(pipeline_, "a command names a pipeline that does not exist");
    state_.useProgram(parts_.programs.name(pipeline_->program));
    state_.apply(pipeline_->fixed);
}

void GlExecutor::operator()(const SetViewport& c) {
    state_.setViewport({c.x, c.y, c.width, c.height});
}

void GlExecutor::operator()(const SetScissor& c) {
    state_.setScissor({c.x, c.y, c.width, c.height});
}

void GlExecutor::operator()(const SetVertexStream& command) {
    RL_CHECK(command.slot < kVertexStreams, "a vertex stream slot is over the limit");
    const Source source = resolve(command.range);
    streams_[command.slot] = {source.buffer, source.offset, GLsizei(command.stride)};
}

void GlExecutor::operator()(const SetIndexStream& command) { indices_ = resolve(command.range); }

void GlExecutor::operator()(const BindUniforms& command) {
    const Source source = resolve(command.range);
    state_.bindUniforms(command.slot, source.buffer, source.offset, GLsizeiptr(command.range.size));
}

void GlExecutor::operator()(const BindTexelBuffer& command) {
    RL_CHECK(command.slot < kTextureUnits, "a texture unit is over the limit");
    if (command.range.size == 0) {  // GL refuses empty ranges; an unbound unit reads zeroes
        state_.bindTexture(command.slot, 0);
        return;
    }
    const Source source = resolve(command.range);
    GlTexelUnit& unit = parts_.texelUnits[command.slot];
    if (!unit.texture) {
        gl_.CreateTextures(GL_TEXTURE_BUFFER, 1, &unit.texture);
        gl_.label(GL_TEXTURE, unit.texture, "texel buffer");
    }
    if (unit.buffer != source.buffer || unit.offset != uint64_t(source.offset) ||
        unit.size != command.range.size || unit.format != command.format) {
        unit = {unit.texture, source.buffer, uint64_t(source.offset), command.range.size,
                command.format};
        gl_.TextureBufferRange(unit.texture, glFormat(command.format).internal, source.buffer,
                               source.offset, GLsizeiptr(command.range.size));
        state_.countChange();
    }
    state_.bindTexture(command.slot, unit.texture);
}

void GlExecutor::operator()(const BindTexture& command) {
    const GlSampler* sampler = parts_.resources.samplers.find(command.sampler);
    RL_CHECK(sampler || !command.sampler, "a command names a sampler that does not exist");
    state_.bindTexture(command.slot,
                       command.texture ? parts_.resources.texture(command.texture).name : 0);
    state_.bindSampler(command.slot, sampler ? sampler->name : 0);
}

// ---- draws
// -------------------------------------------------------------------------------------------------------

GLenum GlExecutor::prepareDraw() {
    RL_CHECK(pass_ && pipeline_, "a draw needs an open pass and a pipeline");
    parts_.vertexArrays.bind(pipeline_->layout, pipeline_->movingInstances, streams_,
                             indices_.buffer);
    return pipeline_->lines ? GL_LINES : GL_TRIANGLES;
}

void GlExecutor::count(uint32_t draws, uint64_t triangles) {
    PassExecution& pass = report_.passes[pass_->passIndex];
    pass.draws += draws;
    pass.triangles += pipeline_->lines ? 0 : triangles;
}

void GlExecutor::operator()(const Draw& command) {
    const GLenum primitive = prepareDraw();
    gl_.DrawArraysInstanced(primitive, GLint(command.firstVertex), GLsizei(command.vertexCount),
                            GLsizei(command.instanceCount));
    count(1, uint64_t(command.vertexCount / 3) * command.instanceCount);
}

void GlExecutor::operator()(const DrawIndexed& command) {
    const DrawIndexedCommand& draw = command.command;
    const GLenum primitive = prepareDraw();
    gl_.DrawElementsInstancedBaseVertexBaseInstance(
        primitive, GLsizei(draw.indexCount), GL_UNSIGNED_INT,
        asOffset(indices_.offset + GLintptr(draw.firstIndex) * 4), GLsizei(draw.instanceCount),
        draw.baseVertex, draw.baseInstance);
    count(1, uint64_t(draw.indexCount / 3) * draw.instanceCount);
}

void GlExecutor::operator()(const MultiDrawIndexed& command) {
    if (command.drawCount == 0) return;
    RL_CHECK(indices_.offset == 0, "indirect draws index from the start of their index buffer");
    RL_CHECK(command.commands.size >= uint64_t(command.drawCount) * sizeof(DrawIndexedCommand),
             "a multi-draw reads beyond its commands");
    const Source source = resolve(command.commands);
    const GLenum primitive = prepareDraw();
    state_.bindIndirectBuffer(source.buffer);
    gl_.MultiDrawElementsIndirect(primitive, GL_UNSIGNED_INT, asOffset(source.offset),
                                  GLsizei(command.drawCount), sizeof(DrawIndexedCommand));
    count(command.drawCount, command.triangleCount);
}

void GlExecutor::operator()(const Readback& command) {
    if (!command.texture)
        outcome_ = parts_.readback.copyTarget(command.ticket, state_, options_.target);
    else
        outcome_ = parts_.readback.copyTexture(command.ticket,
                                               parts_.resources.texture(command.texture),
                                               command.layer, command.mipLevel);
}

}  // namespace rushlight
