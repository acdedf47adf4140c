#include "renderer/context/context.h"
#include "sandbox/tool/command.h"

#include <algorithm>
#include <cstdio>

namespace rushlight::tool {
namespace {

void print(const ContextAttempt& attempt) {
    if (!attempt.worked) {
        std::printf("%-16s no   %s\n", toText(attempt.kind), attempt.reason.c_str());
        return;
    }
    std::printf("%-16s yes  OpenGL %s, GLSL %s\n", toText(attempt.kind), attempt.glVersion.c_str(),
                attempt.glslVersion.c_str());
    std::printf("%-16s      %s, %s\n", "", attempt.glRenderer.c_str(), attempt.glVendor.c_str());
    for (const std::string& line : attempt.missing)
        std::printf("%-16s      reduced: %s\n", "", line.c_str());
}

Result<int> doctor() {
    const auto attempts = probeContexts();
    for (const ContextAttempt& attempt : attempts) print(attempt);
    const auto first = std::ranges::find_if(attempts, &ContextAttempt::worked);
    if (first == attempts.end())
        return fail(
            "OpenGL 4.5 core",
            "No context works here; install Mesa's libegl1 and libgl1-mesa-dri, or libosmesa6.",
            ErrorKind::noContext);
    std::printf("\n--context auto takes %s.\n", toText(first->kind));
    return kSuccess;
}

}  // namespace

void addDoctor(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("doctor",
                                           "Which ways to an OpenGL 4.5 context work here, why the "
                                           "others do not, and what is reduced");
    command->callback([&action] { action = doctor; });
}

}  // namespace rushlight::tool
