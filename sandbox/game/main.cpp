#include "sandbox/allocations.h"
#include "sandbox/game/dusk_game.h"
#include "sandbox/game/options.h"
#include "sandbox/process_memory.h"
#include "sandbox/viewer/program_files.h"

#include <cstdio>

int main(int argc, char** argv) {
    using namespace rushlight;
    keepFreedMemory();
    int exitCode = 0;
    auto options = parseOptions(argc, argv, exitCode);
    if (!options) return exitCode;
    if (options->viewer.scene.empty())
        options->viewer.scene = findProgramFile("content/square/square.gltf").string();
    if (options->viewer.scene.empty()) {
        std::fprintf(stderr,
                     "sandbox: error: content/square/square.gltf: The level is neither beside the "
                     "program nor in its share folder; name one with --level FILE.\n");
        return 3;
    }
    options->viewer.lighting = duskLighting();
    // The square's own sky, unless another is asked for.
    if (options->viewer.environment.empty())
        options->viewer.environment = findProgramFile("content/square/dusk.hdr").string();
    if (!options->viewer.environment.empty())
        options->viewer.lighting.background = Background::environment;
    options->viewer.allocationCount = allocationCount;
    options->viewer.pinRasterThreads = true;
    DuskGame game(options->allLit);
    return runViewer(options->viewer, &game);
}
