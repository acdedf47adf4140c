#include "tests/embed/host_gl.h"

namespace host {
namespace {

constexpr GLuint kUnits = 32;

// Off in a new context; each would change the picture of a renderer that takes it for granted.
constexpr GLenum kSwitches[] = {
    GL_BLEND,
    GL_SCISSOR_TEST,
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_DEPTH_CLAMP,
    GL_STENCIL_TEST,
    GL_COLOR_LOGIC_OP,
    GL_RASTERIZER_DISCARD,
    GL_FRAMEBUFFER_SRGB,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_PRIMITIVE_RESTART,
    GL_SAMPLE_MASK,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_POLYGON_SMOOTH,
    GL_LINE_SMOOTH,
    GL_SAMPLE_SHADING,
    GL_CLIP_DISTANCE0,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
};

// Bindings that a transfer, a draw or a query reads.
constexpr GLenum kBuffers[] = {
    GL_ARRAY_BUFFER,      GL_PIXEL_UNPACK_BUFFER,
    GL_PIXEL_PACK_BUFFER, GL_DRAW_INDIRECT_BUFFER,
    GL_UNIFORM_BUFFER,    GL_SHADER_STORAGE_BUFFER,
    GL_QUERY_BUFFER,      GL_COPY_READ_BUFFER,
    GL_COPY_WRITE_BUFFER, GL_DISPATCH_INDIRECT_BUFFER,
};

void setPixelStore(GLint alignment, GLint other) {
    for (GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) glPixelStorei(name, alignment);
    for (GLenum name :
         {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT,
          GL_PACK_SKIP_IMAGES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
          GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(name, other);
    for (GLenum name : {GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES}) glPixelStorei(name, other != 0);
}

}  // namespace

BadManners::BadManners() {
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, 1 << 16, nullptr, GL_DYNAMIC_STORAGE_BIT);
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 1, GL_RGBA8, 4, 4);
    glCreateSamplers(1, &sampler_);
    glSamplerParameteri(sampler_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    glCreateVertexArrays(1, &vertexArray_);
}

BadManners::~BadManners() {
    glDeleteBuffers(1, &buffer_);
    glDeleteTextures(1, &texture_);
    glDeleteSamplers(1, &sampler_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteVertexArrays(1, &vertexArray_);
}

void BadManners::misbehave() const {
    for (GLenum name : kSwitches) glEnable(name);
    glDisable(GL_DITHER);
    glBlendFuncSeparate(GL_ZERO, GL_DST_COLOR, GL_ZERO, GL_ZERO);
    glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    glScissor(1, 1, 2, 2);
    glViewport(3, 3, 5, 5);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glDepthRange(1, 0.25);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPolygonOffset(5, 50);
    glLineWidth(1);
    glStencilFunc(GL_NEVER, 1, 0xff);
    glStencilMask(0);
    glLogicOp(GL_INVERT);
    glSampleMaski(0, 0);
    glSampleCoverage(0.25f, GL_TRUE);
    glPrimitiveRestartIndex(1);
    glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
    setPixelStore(8, 3);
    for (GLenum target : kBuffers) glBindBuffer(target, buffer_);
    for (GLuint slot = 0; slot < 8; ++slot) glBindBufferBase(GL_UNIFORM_BUFFER, slot, buffer_);
    for (GLuint unit = 0; unit < kUnits; ++unit) {
        glBindTextureUnit(unit, texture_);
        glBindSampler(unit, sampler_);
    }
    glActiveTexture(GL_TEXTURE7);
    glBindVertexArray(vertexArray_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void BadManners::behave() {
    glStencilMask(~0u);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
    setPixelStore(4, 0);
    for (GLenum target : kBuffers) glBindBuffer(target, 0);
}

void BadManners::recover() {
    behave();
    for (GLenum name : kSwitches) glDisable(name);
    glEnable(GL_DITHER);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0, 1);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0, 0);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glBindBuffersBase(GL_UNIFORM_BUFFER, 0, 8, nullptr);
    glBindTextures(0, kUnits, nullptr);
    glBindSamplers(0, kUnits, nullptr);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<std::string> brokenPromises() {
    std::vector<std::string> broken;
    const auto integer = [&](const char* name, GLenum what, GLint wanted) {
        GLint value = 0;
        glGetIntegerv(what, &value);
        if (value != wanted)
            broken.push_back(std::string(name) + " is " + std::to_string(value) + ", not " +
                             std::to_string(wanted) + ".");
    };
    const auto indexed = [&](const char* name, GLenum what, GLuint index) {
        GLint value = 0;
        glGetIntegeri_v(what, index, &value);
        if (value != 0)
            broken.push_back(std::string(name) + " " + std::to_string(index) + " is not zero.");
    };
    integer("the draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 0);
    integer("the read framebuffer", GL_READ_FRAMEBUFFER_BINDING, 0);
    integer("the program", GL_CURRENT_PROGRAM, 0);
    integer("the vertex array", GL_VERTEX_ARRAY_BINDING, 0);
    integer("the pixel unpack buffer", GL_PIXEL_UNPACK_BUFFER_BINDING, 0);
    integer("the pixel pack buffer", GL_PIXEL_PACK_BUFFER_BINDING, 0);
    integer("the indirect buffer", GL_DRAW_INDIRECT_BUFFER_BINDING, 0);
    integer("the uniform buffer", GL_UNIFORM_BUFFER_BINDING, 0);
    integer("the active texture", GL_ACTIVE_TEXTURE, GL_TEXTURE0);
    for (GLuint slot = 0; slot < 8; ++slot)
        indexed("uniform buffer", GL_UNIFORM_BUFFER_BINDING, slot);
    for (GLuint unit = 0; unit < kUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (GLenum what :
             {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP,
              GL_TEXTURE_BINDING_BUFFER, GL_SAMPLER_BINDING})
            integer(("a binding of texture unit " + std::to_string(unit)).c_str(), what, 0);
    }
    glActiveTexture(GL_TEXTURE0);
    for (GLenum name : kSwitches)
        if (glIsEnabled(name)) broken.push_back("capability " + std::to_string(name) + " is on.");
    if (!glIsEnabled(GL_DITHER)) broken.push_back("dithering is off.");
    if (glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS)) broken.push_back("seamless cube maps are on.");
    integer("the depth function", GL_DEPTH_FUNC, GL_LESS);
    integer("the depth mask", GL_DEPTH_WRITEMASK, GL_TRUE);
    integer("the culled face", GL_CULL_FACE_MODE, GL_BACK);
    integer("the front face", GL_FRONT_FACE, GL_CCW);
    integer("the clip origin", GL_CLIP_ORIGIN, GL_LOWER_LEFT);
    integer("the clip depth", GL_CLIP_DEPTH_MODE, GL_NEGATIVE_ONE_TO_ONE);
    integer("the source colour factor", GL_BLEND_SRC_RGB, GL_ONE);
    integer("the source alpha factor", GL_BLEND_SRC_ALPHA, GL_ONE);
    integer("the destination colour factor", GL_BLEND_DST_RGB, GL_ZERO);
    integer("the destination alpha factor", GL_BLEND_DST_ALPHA, GL_ZERO);
    integer("the blend equation", GL_BLEND_EQUATION_RGB, GL_FUNC_ADD);
    integer("the provoking vertex", GL_PROVOKING_VERTEX, GL_LAST_VERTEX_CONVENTION);
    GLint mode[2] = {GL_FILL, GL_FILL};
    glGetIntegerv(GL_POLYGON_MODE, mode);
    if (mode[0] != GL_FILL) broken.push_back("the polygon mode is not filled.");
    GLint mask[4] = {};
    glGetIntegerv(GL_COLOR_WRITEMASK, mask);
    if (!mask[0] || !mask[1] || !mask[2] || !mask[3])
        broken.push_back("the colour mask is not full.");
    GLfloat range[2] = {};
    glGetFloatv(GL_DEPTH_RANGE, range);
    if (range[0] != 0 || range[1] != 1) broken.push_back("the depth range is not 0 to 1.");
    return broken;
}

}  // namespace host
