#pragma once
// The GL functions the backend calls, fetched through the host's loader. One table a device:
// devices share nothing.

#include "engine/core/result.h"

#include <GL/glcorearb.h>

#include <cstdint>

namespace rushlight {

using GlLoad = void* (*)(const char* name);

/// A GL function that counts its calls in its table.
template <class Pointer>
class GlFunction;
template <class R, class... Arguments>
class GlFunction<R(APIENTRYP)(Arguments...)> {
public:
    R operator()(Arguments... arguments) const {
        ++*calls_;
        return pointer_(arguments...);
    }
    bool load(GlLoad loader, const char* name, uint32_t* calls) {
        calls_ = calls;
        pointer_ = reinterpret_cast<R(APIENTRYP)(Arguments...)>(loader(name));
        return pointer_ != nullptr;
    }

private:
    R(APIENTRYP pointer_)(Arguments...) = nullptr;
    uint32_t* calls_ = nullptr;
};

// X(name without "gl", name in the type of its pointer)
#define RL_GL_FUNCTIONS(X)                                                                      \
    X(ActiveTexture, ACTIVETEXTURE)                                                             \
    X(AttachShader, ATTACHSHADER)                                                               \
    X(BindBuffer, BINDBUFFER)                                                                   \
    X(BindBufferRange, BINDBUFFERRANGE)                                                         \
    X(BindBuffersBase, BINDBUFFERSBASE)                                                         \
    X(BindFramebuffer, BINDFRAMEBUFFER)                                                         \
    X(BindSampler, BINDSAMPLER)                                                                 \
    X(BindSamplers, BINDSAMPLERS)                                                               \
    X(BindTextureUnit, BINDTEXTUREUNIT)                                                         \
    X(BindTextures, BINDTEXTURES)                                                               \
    X(BindVertexArray, BINDVERTEXARRAY)                                                         \
    X(BlendEquation, BLENDEQUATION)                                                             \
    X(BlendEquationSeparate, BLENDEQUATIONSEPARATE)                                             \
    X(BlendFunc, BLENDFUNC)                                                                     \
    X(BlendFuncSeparate, BLENDFUNCSEPARATE)                                                     \
    X(CheckNamedFramebufferStatus, CHECKNAMEDFRAMEBUFFERSTATUS)                                 \
    X(ClearNamedFramebufferfv, CLEARNAMEDFRAMEBUFFERFV)                                         \
    X(ClearNamedFramebufferuiv, CLEARNAMEDFRAMEBUFFERUIV)                                       \
    X(ClientWaitSync, CLIENTWAITSYNC)                                                           \
    X(ClipControl, CLIPCONTROL)                                                                 \
    X(ColorMask, COLORMASK)                                                                     \
    X(CompileShader, COMPILESHADER)                                                             \
    X(CopyNamedBufferSubData, COPYNAMEDBUFFERSUBDATA)                                           \
    X(CreateBuffers, CREATEBUFFERS)                                                             \
    X(CreateFramebuffers, CREATEFRAMEBUFFERS)                                                   \
    X(CreateProgram, CREATEPROGRAM)                                                             \
    X(CreateQueries, CREATEQUERIES)                                                             \
    X(CreateSamplers, CREATESAMPLERS)                                                           \
    X(CreateShader, CREATESHADER)                                                               \
    X(CreateTextures, CREATETEXTURES)                                                           \
    X(CreateVertexArrays, CREATEVERTEXARRAYS)                                                   \
    X(CullFace, CULLFACE)                                                                       \
    X(DebugMessageCallback, DEBUGMESSAGECALLBACK)                                               \
    X(DebugMessageControl, DEBUGMESSAGECONTROL)                                                 \
    X(DeleteBuffers, DELETEBUFFERS)                                                             \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                                                   \
    X(DeleteProgram, DELETEPROGRAM)                                                             \
    X(DeleteQueries, DELETEQUERIES)                                                             \
    X(DeleteSamplers, DELETESAMPLERS)                                                           \
    X(DeleteShader, DELETESHADER)                                                               \
    X(DeleteSync, DELETESYNC)                                                                   \
    X(DeleteTextures, DELETETEXTURES)                                                           \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)                                                   \
    X(DepthFunc, DEPTHFUNC)                                                                     \
    X(DepthMask, DEPTHMASK)                                                                     \
    X(DepthRange, DEPTHRANGE)                                                                   \
    X(DetachShader, DETACHSHADER)                                                               \
    X(Disable, DISABLE)                                                                         \
    X(DrawArraysInstanced, DRAWARRAYSINSTANCED)                                                 \
    X(DrawElementsInstancedBaseVertexBaseInstance, DRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCE) \
    X(Enable, ENABLE)                                                                           \
    X(EnableVertexArrayAttrib, ENABLEVERTEXARRAYATTRIB)                                         \
    X(FenceSync, FENCESYNC)                                                                     \
    X(Finish, FINISH)                                                                           \
    X(Flush, FLUSH)                                                                             \
    X(FrontFace, FRONTFACE)                                                                     \
    X(GetActiveUniform, GETACTIVEUNIFORM)                                                       \
    X(GetActiveUniformBlockiv, GETACTIVEUNIFORMBLOCKIV)                                         \
    X(GetError, GETERROR)                                                                       \
    X(GetGraphicsResetStatus, GETGRAPHICSRESETSTATUS)                                           \
    X(GetInteger64v, GETINTEGER64V)                                                             \
    X(GetIntegerv, GETINTEGERV)                                                                 \
    X(GetNamedBufferParameteriv, GETNAMEDBUFFERPARAMETERIV)                                     \
    X(GetNamedBufferSubData, GETNAMEDBUFFERSUBDATA)                                             \
    X(GetPointerv, GETPOINTERV)                                                                 \
    X(GetProgramBinary, GETPROGRAMBINARY)                                                       \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG)                                                     \
    X(GetProgramiv, GETPROGRAMIV)                                                               \
    X(GetQueryObjectiv, GETQUERYOBJECTIV)                                                       \
    X(GetQueryObjectui64v, GETQUERYOBJECTUI64V)                                                 \
    X(GetShaderInfoLog, GETSHADERINFOLOG)                                                       \
    X(GetShaderiv, GETSHADERIV)                                                                 \
    X(GetString, GETSTRING)                                                                     \
    X(GetStringi, GETSTRINGI)                                                                   \
    X(GetTextureParameteriv, GETTEXTUREPARAMETERIV)                                             \
    X(GetTextureSubImage, GETTEXTURESUBIMAGE)                                                   \
    X(GetUniformLocation, GETUNIFORMLOCATION)                                                   \
    X(GetUniformiv, GETUNIFORMIV)                                                               \
    X(InvalidateNamedFramebufferData, INVALIDATENAMEDFRAMEBUFFERDATA)                           \
    X(LineWidth, LINEWIDTH)                                                                     \
    X(LinkProgram, LINKPROGRAM)                                                                 \
    X(MapNamedBufferRange, MAPNAMEDBUFFERRANGE)                                                 \
    X(MultiDrawElementsIndirect, MULTIDRAWELEMENTSINDIRECT)                                     \
    X(NamedBufferStorage, NAMEDBUFFERSTORAGE)                                                   \
    X(NamedBufferSubData, NAMEDBUFFERSUBDATA)                                                   \
    X(NamedFramebufferDrawBuffers, NAMEDFRAMEBUFFERDRAWBUFFERS)                                 \
    X(NamedFramebufferTexture, NAMEDFRAMEBUFFERTEXTURE)                                         \
    X(NamedFramebufferTextureLayer, NAMEDFRAMEBUFFERTEXTURELAYER)                               \
    X(ObjectLabel, OBJECTLABEL)                                                                 \
    X(PixelStorei, PIXELSTOREI)                                                                 \
    X(PolygonMode, POLYGONMODE)                                                                 \
    X(PolygonOffset, POLYGONOFFSET)                                                             \
    X(PopDebugGroup, POPDEBUGGROUP)                                                             \
    X(ProgramBinary, PROGRAMBINARY)                                                             \
    X(ProgramParameteri, PROGRAMPARAMETERI)                                                     \
    X(ProvokingVertex, PROVOKINGVERTEX)                                                         \
    X(PushDebugGroup, PUSHDEBUGGROUP)                                                           \
    X(QueryCounter, QUERYCOUNTER)                                                               \
    X(ReadPixels, READPIXELS)                                                                   \
    X(SamplerParameterf, SAMPLERPARAMETERF)                                                     \
    X(SamplerParameteri, SAMPLERPARAMETERI)                                                     \
    X(Scissor, SCISSOR)                                                                         \
    X(ShaderSource, SHADERSOURCE)                                                               \
    X(TextureBufferRange, TEXTUREBUFFERRANGE)                                                   \
    X(TextureParameteri, TEXTUREPARAMETERI)                                                     \
    X(TextureStorage2D, TEXTURESTORAGE2D)                                                       \
    X(TextureStorage3D, TEXTURESTORAGE3D)                                                       \
    X(TextureSubImage2D, TEXTURESUBIMAGE2D)                                                     \
    X(TextureSubImage3D, TEXTURESUBIMAGE3D)                                                     \
    X(UnmapNamedBuffer, UNMAPNAMEDBUFFER)                                                       \
    X(UseProgram, USEPROGRAM)                                                                   \
    X(VertexArrayAttribBinding, VERTEXARRAYATTRIBBINDING)                                       \
    X(VertexArrayAttribFormat, VERTEXARRAYATTRIBFORMAT)                                         \
    X(VertexArrayAttribIFormat, VERTEXARRAYATTRIBIFORMAT)                                       \
    X(VertexArrayBindingDivisor, VERTEXARRAYBINDINGDIVISOR)                                     \
    X(VertexArrayElementBuffer, VERTEXARRAYELEMENTBUFFER)                                       \
    X(VertexArrayVertexBuffer, VERTEXARRAYVERTEXBUFFER)                                         \
    X(Viewport, VIEWPORT)

/// Not copied: every function points at `calls`.
struct GlFunctions {
    GlFunctions() = default;
    GlFunctions(const GlFunctions&) = delete;
    GlFunctions& operator=(const GlFunctions&) = delete;

    /// Fails with ErrorKind::noContext when there is no current context, its version is under 4.5,
    /// or a function is missing; the message names which.
    Result<void> load(GlLoad loader);

    /// What GetGraphicsResetStatus said, the first answer that was not "no error" being kept: after
    /// that the driver may say "no error" again, though nothing is left of the objects. Only
    /// contexts that were made to (GL_LOSE_CONTEXT_ON_RESET of GL_KHR_robustness) tell.
    GLenum resetStatus() const;

    /// Names a GL object in debuggers and messages.
    void label(GLenum kind, GLuint object, std::string_view text) const;

#define RL_GL_MEMBER(name, type) GlFunction<PFNGL##type##PROC> name;
    RL_GL_FUNCTIONS(RL_GL_MEMBER)
#undef RL_GL_MEMBER
    uint32_t calls = 0;

private:
    mutable GLenum reset_ = GL_NO_ERROR;
};

}  // namespace rushlight
