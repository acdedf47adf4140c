#include "renderer/testing/review.h"

#include <cctype>
#include <cstdio>
#include <filesystem>

namespace rushlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = R"(<!doctype html>
<meta charset="utf-8">
<title>Golden pictures</title>
<style>
body { font: 15px sans-serif; margin: 2em; background: #222; color: #ddd }
figure { display: inline-block; margin: 0 1em 1em 0; vertical-align: top }
img { max-width: 30vw; min-width: 160px; image-rendering: pixelated; display: block; background: #000 }
code { color: #9cf }
</style>
<h1>Golden pictures</h1>
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    return result;
}

/// A path as a relative address.
std::string address(const std::string& path) {
    std::string result;
    char code[4];
    for (const unsigned char c : path) {
        if (std::isalnum(c) || c == '/' || c == '.' || c == '-' || c == '_') {
            result += char(c);
            continue;
        }
        std::snprintf(code, sizeof code, "%%%02X", c);
        result += code;
    }
    return result;
}

std::string figuresText(const Review& review) {
    if (!review.figures) return {};
    const Figures& f = *review.figures;
    char text[200];
    std::snprintf(
        text, sizeof text,
        "flip %.5f, psnr %.1f dB, ssim %.5f, largest error %.4f, %llu of %llu pixels differ",
        f.flip, f.psnr, f.ssim, f.maxError, static_cast<unsigned long long>(f.changedPixels),
        static_cast<unsigned long long>(f.pixels));
    return text;
}

std::string section(const Review& review, const fs::path& root) {
    const fs::path folder = review.evidence.folder;
    const std::string at = folder.lexically_relative(root).generic_string();
    const char* extension = review.evidence.linear ? ".exr" : ".png";
    std::string html = "<h2>" + escaped(review.evidence.name) + ": " + toText(review.change) +
                       "</h2>\n<p><code>" + escaped(review.evidence.golden) + "</code><br>" +
                       escaped(figuresText(review)) + " " + escaped(review.problem) + "</p>\n";
    const auto figure = [&](const std::string& file, const char* caption) {
        std::error_code ignored;
        if (!fs::exists(folder / file, ignored)) return;
        const std::string link = address(at + "/" + file);
        html += "<figure><a href=\"" + link + "\"><img src=\"" + link + "\" alt=\"" + caption +
                "\"></a><figcaption>" + caption + "</figcaption></figure>\n";
    };
    figure(std::string("golden") + extension, "before");
    figure(std::string("actual") + extension, "after");
    figure("heat.png", "difference (FLIP)");
    figure("error.png", "difference (largest of a value)");
    std::error_code ignored;
    if (fs::exists(folder / "breakdown/index.html", ignored))
        html += "<p><a href=\"" + address(at + "/breakdown/index.html") +
                "\">the frame taken apart</a></p>\n";
    return html;
}

}  // namespace

std::string reviewPage(std::span<const Review> reviews, const std::string& folder) {
    const fs::path root = fs::absolute(folder).lexically_normal();
    std::string html = kHead;
    for (const Review& review : reviews)
        if (review.change != Change::none) html += section(review, root);
    for (const Review& review : reviews)
        if (review.change == Change::none)
            html += "<p>" + escaped(review.evidence.name) + ": " + toText(review.change) + "</p>\n";
    return html;
}

}  // namespace rushlight::golden
