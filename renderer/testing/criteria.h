#pragma once
// How near a picture has to be to its golden one: near("golden/square.png", flip(0.02), psnr(35)).

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <source_location>
#include <string>
#include <vector>

namespace rushlight::golden {

enum class Measure : uint8_t { flip, psnr, ssim, maxError, changedPixels };

struct Criterion {
    Measure measure = Measure::changedPixels;
    double limit = 0;
};

/// Mean FLIP error, 0 to 1; of linear pictures HDR-FLIP.
constexpr Criterion flip(double atMost) { return {Measure::flip, atMost}; }
/// dB, for a peak of 1.
constexpr Criterion psnr(double atLeast) { return {Measure::psnr, atLeast}; }
/// Structural similarity of luma, 1 when equal.
constexpr Criterion ssim(double atLeast) { return {Measure::ssim, atLeast}; }
/// The largest difference of a value as stored: sRGB from 0 to 1, or linear.
constexpr Criterion maxError(double atMost) { return {Measure::maxError, atMost}; }
/// The same pixels; the files' bytes may differ.
constexpr Criterion exact() { return {Measure::changedPixels, 0}; }

/// A relative path is one from the folder of the source file that names it. Where the compiler was
/// given a relative name for that, as ccache does, it is looked for from the working directory, and
/// from the program's folder upwards.
struct GoldenPath {
    GoldenPath(const char* path, std::source_location where = std::source_location::current())
        : GoldenPath(std::filesystem::path(path), where) {}
    GoldenPath(const std::string& path,
               std::source_location where = std::source_location::current())
        : GoldenPath(std::filesystem::path(path), where) {}
    GoldenPath(const std::filesystem::path& path,
               std::source_location where = std::source_location::current());

    std::string text;
};

/// The path of a source file that a compiler named, as above.
std::filesystem::path findSourceFile(const std::filesystem::path& name);

/// All criteria have to be met. The golden is a .png, or an .exr for linear pictures.
struct Near {
    std::string path;
    std::vector<Criterion> criteria;
};

template <std::same_as<Criterion>... More>
Near near(const GoldenPath& path, Criterion first, More... more) {
    return {path.text, {first, more...}};
}

}  // namespace rushlight::golden
