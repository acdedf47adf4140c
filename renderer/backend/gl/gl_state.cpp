#include "renderer/backend/gl/gl_state.h"

#include "renderer/backend/gl/gl_enums.h"

namespace rushlight {
namespace {

// Off in a new context and off in a frame: a host may have turned them on.
constexpr GLenum kAlwaysOff[] = {
    GL_STENCIL_TEST,
    GL_COLOR_LOGIC_OP,
    GL_RASTERIZER_DISCARD,
    GL_PRIMITIVE_RESTART,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_MASK,
    GL_POLYGON_OFFSET_LINE,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_FRAMEBUFFER_SRGB,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_SHADING,
    GL_POLYGON_SMOOTH,
    GL_LINE_SMOOTH,
};

// Bindings that transfers and queries read, by the value of GL_PIXEL_*_BUFFER and their kind.
constexpr GLenum kTransferBuffers[] = {
    GL_PIXEL_PACK_BUFFER,    GL_PIXEL_UNPACK_BUFFER, GL_QUERY_BUFFER,
    GL_DRAW_INDIRECT_BUFFER, GL_UNIFORM_BUFFER,
};

}  // namespace

template <class T>
bool GlState::change(T& cached, const T& wanted) {
    if (cached == wanted) return false;
    cached = wanted;
    ++changes_;
    return true;
}

void GlState::setEnabled(GLenum capability, bool& cached, bool on) {
    if (!change(cached, on)) return;
    on ? gl_.Enable(capability) : gl_.Disable(capability);
}

void GlState::setPipelineDefaults() {
    for (GLenum capability : {GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_DEPTH_CLAMP,
                              GL_POLYGON_OFFSET_FILL, GL_BLEND})
        gl_.Disable(capability);
    scissorOn_ = cullOn_ = depthTestOn_ = depthClampOn_ = offsetOn_ = blendOn_ = false;
    gl_.CullFace(cullFace_ = GL_BACK);
    gl_.DepthFunc(depthFunction_ = GL_LESS);
    gl_.DepthMask(GL_TRUE);
    depthWrite_ = true;
    gl_.PolygonOffset(0, 0);
    offset_ = vec2(0);
    gl_.BlendFunc(GL_ONE, GL_ZERO);
    if (blendMode_ == BlendMode::absorbing) gl_.BlendEquation(GL_FUNC_ADD);
    blendMode_ = BlendMode::off;
    gl_.UseProgram(program_ = 0);
    gl_.BindVertexArray(vertexArray_ = 0);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_ = 0);
    for (GLenum target : kTransferBuffers) gl_.BindBuffer(target, 0);
    indirectBuffer_ = 0;
    gl_.BindBuffersBase(GL_UNIFORM_BUFFER, 0, kUniformSlots, nullptr);
    uniforms_.fill({});
    gl_.BindTextures(0, kTextureUnits, nullptr);
    textures_.fill(0);
    gl_.BindSamplers(0, kTextureUnits, nullptr);
    samplers_.fill(0);
    gl_.ActiveTexture(GL_TEXTURE0);
    viewport_ = scissor_ = {-1, -1, -1, -1};
}

void GlState::invalidate() {
    setPipelineDefaults();
    for (GLenum capability : kAlwaysOff) gl_.Disable(capability);
    for (GLenum distance = 0; distance < 8; ++distance) gl_.Disable(GL_CLIP_DISTANCE0 + distance);
    gl_.Disable(GL_DITHER);
    gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    // Reversed Z with a float buffer keeps its precision only when clip space depth is 0 to 1.
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthRange(0, 1);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.FrontFace(GL_CCW);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.LineWidth(1);
}

void GlState::resetToDefaults() {
    setPipelineDefaults();
    gl_.Enable(GL_DITHER);
    gl_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

bool GlState::useProgram(GLuint program) {
    if (!change(program_, program)) return false;
    gl_.UseProgram(program);
    return true;
}

bool GlState::bindVertexArray(GLuint vertexArray) {
    if (!change(vertexArray_, vertexArray)) return false;
    gl_.BindVertexArray(vertexArray);
    return true;
}

void GlState::bindFramebuffer(GLuint framebuffer) {
    if (change(framebuffer_, framebuffer)) gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void GlState::bindUniforms(uint32_t slot, GLuint buffer, GLintptr offset, GLsizeiptr size) {
    RL_CHECK(slot < kUniformSlots, "a uniform slot is over the limit");
    if (change(uniforms_[slot], {buffer, offset, size}))
        gl_.BindBufferRange(GL_UNIFORM_BUFFER, slot, buffer, offset, size);
}

void GlState::bindTexture(uint32_t unit, GLuint texture) {
    RL_CHECK(unit < kTextureUnits, "a texture unit is over the limit");
    if (change(textures_[unit], texture)) gl_.BindTextureUnit(unit, texture);
}

void GlState::bindSampler(uint32_t unit, GLuint sampler) {
    RL_CHECK(unit < kTextureUnits, "a texture unit is over the limit");
    if (change(samplers_[unit], sampler)) gl_.BindSampler(unit, sampler);
}

void GlState::bindIndirectBuffer(GLuint buffer) {
    if (change(indirectBuffer_, buffer)) gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
}

void GlState::setViewport(const GlRect& rect) {
    if (change(viewport_, rect)) gl_.Viewport(rect.x, rect.y, rect.width, rect.height);
}

void GlState::setScissor(const GlRect& rect) {
    setEnabled(GL_SCISSOR_TEST, scissorOn_, rect.width > 0);
    if (scissorOn_ && change(scissor_, rect)) gl_.Scissor(rect.x, rect.y, rect.width, rect.height);
}

void GlState::setDepthWrite(bool on) {
    if (change(depthWrite_, on)) gl_.DepthMask(on ? GL_TRUE : GL_FALSE);
}

void GlState::apply(const GlFixedState& state) {
    setEnabled(GL_CULL_FACE, cullOn_, state.cull != CullMode::none);
    if (cullOn_ && change(cullFace_, glCull(state.cull))) gl_.CullFace(cullFace_);
    setEnabled(GL_DEPTH_TEST, depthTestOn_,
               state.depthTest != CompareOp::always || state.depthWrite);
    if (depthTestOn_ && change(depthFunction_, glCompare(state.depthTest)))
        gl_.DepthFunc(depthFunction_);
    setDepthWrite(state.depthWrite);
    setEnabled(GL_DEPTH_CLAMP, depthClampOn_, state.depthClamp);
    const vec2 offset(state.depthBiasSlope, state.depthBias);
    setEnabled(GL_POLYGON_OFFSET_FILL, offsetOn_, offset != vec2(0));
    if (offsetOn_ && change(offset_, offset)) gl_.PolygonOffset(offset.x, offset.y);
    setEnabled(GL_BLEND, blendOn_, state.blend != BlendMode::off);
    if (blendOn_) setBlendMode(state.blend);
}

void GlState::setBlendMode(BlendMode mode) {
    const bool absorbed = blendMode_ == BlendMode::absorbing;
    if (!change(blendMode_, mode)) return;
    if (mode == BlendMode::absorbing) {
        gl_.BlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
        gl_.BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ONE);
        return;
    }
    if (absorbed) gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, mode == BlendMode::additive   ? GL_ONE
                          : mode == BlendMode::filtered ? GL_SRC1_COLOR
                                                        : GL_ONE_MINUS_SRC_ALPHA);
}

void GlState::forgetTexture(GLuint texture) {
    for (GLuint& bound : textures_)
        if (bound == texture) bound = 0;
}

void GlState::forgetBuffer(GLuint buffer) {
    for (UniformRange& range : uniforms_)
        if (range.buffer == buffer) range = {};
    if (indirectBuffer_ == buffer) indirectBuffer_ = 0;
}

void GlState::forgetProgram(GLuint program) {
    if (program_ == program) program_ = 0;
}

}  // namespace rushlight
