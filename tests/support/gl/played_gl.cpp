#include "tests/support/gl/played_gl.h"

#include "tests/support/gl/replaced_gl.h"

#include <GL/glcorearb.h>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace rushlight {
namespace {

template <class F>
F real(const char* name) {
    return reinterpret_cast<F>(TestContext::load(name));
}

// ---- the clock
// ---------------------------------------------------------------------------------------------------

std::map<GLuint, uint64_t> times;  // by query
uint32_t asked = 0;

void APIENTRY queryCounter(GLuint query, GLenum) { times[query] = PlayedGl::clock(asked++); }
void APIENTRY getQueryObject(GLuint, GLenum, GLint* value) {
    *value = PlayedGl::timesAreThere ? GL_TRUE : GL_FALSE;
}
void APIENTRY getInteger64(GLenum name, GLint64* value) {
    if (name != GL_TIMESTAMP) return real<PFNGLGETINTEGER64VPROC>("glGetInteger64v")(name, value);
    ++PlayedGl::askedNow;
    *value = PlayedGl::now;
}
void APIENTRY getQueryTime(GLuint query, GLenum, GLuint64* value) { *value = times.at(query); }

// ---- names of buffers
// --------------------------------------------------------------------------------------------

std::map<GLuint, GLuint> driversNames{{0, 0}};  // by those that are given out
std::vector<GLuint> freeNames;
GLuint highestName = 0;

GLuint driversName(GLuint buffer) { return driversNames.at(buffer); }

void APIENTRY createBuffers(GLsizei count, GLuint* buffers) {
    for (GLsizei i = 0; i < count; ++i) {
        GLuint made = 0;
        real<PFNGLCREATEBUFFERSPROC>("glCreateBuffers")(1, &made);
        if (freeNames.empty()) {
            buffers[i] = ++highestName;
        } else {
            buffers[i] = freeNames.back();
            freeNames.pop_back();
            ++PlayedGl::namesGivenAgain;
        }
        driversNames[buffers[i]] = made;
    }
}
void APIENTRY deleteBuffers(GLsizei count, const GLuint* buffers) {
    for (GLsizei i = 0; i < count; ++i) {
        const auto known = driversNames.find(buffers[i]);
        if (buffers[i] == 0 || known == driversNames.end()) continue;
        real<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &known->second);
        driversNames.erase(known);
        freeNames.push_back(buffers[i]);
    }
}
void APIENTRY label(GLenum kind, GLuint object, GLsizei length, const GLchar* text) {
    real<PFNGLOBJECTLABELPROC>("glObjectLabel")(
        kind, kind == GL_BUFFER ? driversName(object) : object, length, text);
}
void APIENTRY storage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    real<PFNGLNAMEDBUFFERSTORAGEPROC>("glNamedBufferStorage")(driversName(buffer), size, data,
                                                              flags);
}
void APIENTRY parameter(GLuint buffer, GLenum name, GLint* value) {
    real<PFNGLGETNAMEDBUFFERPARAMETERIVPROC>("glGetNamedBufferParameteriv")(driversName(buffer),
                                                                            name, value);
}
void APIENTRY write(GLuint buffer, GLintptr offset, GLsizeiptr size, const void* data) {
    real<PFNGLNAMEDBUFFERSUBDATAPROC>("glNamedBufferSubData")(driversName(buffer), offset, size,
                                                              data);
}
void APIENTRY read(GLuint buffer, GLintptr offset, GLsizeiptr size, void* data) {
    real<PFNGLGETNAMEDBUFFERSUBDATAPROC>("glGetNamedBufferSubData")(driversName(buffer), offset,
                                                                    size, data);
}
void APIENTRY copy(GLuint from, GLuint to, GLintptr read, GLintptr write, GLsizeiptr size) {
    real<PFNGLCOPYNAMEDBUFFERSUBDATAPROC>("glCopyNamedBufferSubData")(
        driversName(from), driversName(to), read, write, size);
}
void* APIENTRY map(GLuint buffer, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    return real<PFNGLMAPNAMEDBUFFERRANGEPROC>("glMapNamedBufferRange")(driversName(buffer), offset,
                                                                       size, access);
}
GLboolean APIENTRY unmap(GLuint buffer) {
    return real<PFNGLUNMAPNAMEDBUFFERPROC>("glUnmapNamedBuffer")(driversName(buffer));
}
void APIENTRY bind(GLenum target, GLuint buffer) {
    real<PFNGLBINDBUFFERPROC>("glBindBuffer")(target, driversName(buffer));
}
void APIENTRY bindRange(GLenum target, GLuint index, GLuint buffer, GLintptr offset,
                        GLsizeiptr size) {
    real<PFNGLBINDBUFFERRANGEPROC>("glBindBufferRange")(target, index, driversName(buffer), offset,
                                                        size);
}
void APIENTRY textureRange(GLuint texture, GLenum format, GLuint buffer, GLintptr offset,
                           GLsizeiptr size) {
    real<PFNGLTEXTUREBUFFERRANGEPROC>("glTextureBufferRange")(texture, format, driversName(buffer),
                                                              offset, size);
}
void APIENTRY vertexBuffer(GLuint array, GLuint slot, GLuint buffer, GLintptr offset,
                           GLsizei stride) {
    real<PFNGLVERTEXARRAYVERTEXBUFFERPROC>("glVertexArrayVertexBuffer")(
        array, slot, driversName(buffer), offset, stride);
}
void APIENTRY elementBuffer(GLuint array, GLuint buffer) {
    real<PFNGLVERTEXARRAYELEMENTBUFFERPROC>("glVertexArrayElementBuffer")(array,
                                                                          driversName(buffer));
}

}  // namespace

void PlayedGl::reset() {
    times.clear();
    asked = 0;
    driversNames = {{0, 0}};
    freeNames.clear();
    highestName = namesGivenAgain = 0;
    clock = [](uint32_t) { return uint64_t(0); };
    timesAreThere = true;
    now = 0;
    askedNow = 0;
}

void* PlayedGl::load(const char* name) {
    const ReplacedGl replaced[] = {
        {"glQueryCounter", &queryCounter},
        {"glGetQueryObjectiv", &getQueryObject},
        {"glGetInteger64v", &getInteger64},
        {"glGetQueryObjectui64v", &getQueryTime},
        {"glCreateBuffers", &createBuffers},
        {"glDeleteBuffers", &deleteBuffers},
        {"glObjectLabel", &label},
        {"glNamedBufferStorage", &storage},
        {"glGetNamedBufferParameteriv", &parameter},
        {"glNamedBufferSubData", &write},
        {"glGetNamedBufferSubData", &read},
        {"glCopyNamedBufferSubData", &copy},
        {"glMapNamedBufferRange", &map},
        {"glUnmapNamedBuffer", &unmap},
        {"glBindBuffer", &bind},
        {"glBindBufferRange", &bindRange},
        {"glTextureBufferRange", &textureRange},
        {"glVertexArrayVertexBuffer", &vertexBuffer},
        {"glVertexArrayElementBuffer", &elementBuffer},
    };
    return loadReplaced(replaced, name);
}

}  // namespace rushlight
