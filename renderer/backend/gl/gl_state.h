#pragma once
// The one state cache: every bind and every enable of the backend goes through it, the redundant
// ones go no further.

#include "renderer/backend/gl/gl_functions.h"
#include "renderer/rhi/resource_lookup.h"

#include <array>

namespace rushlight {

/// The fixed-function state of a pipeline.
struct GlFixedState {
    CullMode cull = CullMode::none;
    CompareOp depthTest = CompareOp::always;
    bool depthWrite = false;
    bool depthClamp = false;
    float depthBias = 0;
    float depthBiasSlope = 0;
    BlendMode blend = BlendMode::off;
};

struct GlRect {
    int32_t x = 0, y = 0, width = 0, height = 0;
    bool operator==(const GlRect&) const = default;
};

class GlState {
public:
    explicit GlState(const GlFunctions& gl) : gl_(gl) {}

    /// Sets all that a frame relies on; what the host left is not looked at.
    void invalidate();
    /// Leaves every binding zero and the fixed state as a new context has it.
    void resetToDefaults();

    // True when a call was needed.
    bool useProgram(GLuint program);
    bool bindVertexArray(GLuint vertexArray);
    void bindFramebuffer(GLuint framebuffer);
    void bindUniforms(uint32_t slot, GLuint buffer, GLintptr offset, GLsizeiptr size);
    void bindTexture(uint32_t unit, GLuint texture);
    void bindSampler(uint32_t unit, GLuint sampler);
    void bindIndirectBuffer(GLuint buffer);
    void setViewport(const GlRect& rect);
    void setScissor(const GlRect& rect);  ///< width 0: off
    void setDepthWrite(bool on);
    void apply(const GlFixedState& state);

    /// Forgets a deleted object: its name may come back for another.
    void forgetTexture(GLuint texture);
    void forgetBuffer(GLuint buffer);
    void forgetProgram(GLuint program);

    void countChange() { ++changes_; }
    uint32_t changes() const { return changes_; }
    void resetCount() { changes_ = 0; }

private:
    struct UniformRange {
        GLuint buffer = 0;
        GLintptr offset = 0;
        GLsizeiptr size = 0;
        bool operator==(const UniformRange&) const = default;
    };
    template <class T>
    bool change(T& cached, const T& wanted);
    void setEnabled(GLenum capability, bool& cached, bool on);
    void setPipelineDefaults();
    void setBlendMode(BlendMode mode);

    const GlFunctions& gl_;
    uint32_t changes_ = 0;
    GLuint program_ = 0;
    GLuint vertexArray_ = 0;
    GLuint framebuffer_ = 0;
    GLuint indirectBuffer_ = 0;
    std::array<UniformRange, kUniformSlots> uniforms_{};
    std::array<GLuint, kTextureUnits> textures_{};
    std::array<GLuint, kTextureUnits> samplers_{};
    GlRect viewport_{-1, -1, -1, -1};
    GlRect scissor_{-1, -1, -1, -1};
    bool scissorOn_ = false;
    bool cullOn_ = false;
    GLenum cullFace_ = GL_BACK;
    bool depthTestOn_ = false;
    GLenum depthFunction_ = GL_LESS;
    bool depthWrite_ = true;
    bool depthClampOn_ = false;
    bool offsetOn_ = false;
    vec2 offset_{0};
    bool blendOn_ = false;
    BlendMode blendMode_ = BlendMode::off;  ///< whose factors are set; off: GL's default factors
};

}  // namespace rushlight
