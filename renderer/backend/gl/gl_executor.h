#pragma once
// Plays a frame's commands into GL.

#include "renderer/backend/gl/gl_readback.h"
#include "renderer/backend/gl/gl_resources.h"
#include "renderer/backend/gl/gl_timers.h"
#include "renderer/backend/gl/gl_upload_ring.h"
#include "renderer/backend/gl/gl_vertex_arrays.h"
#include "renderer/backend/gl/programs/gl_programs.h"

#include <chrono>

namespace rushlight {

/// One buffer texture a unit; its range is set again only when it changes.
struct GlTexelUnit {
    GLuint texture = 0;
    GLuint buffer = 0;
    uint64_t offset = 0;
    uint64_t size = 0;
    Format format = Format::none;
};
using GlTexelUnits = std::array<GlTexelUnit, kTextureUnits>;

/// What an executor plays with; all outlive it.
struct GlParts {
    const GlFunctions& gl;
    GlState& state;
    GlResources& resources;
    GlPrograms& programs;
    GlVertexArrays& vertexArrays;
    GlUploadRing& ring;
    GlTimers& timers;
    GlReadback& readback;
    GlTexelUnits& texelUnits;
};

/// Lives for one frame.
class GlExecutor {
public:
    GlExecutor(const GlParts& parts, const ExecuteOptions& options, ExecutionReport& report)
        : parts_(parts), gl_(parts.gl), state_(parts.state), options_(options), report_(report) {}

    struct Count {
        uint32_t calls = 0, changes = 0;
        double ms = 0;
    };
    /// An Error where a pass had no framebuffer or a picture no memory to come back in: no command
    /// may follow.
    const Result<void>& outcome() const { return outcome_; }

    /// What was done to look into passes, and is no part of the frame.
    const Count& looking() const { return looking_; }

    void operator()(const BeginPass& command);
    void operator()(const DeclareImage&) {}
    void operator()(const EndPass& command);
    void operator()(const SetPipeline& command);
    void operator()(const SetViewport& command);
    void operator()(const SetScissor& command);
    void operator()(const SetVertexStream& command);
    void operator()(const SetIndexStream& command);
    void operator()(const BindUniforms& command);
    void operator()(const BindTexelBuffer& command);
    void operator()(const BindTexture& command);
    void operator()(const Draw& command);
    void operator()(const DrawIndexed& command);
    void operator()(const MultiDrawIndexed& command);
    void operator()(const Readback& command);

private:
    struct Source {
        GLuint buffer = 0;
        GLintptr offset = 0;
    };
    Source resolve(const BufferRange& range) const;
    void load(const BeginPass& pass, GLuint framebuffer);
    void clearColor(GLuint framebuffer, uint32_t slot, const ColorAttachment& color);
    Count counted() const {
        return {gl_.calls, state_.changes(), millisecondsSince(report_.began)};
    }
    static double millisecondsSince(std::chrono::steady_clock::time_point start) {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count();
    }
    void lookInto(const BeginPass& pass, PassExecution& result);
    void look(PassExecution& result, ReadbackImage image) const;
    GLenum prepareDraw();
    void count(uint32_t draws, uint64_t triangles);

    GlParts parts_;
    const GlFunctions& gl_;
    GlState& state_;
    const ExecuteOptions& options_;
    ExecutionReport& report_;
    const BeginPass* pass_ = nullptr;  ///< in the command buffer
    bool toFrameTarget_ = false;
    Result<void> outcome_;
    const GlPipeline* pipeline_ = nullptr;
    GlVertexArrays::Streams streams_{};
    Source indices_;
    Count passBegan_, looking_;
};

}  // namespace rushlight
