#include "renderer/testing/verdict.h"

#include "renderer/capture/image_files.h"
#include "renderer/testing/evidence.h"
#include "renderer/testing/program_folder.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace rushlight::golden {
namespace {

namespace fs = std::filesystem;

/// Half a step of 8 bit: what is stored as whole codes is read as 255ths, which rounds.
constexpr double kHalfCode = 0.5 / 255;

const char* unitOf(Measure measure) { return measure == Measure::psnr ? " dB" : ""; }

bool isAtLeast(Measure measure) { return measure == Measure::psnr || measure == Measure::ssim; }

std::string line(const Criterion& criterion, const Figures& figures) {
    char text[160];
    const double value = figures.of(criterion.measure);
    std::snprintf(text, sizeof text, "  %-14s %.6g%s, %s %g: %s\n", toText(criterion.measure),
                  value, unitOf(criterion.measure),
                  isAtLeast(criterion.measure) ? "at least" : "at most", criterion.limit,
                  meets(criterion, value) ? "ok" : "failed");
    return text;
}

Result<void> check(const Near& expected, bool linear) {
    if (expected.criteria.empty())
        return fail(expected.path, "There is no criterion to judge by.", ErrorKind::wrongUse);
    const auto format = imageFormatOf(expected.path);
    if (format && *format == (linear ? ImageFormat::exr : ImageFormat::png)) return {};
    return fail(expected.path,
                linear ? "The golden of a linear picture is an .exr."
                       : "The golden of an 8 bit picture is a .png.",
                ErrorKind::wrongUse);
}

bool wantsEvidence(const EvidenceOptions& options) {
    const char* always = std::getenv("RUSHLIGHT_EVIDENCE_ALWAYS");
    return options.always || (always && std::string_view(always) == "1");
}

/// Fills what comparing gives, and the comparison for pictures of it.
Result<std::optional<Comparison>> compare(const Picture& actual, Verdict& verdict) {
    std::error_code ignored;
    if (!fs::exists(verdict.golden, ignored)) {
        verdict.problem = "There is no golden picture yet.";
        return std::nullopt;
    }
    const auto golden = loadPicture(verdict.golden);
    if (!golden) return tl::unexpected(golden.error());
    auto comparison = comparePictures(*golden, actual, "the golden picture", "the frame");
    if (!comparison) {
        verdict.problem = comparison.error().message;
        return std::nullopt;
    }
    verdict.figures = figuresOf(*comparison, actual.linear);
    verdict.passed = true;
    for (const Criterion& criterion : verdict.criteria)
        verdict.passed &= meets(criterion, verdict.figures->of(criterion.measure));
    return std::optional(std::move(*comparison));
}

}  // namespace

const char* toText(Measure measure) {
    switch (measure) {
        case Measure::flip: return "flip";
        case Measure::psnr: return "psnr";
        case Measure::ssim: return "ssim";
        case Measure::maxError: return "max error";
        case Measure::changedPixels: return "changed pixels";
    }
    return "";
}

double Figures::of(Measure measure) const {
    switch (measure) {
        case Measure::flip: return flip;
        case Measure::psnr: return psnr;
        case Measure::ssim: return ssim;
        case Measure::maxError: return maxError;
        case Measure::changedPixels: return double(changedPixels);
    }
    return std::nan("");
}

Figures figuresOf(const Comparison& comparison, bool linear) {
    Figures figures{comparison.flip,
                    comparison.psnr,
                    comparison.ssim,
                    comparison.maxError,
                    0,
                    comparison.errors.values.size()};
    for (const double error : comparison.errors.values)
        figures.changedPixels += !(error <= (linear ? 0 : kHalfCode));
    return figures;
}

bool meets(const Criterion& criterion, double value) {
    return isAtLeast(criterion.measure) ? value >= criterion.limit : value <= criterion.limit;
}

std::string evidenceFolder() {
    if (const char* named = std::getenv("RUSHLIGHT_EVIDENCE"); named && *named) return named;
    return (programFolder() / "rushlight-evidence").string();
}

std::string Verdict::text() const {
    std::string text = "The frame is " + std::string(passed ? "near" : "not as") +
                       " its golden picture " + golden + "\n";
    if (figures) {
        for (const Criterion& criterion : criteria) text += line(criterion, *figures);
        text += "  " + std::to_string(figures->changedPixels) + " of " +
                std::to_string(figures->pixels) + " pixels differ\n";
    } else {
        text += "  " + problem + "\n";
    }
    if (!evidence.empty()) {
        text += "  left behind in " + evidence + "\n";
        text += "  to see what would change, and then to accept it:\n    rushlight goldens \"" +
                evidence + "\"\n    rushlight goldens \"" + evidence + "\" --accept\n";
    }
    if (!evidenceProblem.empty()) text += "  " + evidenceProblem + "\n";
    return text;
}

Result<Verdict> judge(const Frame& frame, const Near& expected, const EvidenceOptions& options) {
    const bool linear = !frame.image.rgba32f.empty();
    if (auto checked = check(expected, linear); !checked) return tl::unexpected(checked.error());
    Verdict verdict;
    verdict.golden = fs::absolute(expected.path).lexically_normal().string();
    verdict.criteria = expected.criteria;
    const Picture actual = pictureOf(PictureView(frame.image));
    const auto comparison = compare(actual, verdict);
    if (!comparison) return tl::unexpected(comparison.error());
    EvidenceWriter evidence(options, verdict.golden);
    const bool keep = !verdict.passed || wantsEvidence(options);
    auto written = keep ? evidence.write(frame, verdict, *comparison ? &**comparison : nullptr)
                        : evidence.clear();
    if (keep && written && !verdict.passed && *comparison && options.breakdown)
        written = evidence.takeApart(frame);
    if (!written) verdict.evidenceProblem = written.error().text();
    if (keep) verdict.evidence = evidence.folder();
    return verdict;
}

}  // namespace rushlight::golden
