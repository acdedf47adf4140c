// Says how the goldens would change; with --write, changes them.

#include "renderer/capture/compare.h"
#include "renderer/capture/image_files.h"
#include "renderer/context/context.h"
#include "tests/golden/goldens.h"

#include <cstdio>
#include <cstring>

namespace rushlight {
namespace {

/// What is new in a line. `changed`: the file's pixels would be others.
std::string describe(const Golden& golden, const CapturedImage& image, bool& changed) {
    changed = true;
    const auto old = loadPicture(goldenPath(golden));
    if (!old) return "new";
    const auto comparison =
        comparePictures(*old, pictureOf(image), goldenPath(golden), "the frame");
    if (!comparison) return comparison.error().message;
    changed = comparison->maxError > 0.5 / 255;  // both are whole 255ths, divided in two ways
    if (!changed) return "the same";
    const bool fails = comparison->flip > kMaxFlip || comparison->psnr < kMinPsnr;
    char line[128];
    std::snprintf(line, sizeof line, "flip %.5f, psnr %.1f dB, largest error %.3f: %s",
                  comparison->flip, comparison->psnr, comparison->maxError,
                  fails ? "over the limits" : "within the limits");
    return line;
}

Result<void> update(bool write) {
    auto context = createOffscreenContext(ContextChoice::automatic, {});
    if (!context) return tl::unexpected(context.error());
    for (const Golden& golden : goldens()) {
        const auto image = renderGolden(golden, (*context)->loader());
        if (!image) return tl::unexpected(image.error());
        bool changed = false;
        const std::string text = describe(golden, *image, changed);
        std::printf("%-20s %s%s\n", golden.name, text.c_str(),
                    changed ? (write ? " (written)" : " (would be written)") : "");
        if (!changed || !write) continue;
        if (auto saved = saveImage(goldenPath(golden), PictureView(*image)); !saved) return saved;
    }
    return {};
}

}  // namespace
}  // namespace rushlight

int main(int count, char** arguments) {
    const bool write = count == 2 && std::strcmp(arguments[1], "--write") == 0;
    if (count > 1 && !write) {
        std::fputs("usage: golden_update [--write]\n", stderr);
        return 2;
    }
    const auto updated = rushlight::update(write);
    if (updated) return 0;
    std::fprintf(stderr, "golden_update: error: %s\n", updated.error().text().c_str());
    return 3;
}
