#include "renderer/capture/compare/compare.h"

#include "renderer/capture/image_files.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/hash_lists.h"
#include "sandbox/tool/options.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

namespace rushlight::tool {
namespace {

struct CompareArguments {
    std::string a;
    std::string b;
    std::string diff, error;
    std::optional<double> maxFlip, minPsnr, maxError, minSsim, minAlphaOverlap;
    float pixelsPerDegree = kDefaultPixelsPerDegree;
    bool hashes = false;
};

/// One line of the report; "ok" or "over" where there is a limit.
bool printMeasure(const char* name, double value, const char* unit, std::optional<double> limit,
                  bool limitIsMinimum) {
    std::printf("%-11s %.6g%s", name, value, unit);
    const bool passed = !limit || (limitIsMinimum ? value >= *limit : value <= *limit);
    if (limit)
        std::printf("  (%s %g: %s)", limitIsMinimum ? "at least" : "at most", *limit,
                    passed ? "ok" : "failed");
    std::printf("\n");
    return passed;
}

Result<int> compare(const CompareArguments& arguments) {
    if (arguments.hashes) {
        const auto equal = compareHashLists(arguments.a, arguments.b);
        if (!equal) return tl::unexpected(equal.error());
        return *equal ? kSuccess : kComparisonFailed;
    }
    for (const std::string& path : {arguments.diff, arguments.error})
        if (!path.empty())
            if (auto format = imageFormatOf(path); !format) return tl::unexpected(format.error());
    const auto a = loadPicture(arguments.a);
    if (!a) return tl::unexpected(a.error());
    const auto b = loadPicture(arguments.b);
    if (!b) return tl::unexpected(b.error());
    const auto result = comparePictures(*a, *b, arguments.a, arguments.b,
                                        {.pixelsPerDegree = arguments.pixelsPerDegree});
    if (!result) return tl::unexpected(result.error());

    bool passed = printMeasure("flip", result->flip, "", arguments.maxFlip, false);
    passed &= printMeasure("psnr", result->psnr, " dB", arguments.minPsnr, true);
    passed &= printMeasure("max error", result->maxError, "", arguments.maxError, false);
    printMeasure("mean error", result->meanError, "", {}, false);
    passed &= printMeasure("ssim", result->ssim, "", arguments.minSsim, true);
    passed &= printMeasure("alpha", result->alphaOverlap, "", arguments.minAlphaOverlap, true);
    if (!arguments.diff.empty())
        if (auto saved = saveHeatMap(arguments.diff, result->flipErrors); !saved)
            return tl::unexpected(saved.error());
    if (!arguments.error.empty())
        if (auto saved = saveHeatMap(arguments.error, result->errors); !saved)
            return tl::unexpected(saved.error());
    return passed ? kSuccess : kComparisonFailed;
}

}  // namespace

void addCompare(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command = app.add_subcommand(
        "compare", "How different two pictures are, in numbers and as a picture");
    command->add_option("A", arguments->a, "The reference: PNG, JPEG, EXR, HDR and others")
        ->required();
    command->add_option("B", arguments->b, "The picture to judge, of the same size")->required();
    const auto addLimit = [&](const char* name, std::optional<double>& limit, const char* help) {
        command->add_option(name, limit, help)->check(finiteNumber());
    };
    addLimit("--flip", arguments->maxFlip,
             "Exit with 1 when the mean FLIP error is over this (0 to 1)");
    addLimit("--psnr", arguments->minPsnr, "Exit with 1 when the PSNR is under this (dB)");
    addLimit("--max-error", arguments->maxError,
             "Exit with 1 when a value differs by more than this (8 bit pictures: 0 to 1)");
    addLimit("--ssim", arguments->minSsim,
             "Exit with 1 when the structural similarity is under this (-1 to 1)");
    addLimit("--alpha-overlap", arguments->minAlphaOverlap,
             "Exit with 1 when less of what either covers is covered by both (0 to 1)");
    command->add_option("--diff", arguments->diff,
                        "Write the FLIP error of every pixel as a picture");
    command->add_option("--error", arguments->error,
                        "Write the largest difference of the values of every pixel as a picture");
    command
        ->add_option("--pixels-per-degree", arguments->pixelsPerDegree,
                     "Of the display as the viewer sees it, for FLIP")
        ->check(finiteNumber())
        ->check(CLI::Range(1.0f, 500.0f))
        ->capture_default_str();
    CLI::Option* hashes = command->add_flag("--hashes", arguments->hashes,
                                            "A and B are what `capture --hashes` printed: name the "
                                            "first pass that differs, exit with 1");
    for (CLI::Option* option : command->get_options())
        if (option != hashes && option->nonpositional() && option->get_name() != "--help")
            hashes->excludes(option);
    command->callback(
        [&action, arguments] { action = [arguments] { return compare(*arguments); }; });
}

}  // namespace rushlight::tool
