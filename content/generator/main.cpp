// rushlight-content OUTDIR: makes the project's own content, the same bytes on every machine.

#include "content/generator/sky.h"
#include "content/generator/square.h"
#include "content/generator/surface.h"

#include <cstdio>
#include <string_view>

using namespace rushlight::content;
namespace fs = std::filesystem;

namespace {

void savePicture(const fs::path& folder, const std::string& name, const Picture& picture) {
    writeFile(folder / (name + ".png"), encodePng(picture));
}

void saveSurface(const fs::path& folder, const SurfaceSpec& spec, bool color, bool detail) {
    const SurfaceMaps maps = bakeSurface(spec);
    if (color) savePicture(folder, spec.name + "_color", maps.color);
    if (!detail) return;
    savePicture(folder, spec.name + "_normal", maps.normal);
    savePicture(folder, spec.name + "_orm", maps.orm);
}

void makeSquare(const fs::path& folder) {
    fs::create_directories(folder);
    for (const SurfaceSpec& spec :
         {cobbleSurface(), gravelSurface(), ashlarSurface(), stoneSurface(), brickSurface(),
          plasterSurface(), roofTileSurface(), plankSurface(), metalSurface(), leafSurface()})
        saveSurface(folder, spec, true, true);
    saveSurface(folder, clothSurface({0.62f, 0.16f, 0.13f}, "cloth_red"), true, false);
    saveSurface(folder, clothSurface({0.16f, 0.27f, 0.45f}, "cloth_blue"), true, false);
    saveSurface(folder, clothSurface({0.5f, 0.5f, 0.5f}, "cloth"), false, true);
    saveSurface(folder, windowSurface(), true, false);
    const SurfaceMaps water = bakeSurface(waterSurface());
    savePicture(folder, "water_normal", water.normal);
    writeFile(folder / "dusk.hdr", encodeDuskSky());
    const Square square = buildSquare();
    square.document.save(folder);
    std::printf("square: %zu nodes, %zu triangles drawn, %d lamps\n", square.document.nodeCount(),
                square.document.drawnTriangles(), square.lamps);
}

void makeTestCard(const fs::path& folder) {
    fs::create_directories(folder);
    SurfaceSpec mask = leafSurface();
    mask.size = 128;
    savePicture(folder, "mask", bakeSurface(mask).color);
    buildTestCard().save(folder);
}

}  // namespace

int main(int argc, char** argv) {
    const bool help = argc == 2 && std::string_view(argv[1]) == "--help";
    if (argc != 2 || help) {
        std::fprintf(
            help ? stdout : stderr,
            "usage: rushlight-content OUTDIR\n"
            "Writes the folders square and testcard (glTF, buffers, pictures) into OUTDIR.\n");
        return help ? 0 : 2;
    }
    const fs::path out = argv[1];
    makeTestCard(out / "testcard");
    makeSquare(out / "square");
    return 0;
}
