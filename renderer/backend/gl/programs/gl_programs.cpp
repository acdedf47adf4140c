#include "renderer/backend/gl/programs/gl_programs.h"

#include "engine/core/hash.h"

namespace rushlight {

GlPrograms::~GlPrograms() {
    for (const Program& program : programs_) gl_.DeleteProgram(program.name);
}

Result<uint32_t> GlPrograms::get(const PipelineDesc& desc) {
    Program wanted;
    wanted.label = desc.label;
    wanted.vertexShader = desc.vertexShader;
    wanted.fragmentShader = desc.fragmentShader;
    wanted.defines.assign(desc.defines.begin(), desc.defines.end());
    wanted.fromLibrary = desc.vertexSource.empty();
    Result<Sources> sources = wanted.fromLibrary ? loadSources(wanted) : givenSources(desc);
    if (!sources) return tl::unexpected(sources.error());
    wanted.sourceHash = sources->hash;
    for (uint32_t i = 0; i < programs_.size(); ++i) {
        const Program& program = programs_[i];
        if (program.vertexShader == wanted.vertexShader &&
            program.fragmentShader == wanted.fragmentShader && program.defines == wanted.defines &&
            program.sourceHash == wanted.sourceHash && program.fromLibrary == wanted.fromLibrary)
            return i;
    }
    const Result<GLuint> name = build(wanted, *sources);
    if (!name) return tl::unexpected(name.error());
    adopt(wanted, *name, *sources);
    programs_.push_back(std::move(wanted));
    return uint32_t(programs_.size() - 1);
}

Result<uint32_t> GlPrograms::reload() {
    uint32_t replaced = 0;
    Result<uint32_t> outcome = 0u;
    for (Program& program : programs_) {
        if (!program.fromLibrary) continue;
        Result<Sources> sources = loadSources(program);
        if (sources && sources->hash == program.sourceHash) continue;
        const Result<GLuint> name = sources ? build(program, *sources)
                                            : Result<GLuint>(tl::unexpected(sources.error()));
        if (!name) {
            if (outcome) outcome = tl::unexpected(name.error());
            continue;
        }
        state_.forgetProgram(program.name);
        gl_.DeleteProgram(program.name);
        adopt(program, *name, *sources);
        ++replaced;
    }
    if (outcome) outcome = replaced;
    return outcome;
}

Result<GlPrograms::Sources> GlPrograms::loadSources(const Program& program) const {
    Result<ShaderSource> vertex = library_.load(program.vertexShader, program.defines);
    if (!vertex) return tl::unexpected(vertex.error());
    Result<ShaderSource> fragment = library_.load(program.fragmentShader, program.defines);
    if (!fragment) return tl::unexpected(fragment.error());
    const uint64_t hash = hashText(fragment->text, hashText(vertex->text));
    return Sources{std::move(*vertex), std::move(*fragment), hash};
}

GlPrograms::Sources GlPrograms::givenSources(const PipelineDesc& desc) {
    Sources sources;
    sources.vertex.text = desc.vertexSource;
    sources.fragment.text = desc.fragmentSource;
    sources.hash = hashText(sources.fragment.text, hashText(sources.vertex.text));
    return sources;
}

void GlPrograms::adopt(Program& program, GLuint name, Sources& sources) const {
    program.name = name;
    program.sourceHash = sources.hash;
    program.vertexText = std::move(sources.vertex.text);
    program.fragmentText = std::move(sources.fragment.text);
    program.slots = reflectSlots(gl_, name);
}

PipelineDesc GlPrograms::describe(uint32_t index) const {
    const Program& program = programs_[index];
    PipelineDesc desc;
    desc.vertexShader = program.vertexShader;
    desc.fragmentShader = program.fragmentShader;
    desc.vertexSource = program.vertexText;
    desc.fragmentSource = program.fragmentText;
    return desc;
}

Result<GLuint> GlPrograms::build(const Program& program, const Sources& sources) {
    const GLuint name = gl_.CreateProgram();
    if (cache_.enabled()) gl_.ProgramParameteri(name, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    const bool cached = cache_.load(name, sources.hash);
    if (!cached) {
        if (Result<void> linked = link(name, program, sources); !linked) {
            gl_.DeleteProgram(name);
            return tl::unexpected(linked.error());
        }
        cache_.store(name, sources.hash);
        ++compiled_;
    }
    gl_.label(GL_PROGRAM, name, program.label);
    log_(LogLevel::debug,
         (cached ? "Program from the cache: " : "Program compiled: ") + program.label);
    return name;
}

Result<GLuint> GlPrograms::compile(GLenum stage, const std::string& file,
                                   const ShaderSource& source) const {
    const GLuint shader = gl_.CreateShader(stage);
    gl_.label(GL_SHADER, shader, file);
    const GLchar* text = source.text.data();
    const GLint length = GLint(source.text.size());
    gl_.ShaderSource(shader, 1, &text, &length);
    gl_.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    GLint size = 0;
    gl_.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
    std::string log(size_t(size), '\0');
    if (size > 0) gl_.GetShaderInfoLog(shader, size, nullptr, log.data());
    gl_.DeleteShader(shader);
    return fail(file, "The shader does not compile:\n" + source.readableLog(log.c_str()));
}

Result<void> GlPrograms::link(GLuint name, const Program& program, const Sources& sources) const {
    const Result<GLuint> vertex = compile(GL_VERTEX_SHADER, program.vertexShader, sources.vertex);
    if (!vertex) return tl::unexpected(vertex.error());
    const Result<GLuint> fragment = compile(GL_FRAGMENT_SHADER, program.fragmentShader,
                                            sources.fragment);
    if (!fragment) {
        gl_.DeleteShader(*vertex);
        return tl::unexpected(fragment.error());
    }
    gl_.AttachShader(name, *vertex);
    gl_.AttachShader(name, *fragment);
    gl_.LinkProgram(name);
    for (GLuint shader : {*vertex, *fragment}) {
        gl_.DetachShader(name, shader);
        gl_.DeleteShader(shader);
    }
    GLint linked = GL_FALSE;
    gl_.GetProgramiv(name, GL_LINK_STATUS, &linked);
    if (linked) return {};
    GLint size = 0;
    gl_.GetProgramiv(name, GL_INFO_LOG_LENGTH, &size);
    std::string log(size_t(size), '\0');
    if (size > 0) gl_.GetProgramInfoLog(name, size, nullptr, log.data());
    return fail(program.vertexShader + " + " + program.fragmentShader,
                std::string("The program does not link:\n") + log.c_str());
}

}  // namespace rushlight
