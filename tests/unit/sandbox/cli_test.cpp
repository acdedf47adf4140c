#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace {

struct Ended {
    int code = -1;
    std::string errors, output;
};

Ended runAndRead(const std::string& arguments, const char* redirection, std::string Ended::*text) {
    Ended result;
    FILE* pipe = popen((RUSHLIGHT_TOOL " " + arguments + redirection).c_str(), "r");
    if (!pipe) return result;
    char buffer[256];
    while (const size_t count = fread(buffer, 1, sizeof buffer, pipe))
        (result.*text).append(buffer, count);
    result.code = WEXITSTATUS(pclose(pipe));
    return result;
}

/// Runs the tool; collects standard error alone.
Ended run(const std::string& arguments) {
    return runAndRead(arguments, " 2>&1 >/dev/null", &Ended::errors);
}
/// Standard output alone.
Ended runForOutput(const std::string& arguments) {
    return runAndRead(arguments, " 2>/dev/null", &Ended::output);
}

void expectError(const std::string& arguments, int code) {
    const Ended result = run(arguments);
    EXPECT_EQ(result.code, code) << arguments;
    EXPECT_TRUE(result.errors.starts_with("rushlight: error: ")) << result.errors;
    EXPECT_EQ(result.errors.find('\n'), result.errors.size() - 1) << result.errors;
}

TEST(Cli, HelpWorksForEverySubcommand) {
    for (const char* command :
         {"", "bake ", "breakdown ", "capture ", "check ", "compare ", "bench ", "info ",
          "diagnose ", "doctor ", "explain ", "goldens ", "replay "}) {
        const Ended result = run(std::string(command) + "--help");
        EXPECT_EQ(result.code, 0) << command;
        EXPECT_EQ(result.errors, "");
    }
}

TEST(Cli, WrongUseIsTwo) {
    for (const char* arguments : {"",
                                  "nonsense",
                                  "capture",
                                  "capture a.glb",
                                  "capture a.glb -o a.png --size 0x5",
                                  "capture a.glb -o a.png --size 12",
                                  "capture a.glb -o a.png --eye 1,2,3",
                                  "capture a.glb -o a.png --pass nonsense",
                                  "capture a.glb -o a.bmp",
                                  "capture a.glb -o a.png --frames 0-3",
                                  "capture a.glb -o %d.png --frames 3-0",
                                  "capture a.glb -o a.png --shadows maybe",
                                  "breakdown a.glb",
                                  "breakdown -o out",
                                  "breakdown a.glb -o out --pass normal",
                                  "compare a.png",
                                  "bench a.glb --frames 0",
                                  "capture a.glb -o a.png --exposure-scale nan",
                                  "capture a.glb -o a.png --fov nan",
                                  "capture a.glb -o a.png --environment-rotation inf",
                                  "capture a.glb -o a.png --size 99999x99999",
                                  "capture a.glb -o %d.png --frames 0-1 --fps nan",
                                  "capture a.glb -o %d.png --frames 0-1 --save-frame f.rlf",
                                  "capture a.glb -o a --pass all --save-frame f.rlf",
                                  "replay",
                                  "replay a.rlf",
                                  "replay a.rlf -o a.bmp",
                                  "replay a.rlf -o a.png --until 0",
                                  "replay a.rlf --until 3",
                                  "replay --diff a.rlf",
                                  "replay a.rlf --diff b.rlf c.rlf",
                                  "replay a.rlf -o a.png --size 5x5",
                                  "capture a.glb -o a.png --trace",
                                  "bench a.glb --trace",
                                  "info a.glb --trace t.json",
                                  "diagnose",
                                  "diagnose a.glb --stats s.json",
                                  "explain a.glb",
                                  "explain a.glb 5",
                                  "explain a.glb 5,",
                                  "explain a.glb 5,6,7",
                                  "explain a.glb -1,5",
                                  "explain a.glb 5.5,1",
                                  "explain a.glb 1280,0",
                                  "explain a.glb 0,32 --size 64x32",
                                  "explain a.glb 0,0 --stats s.json",
                                  "check a.glb",
                                  "check a.glb --golden g.jpg",
                                  "check a.glb --golden g.png --flip nan",
                                  "goldens",
                                  "compare a.png b.png --flip nan",
                                  "compare a.png b.png --pixels-per-degree nan",
                                  "compare a.txt b.txt --hashes --flip 0.1",
                                  "capture a.glb -o a.png --compression best"})
        expectError(arguments, 2);
}

TEST(Cli, BadInputIsThree) {
    expectError("info /nowhere/a.glb", 3);
    expectError("capture /nowhere/a.glb -o /nowhere/a.png", 3);
    expectError("breakdown /nowhere/a.glb -o /nowhere/out", 3);
    expectError("breakdown /nowhere/a.glb -o /nowhere/out --compare /nowhere/frame.json", 3);
    expectError("compare /nowhere/a.png /nowhere/b.png", 3);
    expectError("check /nowhere/a.glb --golden /nowhere/g.png", 3);
    expectError("check @/nowhere/a.check", 3);
    expectError("goldens /nowhere", 3);
    expectError("diagnose /nowhere/a.glb", 3);
    expectError("explain /nowhere/a.glb 1,2", 3);
    expectError("replay /nowhere/a.rlf -o /nowhere/a.png", 3);
    expectError("replay /dev --list", 3);
    expectError("replay " RUSHLIGHT_TOOL " --list", 3);
    expectError("replay --diff " RUSHLIGHT_TOOL " " RUSHLIGHT_TOOL, 3);
}

TEST(Cli, ListsOfHashesNameTheFirstPassThatDiffers) {
    const rushlight::TemporaryDirectory folder;
    const auto list = [&](const char* name, const std::string& text) {
        folder.write(name, text);
        return folder.path() + "/" + name;
    };
    const std::string depth = "gbuffer depth 0123456789abcdef\n",
                      light = "lighting radiance aaaaaaaaaaaaaaaa\n",
                      other = "lighting radiance aaaaaaaaaaaaaaab\n",
                      bloom = "bloom image 1111111111111111\n",
                      brighter = "bloom image 2222222222222222\n";
    const std::string a = list("a.txt", depth + light + bloom);
    const Ended same = runForOutput("compare --hashes " + a + " " + a);
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.output, "all 3 images are equal\n");
    const Ended differs = runForOutput("compare --hashes " + a + " " +
                                       list("b.txt", depth + other + brighter));
    EXPECT_EQ(differs.code, 1);
    EXPECT_EQ(differs.output,
              "line 2: lighting radiance is the first that differs (aaaaaaaaaaaaaaaa, "
              "aaaaaaaaaaaaaaab); 2 of 3 do\n");
    for (const std::string& less : {depth + bloom, depth}) {
        const std::string b = list("less.txt", less);
        const Ended missing = runForOutput("compare --hashes " + a + " " + b);
        EXPECT_EQ(missing.code, 1);
        EXPECT_EQ(missing.output, "line 2: " + a + " has lighting radiance, " + b + " has " +
                                      (less == depth ? "nothing more" : "bloom image") + "\n");
    }
    for (const char* wrong :
         {"", "gbuffer 0123456789abcdeg\n", "0123456789abcdef\n", "gbuffer depth 0123\n", "\n"})
        expectError("compare --hashes " + a + " " + list("wrong.txt", wrong), 3);
    expectError("compare --hashes " + a + " /nowhere/b.txt", 3);
}

TEST(Cli, ATraceThatCannotBeWrittenIsSaidBeforeTheSceneIsLoaded) {
    for (const char* arguments :
         {"capture /nowhere/a.glb -o /nowhere/a.png", "bench /nowhere/a.glb"}) {
        const std::string traced = std::string(arguments) + " --trace /dev/null/t.json";
        expectError(traced, 3);
        EXPECT_NE(run(traced).errors.find("/dev/null"), std::string::npos) << run(traced).errors;
        EXPECT_EQ(run(traced).errors.find("a.glb"), std::string::npos);
    }
}

}  // namespace
