#include "renderer/context/raster_threads.h"

#include <GL/glcorearb.h>
#include <sched.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace rushlight {
namespace {

/// A raster thread names itself when it first runs, so each has to run once: clears a small image
/// and waits.
void wakeRasterThreads(GlLoader loader) {
    const auto createFramebuffers = reinterpret_cast<PFNGLCREATEFRAMEBUFFERSPROC>(
        loader("glCreateFramebuffers"));
    const auto createRenderbuffers = reinterpret_cast<PFNGLCREATERENDERBUFFERSPROC>(
        loader("glCreateRenderbuffers"));
    const auto storage = reinterpret_cast<PFNGLNAMEDRENDERBUFFERSTORAGEPROC>(
        loader("glNamedRenderbufferStorage"));
    const auto attach = reinterpret_cast<PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC>(
        loader("glNamedFramebufferRenderbuffer"));
    const auto clear = reinterpret_cast<PFNGLCLEARNAMEDFRAMEBUFFERFVPROC>(
        loader("glClearNamedFramebufferfv"));
    const auto finish = reinterpret_cast<PFNGLFINISHPROC>(loader("glFinish"));
    const auto deleteFramebuffers = reinterpret_cast<PFNGLDELETEFRAMEBUFFERSPROC>(
        loader("glDeleteFramebuffers"));
    const auto deleteRenderbuffers = reinterpret_cast<PFNGLDELETERENDERBUFFERSPROC>(
        loader("glDeleteRenderbuffers"));

    GLuint framebuffer = 0;
    GLuint renderbuffer = 0;
    createFramebuffers(1, &framebuffer);
    createRenderbuffers(1, &renderbuffer);
    storage(renderbuffer, GL_RGBA8, 64, 64);
    attach(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    const GLfloat black[4] = {};
    clear(framebuffer, GL_COLOR, 0, black);
    finish();
    deleteFramebuffers(1, &framebuffer);
    deleteRenderbuffers(1, &renderbuffer);
}

/// N of "llvmpipe-N", the name of a thread of this process.
std::optional<uint32_t> rasterThreadNumber(const std::filesystem::path& task) {
    std::string name;
    std::getline(std::ifstream(task / "comm"), name);
    constexpr std::string_view kPrefix = "llvmpipe-";
    if (!name.starts_with(kPrefix)) return {};
    uint32_t number = 0;
    const char* end = name.data() + name.size();
    const auto parsed = std::from_chars(name.data() + kPrefix.size(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return {};
    return number;
}

std::vector<int> allowedCores() {
    std::vector<int> cores;
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return cores;
    for (int core = 0; core < CPU_SETSIZE; ++core)
        if (CPU_ISSET(core, &allowed)) cores.push_back(core);
    return cores;
}

}  // namespace

uint32_t pinRasterThreads(GlLoader loader) {
    const std::vector<int> cores = allowedCores();
    if (cores.empty()) return 0;
    wakeRasterThreads(loader);
    uint32_t pinned = 0;
    std::error_code error;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", error)) {
        const auto number = rasterThreadNumber(task.path());
        if (!number) continue;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(cores[*number % cores.size()], &one);
        if (sched_setaffinity(std::stoi(task.path().filename().string()), sizeof one, &one) == 0)
            ++pinned;
    }
    return pinned;
}

}  // namespace rushlight
