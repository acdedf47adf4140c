#include "renderer/backend/gl/programs/gl_reflection.h"

namespace rushlight {
namespace {

struct SamplerType {
    SampledAs as = SampledAs::nothing;
    bool compares = false;
};

SamplerType samplerType(GLenum type) {
    switch (type) {
        case GL_SAMPLER_2D:
        case GL_INT_SAMPLER_2D:
        case GL_UNSIGNED_INT_SAMPLER_2D: return {SampledAs::texture2d, false};
        case GL_SAMPLER_2D_SHADOW: return {SampledAs::texture2d, true};
        case GL_SAMPLER_2D_ARRAY:
        case GL_INT_SAMPLER_2D_ARRAY:
        case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY: return {SampledAs::texture2dArray, false};
        case GL_SAMPLER_2D_ARRAY_SHADOW: return {SampledAs::texture2dArray, true};
        case GL_SAMPLER_CUBE: return {SampledAs::cube, false};
        case GL_SAMPLER_CUBE_SHADOW: return {SampledAs::cube, true};
        case GL_SAMPLER_CUBE_MAP_ARRAY: return {SampledAs::cubeArray, false};
        case GL_SAMPLER_BUFFER: return {SampledAs::floatTexels, false};
        case GL_INT_SAMPLER_BUFFER:
        case GL_UNSIGNED_INT_SAMPLER_BUFFER: return {SampledAs::integerTexels, false};
        case GL_SAMPLER_1D:
        case GL_SAMPLER_3D:
        case GL_SAMPLER_2D_RECT:
        case GL_SAMPLER_1D_ARRAY:
        case GL_SAMPLER_2D_MULTISAMPLE:
        case GL_SAMPLER_2D_MULTISAMPLE_ARRAY: return {SampledAs::other, false};
        default: return {};  // no sampler
    }
}

GLint programValue(const GlFunctions& gl, GLuint program, GLenum name) {
    GLint value = 0;
    gl.GetProgramiv(program, name, &value);
    return value;
}

void reflectBlocks(const GlFunctions& gl, GLuint program, PipelineSlots& slots) {
    const GLuint count = GLuint(programValue(gl, program, GL_ACTIVE_UNIFORM_BLOCKS));
    for (GLuint block = 0; block < count; ++block) {
        GLint binding = 0, bytes = 0;
        gl.GetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
        gl.GetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
        if (GLuint(binding) < kUniformSlots) slots.uniformBytes[size_t(binding)] = uint32_t(bytes);
    }
}

void reflectSamplers(const GlFunctions& gl, GLuint program, PipelineSlots& slots) {
    const GLuint count = GLuint(programValue(gl, program, GL_ACTIVE_UNIFORMS));
    for (GLuint uniform = 0; uniform < count; ++uniform) {
        GLchar name[128];
        GLint size = 0;
        GLenum type = 0;
        gl.GetActiveUniform(program, uniform, sizeof name, nullptr, &size, &type, name);
        const SamplerType sampler = samplerType(type);
        if (sampler.as == SampledAs::nothing) continue;
        const GLint location = gl.GetUniformLocation(program, name);
        for (GLint element = 0; element < size && location >= 0; ++element) {
            GLint unit = 0;
            gl.GetUniformiv(program, location + element, &unit);
            if (GLuint(unit) >= kTextureUnits) continue;
            slots.textures[size_t(unit)] = sampler.as;
            slots.compares[size_t(unit)] = sampler.compares;
        }
    }
}

}  // namespace

PipelineSlots reflectSlots(const GlFunctions& gl, GLuint program) {
    PipelineSlots slots;
    reflectBlocks(gl, program, slots);
    reflectSamplers(gl, program, slots);
    return slots;
}

}  // namespace rushlight
