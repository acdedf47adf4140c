// The project keeps its own rules; and a tree that breaks one is found out.
#include "tests/layering/layering.h"

#include "tests/layering/source_text.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

TEST(Layering, TheProjectKeepsItsRules) {
    for (const std::string& violation : findLayeringViolations(RUSHLIGHT_SOURCE))
        ADD_FAILURE() << violation;
}

/// A small tree that keeps every rule, to plant one violation in.
class PlantedTree : public testing::Test {
protected:
    PlantedTree() {
        tree.write("CMakeLists.txt", "add_subdirectory(engine)\ninclude(renderer/list.cmake)\n");
        tree.write("engine/CMakeLists.txt", "add_library(e core/a.cpp)\n");
        tree.write("engine/core/a.h", "#pragma once\n#include <vector>\n");
        tree.write("engine/core/a.cpp", "#include \"engine/core/a.h\"\n");
        tree.write("engine/scene/s.h", "#include \"engine/core/a.h\"\n");
        tree.write("renderer/list.cmake", "add_library(r frame/f.cpp backend/gl/g.cpp)\n");
        tree.write("renderer/frame/f.h",
                   "#include \"engine/core/a.h\"\nint glCalls = 0; // glClear()\n");
        tree.write("renderer/frame/f.cpp",
                   "#include \"renderer/frame/f.h\"\nauto t = \"glClear(GL_X)\";\n");
        tree.write("renderer/backend/gl/g.cpp", "#include <GL/glcorearb.h>\nint x = GL_ONE;\n");
        tree.write("shaders/files.cmake", "set(FILES\n  common/c.glsl\n)\n");
        tree.write("shaders/common/c.glsl", "");
    }
    void expectOne(const std::string& file, const std::string& what) {
        const auto found = findLayeringViolations(tree.path());
        ASSERT_EQ(found.size(), 1u) << testing::PrintToString(found);
        EXPECT_TRUE(found[0].starts_with(file + ": ")) << found[0];
        EXPECT_NE(found[0].find(what), std::string::npos) << found[0];
    }
    TemporaryDirectory tree;
};

TEST_F(PlantedTree, IsCleanBeforeAnythingIsPlanted) {
    EXPECT_EQ(findLayeringViolations(tree.path()), std::vector<std::string>{});
}
TEST_F(PlantedTree, GlCallOutsideOfTheBackend) {
    tree.write("renderer/frame/f.h", "inline void f() { glClear(0); }\n");
    expectOne("renderer/frame/f.h", "glClear");
}
TEST_F(PlantedTree, GlConstantInTheSandbox) {
    tree.write("sandbox/viewer/v.h", "#include <GLFW/glfw3.h>\nint x = GL_ONE;\n");
    expectOne("sandbox/viewer/v.h", "GL_ONE");
}
TEST_F(PlantedTree, PicturesEncodedByTheDriver) {
    tree.write("renderer/backend/gl/g.cpp", "int x = GL_FRAMEBUFFER_SRGB;\n");
    expectOne("renderer/backend/gl/g.cpp", "GL_FRAMEBUFFER_SRGB");
}
TEST_F(PlantedTree, GlHeaderInAPass) {
    tree.write("renderer/passes/p.h", "#  include <GL/glcorearb.h>\n");
    expectOne("renderer/passes/p.h", "GL/glcorearb.h");
}
TEST_F(PlantedTree, WindowHeaderInTheGame) {
    tree.write("sandbox/game/g.h", "#include <GLFW/glfw3.h>\n");
    expectOne("sandbox/game/g.h", "GLFW/glfw3.h");
}
TEST_F(PlantedTree, RendererThatKnowsTheScene) {
    tree.write("renderer/renderer.h", "#include \"engine/scene/s.h\"\n");
    expectOne("renderer/renderer.h", "engine/scene/s.h");
}
TEST_F(PlantedTree, TestingLibraryThatKnowsTheScene) {
    tree.write("renderer/testing/t.h", "#include \"engine/assets/model.h\"\n");
    EXPECT_EQ(findLayeringViolations(tree.path()), std::vector<std::string>{});
    tree.write("renderer/testing/t.h", "#include \"engine/scene/s.h\"\n");
    expectOne("renderer/testing/t.h", "engine/scene/s.h");
}
TEST_F(PlantedTree, EngineThatKnowsTheRenderer) {
    tree.write("engine/scene/s.h", "#include \"renderer/renderer.h\"\n");
    expectOne("engine/scene/s.h", "renderer/renderer.h");
}
TEST_F(PlantedTree, CoreThatKnowsMoreThanItself) {
    tree.write("engine/core/a.h", "#include <engine/scene/s.h>\n");
    expectOne("engine/core/a.h", "engine/scene/s.h");
}
TEST_F(PlantedTree, FrameBuilderThatKnowsAPass) {
    tree.write("renderer/frame/f.h", "#include \"renderer/passes/p.h\"\n");
    expectOne("renderer/frame/f.h", "renderer/passes/p.h");
}
TEST_F(PlantedTree, PassThatKnowsTheGlBackend) {
    tree.write("renderer/passes/p.h", "#include \"renderer/backend/gl/gl_state.h\"\n");
    expectOne("renderer/passes/p.h", "gl_state.h");
}
TEST_F(PlantedTree, SandboxThatDoesTheBridgesWork) {
    tree.write("sandbox/tool/t.h",
               "#include \"engine/scene/s.h\"\n#include \"renderer/frame/f.h\"\n");
    expectOne("sandbox/tool/t.h", "only the bridge");
    tree.write("sandbox/tool/t.h", "");
    tree.write("renderer/scene_bridge/b.h",
               "#include \"engine/scene/s.h\"\n#include \"renderer/frame/f.h\"\n");
    EXPECT_EQ(findLayeringViolations(tree.path()), std::vector<std::string>{});
}
TEST_F(PlantedTree, IncludeWithNoFolder) {
    tree.write("renderer/frame/f.h", "#include \"other.h\"\n");
    expectOne("renderer/frame/f.h", "other.h");
}
TEST_F(PlantedTree, GlobbedSources) {
    tree.write("renderer/list.cmake",
               "file(GLOB s *.cpp)\nadd_library(r frame/f.cpp backend/gl/g.cpp)\n");
    expectOne("renderer/list.cmake", "file(GLOB");
}
TEST_F(PlantedTree, ScriptsMayLookForFiles) {
    tree.write("tests/compare.cmake", "file(GLOB s *.png)\n");
    EXPECT_EQ(findLayeringViolations(tree.path()), std::vector<std::string>{});
}
TEST_F(PlantedTree, SourceThatNothingBuilds) {
    tree.write("engine/core/lost.cpp", "");
    expectOne("engine/core/lost.cpp", "no CMake list");
}
TEST_F(PlantedTree, SourceThatOnlyACommentLists) {
    tree.write("engine/CMakeLists.txt", "add_library(e) # core/a.cpp\n");
    expectOne("engine/core/a.cpp", "no CMake list");
}
TEST_F(PlantedTree, ShaderThatIsNotListed) {
    tree.write("shaders/passes/p.frag", "");
    expectOne("shaders/passes/p.frag", "files.cmake");
}
TEST_F(PlantedTree, ShaderThatIsListedButNotThere) {
    tree.write("shaders/files.cmake", "set(FILES common/c.glsl passes/p.frag)\n");
    expectOne("shaders/files.cmake", "passes/p.frag");
}

TEST(SourceText, CodeIsWhatIsNeitherCommentNorLiteral) {
    EXPECT_EQ(codeOf("a /* b */ c // d\ne"), "a  c \ne");
    EXPECT_EQ(codeOf("f(\"x\\\"y\", 'z', 1'000, R\"q(\")\" )q\") g"), "f(, , 1'000, ) g");
    EXPECT_EQ(codeOf("/* open"), "");
}
TEST(SourceText, GlIsNamedByCallsConstantsAndTypes) {
    for (const char* gl : {"glClear(1)", "x = GL_ONE", "PFNGLCLEARPROC f", "GLuint x"})
        EXPECT_NE(glIdentifierIn(gl), "") << gl;
    for (const char* other :
         {"glCalls = 1", "r.glCalls(1)", "GLFW_KEY_A", "GLSL", "global(1)", "RL_GL_X"})
        EXPECT_EQ(glIdentifierIn(other), "") << other;
}

}  // namespace
}  // namespace rushlight
