// A host that has a context and a framebuffer, lets Rushlight draw into it, and judges what it
// reads back; with no test framework. Ends with 0 where the picture is as its golden one.
#include "renderer/renderer.h"
#include "renderer/testing/verdict.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <cstdio>

namespace {

constexpr GLsizei kWidth = 80, kHeight = 60;

void* load(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

bool makeContext() {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                                                     EGL_DEFAULT_DISPLAY, nullptr);
    if (!display || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                                attributes);
    return context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

void dropContext() {
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLContext context = eglGetCurrentContext();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
}

GLuint makeFramebuffer() {
    GLuint color = 0, framebuffer = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &color);
    glTextureStorage2D(color, 1, GL_RGBA8, kWidth, kHeight);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
    return framebuffer;
}

rushlight::Result<void> draw(GLuint framebuffer) {
    auto renderer = rushlight::Renderer::create({.loadGl = load});
    if (!renderer) return tl::unexpected(renderer.error());
    const rushlight::vec3 corners[] = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    const rushlight::vec3 normals[] = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    rushlight::MeshDesc plate;
    plate.label = "plate";
    plate.positions = corners, plate.normals = normals, plate.indices = indices;
    const auto mesh = (*renderer)->createMesh(plate);
    if (!mesh) return tl::unexpected(mesh.error());
    rushlight::MaterialDesc white;
    white.metallic = 0;
    const auto material = (*renderer)->createMaterial(white);
    if (!material) return tl::unexpected(material.error());
    rushlight::Instance instance;
    instance.mesh = *mesh;
    instance.material = *material;
    const rushlight::DirectionalLight sun{{0, -1, 0}, rushlight::vec3(3)};
    rushlight::FrameInput input;
    input.view.viewFromWorld = glm::lookAt(rushlight::vec3(1, 2, 2), rushlight::vec3(0),
                                           rushlight::vec3(0, 1, 0));
    input.instances = {&instance, 1};
    input.lighting.directional = {&sun, 1};
    return (*renderer)->render(input, {framebuffer, uint32_t(kWidth), uint32_t(kHeight)});
}

rushlight::Result<rushlight::golden::Verdict> judgeFramebuffer(GLuint framebuffer) {
    using namespace rushlight::golden;
    std::vector<uint8_t> pixels(size_t(kWidth) * size_t(kHeight) * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const auto frame = hostFrame(uint32_t(kWidth), uint32_t(kHeight), pixels, RowOrder::bottomUp);
    if (!frame) return tl::unexpected(frame.error());
    return judge(*frame, near("goldens/host.png", flip(0.02)));
}

int run() {
    const GLuint framebuffer = makeFramebuffer();
    if (const auto drawn = draw(framebuffer); !drawn)
        return std::fprintf(stderr, "host: %s\n", drawn.error().text().c_str()), 3;
    const auto verdict = judgeFramebuffer(framebuffer);
    if (!verdict) return std::fprintf(stderr, "host: %s\n", verdict.error().text().c_str()), 3;
    std::fputs(verdict->text().c_str(), stdout);
    return verdict->passed ? 0 : 1;
}

}  // namespace

int main() {
    if (!makeContext()) return std::fprintf(stderr, "host: there is no context.\n"), 4;
    const int code = run();
    dropContext();
    return code;
}
