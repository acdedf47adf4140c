// Sources, includes, errors, reloading and the cache of programs.

#include "renderer/backend/gl/gl_device.h"
#include "renderer/backend/gl/programs/gl_shader_library.h"
#include "tests/support/gl/test_context.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace rushlight {
namespace {

constexpr const char* kVertex = "void main() { gl_Position = vec4(0.0); }\n";
constexpr const char* kFragment =
    "layout(location = 0) out vec4 result;\nvoid main() { result = vec4(1.0); }\n";

class ShadersGlTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
        shaders_.write("a.vert", kVertex);
        shaders_.write("a.frag", kFragment);
    }
    std::unique_ptr<Device> device(const std::string& cache = {}) {
        GlDeviceDesc desc;
        desc.load = &TestContext::load;
        desc.log = {&ShadersGlTest::log, this};
        desc.shaderDirectory = shaders_.path();
        desc.cacheDirectory = cache;
        return std::move(createGlDevice(desc).value());
    }
    static Result<PipelineHandle> pipeline(Device& device) {
        return device.createPipeline(
            {.label = "a", .vertexShader = "a.vert", .fragmentShader = "a.frag"});
    }
    static void log(void* user, LogLevel, std::string_view message) {
        static_cast<ShadersGlTest*>(user)->messages_.emplace_back(message);
    }

    TestContext context_;
    TemporaryDirectory shaders_;
    std::vector<std::string> messages_;
};

TEST_F(ShadersGlTest, ErrorsHaveFileAndLineThroughIncludes) {
    shaders_.write("common/bad.glsl", "// one\n// two\nfloat f() { return missing; }\n");
    shaders_.write("a.frag", std::string("#include \"common/bad.glsl\"\n") + kFragment);
    const auto gl = device();
    const auto made = pipeline(*gl);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("common/bad.glsl:3: "), std::string::npos)
        << made.error().message;
    shaders_.write("common/bad.glsl", "// fine\n");
    shaders_.write("a.frag", "#include \"common/bad.glsl\"\nvoid main() { oops; }\n");
    const auto second = pipeline(*gl);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("a.frag:2: "), std::string::npos)
        << second.error().message;
}

TEST_F(ShadersGlTest, IncludeCycleIsRefused) {
    shaders_.write("x.glsl", "#include \"y.glsl\"\n");
    shaders_.write("y.glsl", "\n#include \"x.glsl\"\n");
    const auto source = ShaderLibrary(shaders_.path()).load("x.glsl", {});
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().text(),
              "y.glsl:2: The include makes a cycle: x.glsl -> y.glsl -> x.glsl.");
}

TEST_F(ShadersGlTest, IncludesComeOnceAndThoseOfCppAreDropped) {
    shaders_.write("once.glsl", "float once;\n");
    shaders_.write("both.h",
                   "#ifndef GLSL\n#include \"engine/core/math.h\"\n#else\n#include "
                   "\"shaders/once.glsl\"\n#endif\n#include \"once.glsl\"\n");
    const auto source = ShaderLibrary(shaders_.path()).load("both.h", {});
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_EQ(source->files, (std::vector<std::string>{"both.h", "once.glsl"}));
    EXPECT_EQ(source->text.find("float once;"), source->text.rfind("float once;"));
}

TEST_F(ShadersGlTest, EmbeddedShadersAreThereByName) {
    const auto source = ShaderLibrary("").load("interop/bindings.h", {});
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_NE(source->text.find("RL_ATTRIBUTE_POSITION"), std::string::npos);
    EXPECT_FALSE(ShaderLibrary("").load("nothing.vert", {}));
}

TEST_F(ShadersGlTest, ReloadReplacesWhatChangedAndKeepsTheLastGood) {
    const auto gl = device();
    ASSERT_TRUE(pipeline(*gl));
    EXPECT_EQ(gl->reloadShaders().value(), 0u);
    shaders_.write("a.frag", std::string(kFragment) + "// changed\n");
    EXPECT_EQ(gl->reloadShaders().value(), 1u);
    shaders_.write("a.frag", "void main() { broken }\n");
    const auto failed = gl->reloadShaders();
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find("a.frag:1: "), std::string::npos);
    shaders_.write("a.frag", std::string(kFragment) + "// changed\n");
    EXPECT_EQ(gl->reloadShaders().value(), 0u);  // the last good one is still in place
}

TEST_F(ShadersGlTest, ProgramsComeFromTheCacheUnlessTheFileIsCorrupt) {
    const TemporaryDirectory cache;
    ASSERT_TRUE(pipeline(*device(cache.path())));
    EXPECT_EQ(messages_.back(), "Program compiled: a");
    ASSERT_TRUE(pipeline(*device(cache.path())));
    EXPECT_EQ(messages_.back(), "Program from the cache: a");
    for (const auto& entry : std::filesystem::directory_iterator(cache.path()))
        std::ofstream(entry.path(), std::ios::binary | std::ios::app) << "garbage";
    ASSERT_TRUE(pipeline(*device(cache.path())));
    EXPECT_EQ(messages_.back(), "Program compiled: a");
}

}  // namespace
}  // namespace rushlight
