#include "renderer/context/context.h"
#include "renderer/context/raster_threads.h"
#include "renderer/context/window.h"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace rushlight {
namespace {

bool isSentence(const std::string& text) {
    return text.size() > 10 && text.ends_with('.') && text.find(' ') != text.npos;
}

/// Clears one texel to a colour and reads it back through functions that the loader gave.
uint32_t clearedTexel(GlLoader loader) {
    const auto load = [&](const char* name) { return loader(name); };
    GLuint texture = 0;
    reinterpret_cast<PFNGLCREATETEXTURESPROC>(load("glCreateTextures"))(GL_TEXTURE_2D, 1, &texture);
    reinterpret_cast<PFNGLTEXTURESTORAGE2DPROC>(load("glTextureStorage2D"))(texture, 1, GL_RGBA8, 1,
                                                                            1);
    const uint8_t color[4] = {10, 20, 30, 40};
    reinterpret_cast<PFNGLCLEARTEXIMAGEPROC>(load("glClearTexImage"))(texture, 0, GL_RGBA,
                                                                      GL_UNSIGNED_BYTE, color);
    uint32_t texel = 0;
    reinterpret_cast<PFNGLGETTEXTUREIMAGEPROC>(load("glGetTextureImage"))(
        texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, sizeof texel, &texel);
    reinterpret_cast<PFNGLDELETETEXTURESPROC>(load("glDeleteTextures"))(1, &texture);
    return texel;
}

constexpr uint32_t kClearedTexel = 40u << 24 | 30u << 16 | 20u << 8 | 10u;

std::vector<std::filesystem::path> rasterThreads() {
    std::vector<std::filesystem::path> threads;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (name.starts_with("llvmpipe-")) threads.push_back(task.path());
    }
    return threads;
}

TEST(Context, EveryKindWorksOrTellsWhyNot) {
    const auto attempts = probeContexts();
    ASSERT_EQ(attempts.size(), 5u);
    uint32_t working = 0;
    for (const ContextAttempt& attempt : attempts) {
        SCOPED_TRACE(toText(attempt.kind));
        if (!attempt.worked) {
            EXPECT_TRUE(isSentence(attempt.reason)) << attempt.reason;
            continue;
        }
        ++working;
        EXPECT_GE(attempt.glVersion.substr(0, 3), "4.5");
        EXPECT_GE(attempt.glslVersion.substr(0, 3), "4.5");
        EXPECT_NE(attempt.glVersion.find("Core"), std::string::npos) << attempt.glVersion;
        EXPECT_FALSE(attempt.glRenderer.empty());
        for (const std::string& line : attempt.missing) EXPECT_TRUE(isSentence(line)) << line;
    }
    EXPECT_GT(working, 0u);
}

TEST(Context, EachWorkingKindRunsCommandsAndCanBeMadeAgain) {
    for (int round = 0; round < 2; ++round)
        for (const ContextAttempt& attempt : probeContexts()) {
            if (!attempt.worked) continue;
            SCOPED_TRACE(toText(attempt.kind));
            auto context = createContext(attempt.kind, {.debug = round == 1});
            ASSERT_TRUE(context) << context.error().text();
            EXPECT_EQ((*context)->kind(), attempt.kind);
            EXPECT_EQ(clearedTexel((*context)->loader()), kClearedTexel);
        }
}

TEST(Context, TwoOnOneDisplayOutliveEachOther) {
    auto first = createOffscreenContext(ContextChoice::automatic, {});
    auto second = createOffscreenContext(ContextChoice::automatic, {});
    ASSERT_TRUE(first && second);
    (*first)->makeCurrent();
    EXPECT_EQ(clearedTexel((*first)->loader()), kClearedTexel);
    second->reset();
    (*first)->makeCurrent();
    EXPECT_EQ(clearedTexel((*first)->loader()), kClearedTexel);
}

TEST(Context, AChoiceTriesItsKindsAlone) {
    const auto context = createOffscreenContext(ContextChoice::osmesa, {});
    if (context)
        EXPECT_EQ((*context)->kind(), ContextKind::osmesa);
    else
        EXPECT_NE(context.error().message.find("osmesa: "), std::string::npos);
}

TEST(Context, AFailureListsTheReasonOfEachKindTried) {
    if (std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"))
        GTEST_SKIP() << "with a display a window can be had";
    const auto context = createOffscreenContext(ContextChoice::window, {});
    ASSERT_FALSE(context);
    EXPECT_EQ(context.error().kind, ErrorKind::noContext);
    EXPECT_NE(context.error().message.find("window: GLFW could not start"), std::string::npos)
        << context.error().message;
    const auto window = createWindow({});
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().kind, ErrorKind::noContext);
}

TEST(Context, AWindowHasAFramebufferAndDraws) {
    if (!std::getenv("DISPLAY")) GTEST_SKIP() << "no display";
    WindowOptions options;
    options.width = 320;
    options.height = 200;
    auto window = createWindow(options);
    ASSERT_TRUE(window) << window.error().text();
    uint32_t width = 0;
    uint32_t height = 0;
    (*window)->framebufferSize(width, height);
    EXPECT_EQ(width, 320u);
    EXPECT_EQ(height, 200u);
    EXPECT_FALSE((*window)->shouldClose());
    EXPECT_EQ(clearedTexel((*window)->loader()), kClearedTexel);
    (*window)->swapBuffers();
}

TEST(Context, RasterThreadsArePinnedEachToOneCore) {
    auto context = createOffscreenContext(ContextChoice::automatic, {.pinRasterThreads = true});
    ASSERT_TRUE(context) << context.error().text();
    const auto threads = rasterThreads();
    std::set<int> cores;
    for (const auto& thread : threads) {
        cpu_set_t set;
        ASSERT_EQ(sched_getaffinity(std::stoi(thread.filename().string()), sizeof set, &set), 0);
        EXPECT_EQ(CPU_COUNT(&set), 1);
        for (int core = 0; core < CPU_SETSIZE; ++core)
            if (CPU_ISSET(core, &set)) cores.insert(core);
    }
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    EXPECT_EQ(cores.size(), std::min<size_t>(threads.size(), size_t(CPU_COUNT(&allowed))));
    EXPECT_EQ(pinRasterThreads((*context)->loader()), threads.size());
}

}  // namespace
}  // namespace rushlight
