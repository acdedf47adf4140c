#include "sandbox/process_memory.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/words.h"

#include <algorithm>
#include <cstdio>
#include <new>

namespace rushlight::tool {
namespace {

int run(int argumentCount, char** arguments) {
    CLI::App app("Rushlight: renders glTF scenes offscreen, measures and compares.", "rushlight");
    app.footer("@FILE stands for the words in a file.");
    app.set_version_flag("--version", "rushlight " RUSHLIGHT_VERSION);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Action action;
    addCapture(app, action);
    addBreakdown(app, action);
    addCompare(app, action);
    addCheck(app, action);
    addGoldens(app, action);
    addBench(app, action);
    addBake(app, action);
    addInfo(app, action);
    addReplay(app, action);
    addDiagnose(app, action);
    addExplain(app, action);
    addDoctor(app, action);
    addView(app, action);
    auto words = commandWords(argumentCount, arguments);
    if (!words) {
        printError(words.error());
        return exitCode(words.error().kind);
    }
    std::ranges::reverse(*words);  // as CLI11 takes them
    try {
        app.parse(std::move(*words));
    } catch (const CLI::Success& success) {  // --help and --version
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        std::string message = error.what();
        while (message.ends_with('.') || message.ends_with('\n')) message.pop_back();
        printError({"command line", message + "; see rushlight --help.", ErrorKind::wrongUse});
        return exitCode(ErrorKind::wrongUse);
    }
    const auto result = action();
    if (result) return *result;
    printError(result.error());
    return exitCode(result.error().kind);
}

}  // namespace
}  // namespace rushlight::tool

int main(int argumentCount, char** arguments) {
    rushlight::keepFreedMemory();
    try {
        return rushlight::tool::run(argumentCount, arguments);
    } catch (const std::bad_alloc&) {
        rushlight::tool::printError({"memory", "There is not enough memory for this.", {}});
        return 3;
    }
}
