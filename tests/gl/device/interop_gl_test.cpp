// The structs of shaders/interop as the driver lays them out and as C++ does: the same bytes.
#include "interop/frame_uniforms.h"
#include "interop/screen_uniforms.h"
#include "interop/uniforms.h"
#include "renderer/backend/gl/programs/gl_shader_library.h"
#include "tests/support/gl/test_context.h"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <map>

namespace rushlight {
namespace {

using interop::LightingUniforms;
using interop::PassUniforms;
using interop::ScreenUniforms;
using interop::ViewUniforms;

template <class F>
F load(const char* name) {
    return reinterpret_cast<F>(TestContext::load(name));
}

struct Block {
    GLint size = 0;
    std::map<std::string, GLint> offsets;  ///< by member; of an array, its first element
};

/// The uniform block `block` of a program whose fragment shader reads every member of its struct.
class InteropGl : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(context_.valid()); }

    Block layoutOf(const std::string& file, const std::string& type) {
        const std::string name = "tests/block.frag";
        const auto included = ShaderLibrary("").load(file, {});
        EXPECT_TRUE(included) << (included ? "" : included.error().text());
        const std::string text =
            included->text + "\nlayout(std140, binding = 0) uniform Block { " + type +
            " data; };\nlayout(location = 0) out vec4 result;\nvoid main() { result = data." +
            (type == "ViewUniforms"     ? "cameraForward"
             : type == "PassUniforms"   ? "counts"
             : type == "ScreenUniforms" ? "settings"
                                        : "background") +
            "; }\n";
        const char* source = text.c_str();
        const GLuint program = load<PFNGLCREATESHADERPROGRAMVPROC>("glCreateShaderProgramv")(
            GL_FRAGMENT_SHADER, 1, &source);
        char log[2000] = {};
        load<PFNGLGETPROGRAMINFOLOGPROC>("glGetProgramInfoLog")(program, sizeof log, nullptr, log);
        Block block;
        const GLuint index = load<PFNGLGETUNIFORMBLOCKINDEXPROC>("glGetUniformBlockIndex")(program,
                                                                                           "Block");
        EXPECT_NE(index, GL_INVALID_INDEX) << log;
        if (index == GL_INVALID_INDEX) return block;
        const auto ofBlock = load<PFNGLGETACTIVEUNIFORMBLOCKIVPROC>("glGetActiveUniformBlockiv");
        ofBlock(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &block.size);
        GLint count = 0;
        ofBlock(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &count);
        std::vector<GLint> members(static_cast<size_t>(count));
        ofBlock(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES, members.data());
        for (const GLint member : members) {
            const GLuint uniform = GLuint(member);
            char text_[200] = {};
            GLint offset = -1;
            load<PFNGLGETACTIVEUNIFORMNAMEPROC>("glGetActiveUniformName")(
                program, uniform, sizeof text_, nullptr, text_);
            load<PFNGLGETACTIVEUNIFORMSIVPROC>("glGetActiveUniformsiv")(program, 1, &uniform,
                                                                        GL_UNIFORM_OFFSET, &offset);
            block.offsets[text_] = offset;
        }
        load<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(program);
        return block;
    }

    TestContext context_;
};

#define EXPECT_SAME_OFFSET(block, Struct, member, suffix)                           \
    ASSERT_TRUE((block).offsets.contains("data." #member suffix)) << "no " #member; \
    EXPECT_EQ((block).offsets.at("data." #member suffix), GLint(offsetof(Struct, member)))

TEST_F(InteropGl, ViewUniforms) {
    const Block block = layoutOf("interop/frame_uniforms.h", "ViewUniforms");
    EXPECT_EQ(block.size, GLint(sizeof(ViewUniforms)));
    ASSERT_EQ(block.offsets.size(), 6u);
    EXPECT_SAME_OFFSET(block, ViewUniforms, clipFromWorld, "");
    EXPECT_SAME_OFFSET(block, ViewUniforms, previousClipFromWorld, "");
    EXPECT_SAME_OFFSET(block, ViewUniforms, cameraPosition, "");
    EXPECT_SAME_OFFSET(block, ViewUniforms, cameraForward, "");
    EXPECT_SAME_OFFSET(block, ViewUniforms, decalMapping, "");
    EXPECT_SAME_OFFSET(block, ViewUniforms, decalScale, "");
}

TEST_F(InteropGl, PassUniforms) {
    const Block block = layoutOf("interop/uniforms.h", "PassUniforms");
    EXPECT_EQ(block.size, GLint(sizeof(PassUniforms)));
    ASSERT_EQ(block.offsets.size(), 3u);
    EXPECT_SAME_OFFSET(block, PassUniforms, sourceTexel, "");
    EXPECT_SAME_OFFSET(block, PassUniforms, settings, "");
    EXPECT_SAME_OFFSET(block, PassUniforms, counts, "");
}

TEST_F(InteropGl, ScreenUniforms) {
    const Block block = layoutOf("interop/screen_uniforms.h", "ScreenUniforms");
    EXPECT_EQ(block.size, GLint(sizeof(ScreenUniforms)));
    EXPECT_SAME_OFFSET(block, ScreenUniforms, viewFromTexel, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, depthDecode, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, size, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, right, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, up, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, back, "");
    EXPECT_SAME_OFFSET(block, ScreenUniforms, settings, "");
}

TEST_F(InteropGl, LightingUniforms) {
    const Block block = layoutOf("interop/frame_uniforms.h", "LightingUniforms");
    EXPECT_EQ(block.size, GLint(sizeof(LightingUniforms)));
    EXPECT_SAME_OFFSET(block, LightingUniforms, rayCorner, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, rayRight, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, rayUp, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, baseCorner, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, baseRight, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, baseUp, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, depthDecode, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, viewDirection, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, clusterMapping, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, clusterCounts, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, shadowRows, "[0]");
    EXPECT_SAME_OFFSET(block, LightingUniforms, shadowCascades, "[0]");
    EXPECT_SAME_OFFSET(block, LightingUniforms, shadowSettings, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, directionalDirections, "[0]");
    EXPECT_SAME_OFFSET(block, LightingUniforms, directionalIlluminances, "[0]");
    EXPECT_SAME_OFFSET(block, LightingUniforms, environment, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, ambientSky, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, ambientGround, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, background, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, fogMedium, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, fogAlbedo, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, fogMapping, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, fogGrid, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, sunDisk, "");
    EXPECT_SAME_OFFSET(block, LightingUniforms, sunDiskRadiance, "");
}

}  // namespace
}  // namespace rushlight
