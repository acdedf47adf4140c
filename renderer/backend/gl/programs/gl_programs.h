#pragma once
// Linked programs, shared by the pipelines that ask for the same shaders and defines.

#include "engine/core/log.h"
#include "renderer/backend/gl/gl_state.h"
#include "renderer/backend/gl/programs/gl_program_cache.h"
#include "renderer/backend/gl/programs/gl_reflection.h"
#include "renderer/backend/gl/programs/gl_shader_library.h"

#include <atomic>
#include <vector>

namespace rushlight {

class GlPrograms {
public:
    GlPrograms(const GlFunctions& gl, GlState& state, std::string shaderDirectory,
               std::string cacheDirectory, LogSink log)
        : gl_(gl),
          state_(state),
          log_(log),
          library_(std::move(shaderDirectory)),
          cache_(gl, std::move(cacheDirectory)) {}
    ~GlPrograms();

    /// The index of the program, compiled now or found.
    Result<uint32_t> get(const PipelineDesc& desc);
    GLuint name(uint32_t index) const { return programs_[index].name; }
    const PipelineSlots& slots(uint32_t index) const { return programs_[index].slots; }
    /// The names and the sources that the program was compiled from; of a pipeline's description,
    /// that much.
    PipelineDesc describe(uint32_t index) const;

    /// Programs that were not in the cache. From any thread.
    uint64_t compiled() const { return compiled_; }

    /// Tries every program whose sources changed; the first error is returned, after all were
    /// tried.
    Result<uint32_t> reload();

private:
    struct Program {
        std::string label;
        std::string vertexShader, fragmentShader;
        std::vector<std::string> defines;
        uint64_t sourceHash = 0;
        GLuint name = 0;
        bool fromLibrary = true;  ///< not: compiled from sources that it was given
        std::string vertexText, fragmentText;
        PipelineSlots slots;
    };
    struct Sources {
        ShaderSource vertex, fragment;
        uint64_t hash = 0;
    };
    Result<Sources> loadSources(const Program& program) const;
    static Sources givenSources(const PipelineDesc& desc);
    Result<GLuint> build(const Program& program, const Sources& sources);
    void adopt(Program& program, GLuint name, Sources& sources) const;
    Result<GLuint> compile(GLenum stage, const std::string& file, const ShaderSource& source) const;
    Result<void> link(GLuint name, const Program& program, const Sources& sources) const;

    const GlFunctions& gl_;
    GlState& state_;
    LogSink log_;
    ShaderLibrary library_;
    GlProgramCache cache_;
    std::vector<Program> programs_;
    std::atomic<uint64_t> compiled_{0};
};

}  // namespace rushlight
