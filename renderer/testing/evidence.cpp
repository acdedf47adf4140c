#include "renderer/testing/evidence.h"

#include "engine/core/hash128.h"
#include "renderer/capture/image_files.h"
#include "renderer/capture/write_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rushlight::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kOwnFiles[] = {"actual.png", "actual.exr", "golden.png", "golden.exr",
                                     "error.png",  "heat.png",   "index.html", kEvidenceFile};

/// A test's name as a folder's: no separators, and no way out of where it is.
std::string folderName(const std::string& name) {
    std::string safe;
    if (name.empty() || name.front() == '.') safe += '_';
    for (const char c : name) {
        const bool good = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-';
        safe += good ? c : '_';
    }
    return safe;
}

std::string actualName(const Frame& frame) {
    return frame.image.rgba32f.empty() ? "actual.png" : "actual.exr";
}

Result<void> saveActual(const std::string& path, const Frame& frame) {
    const auto format = imageFormatOf(path);
    const auto bytes = encodeImage(path, *format, PictureView(frame.image), EncodeEffort::small);
    if (!bytes) return tl::unexpected(bytes.error());
    return writeFile(path, *bytes);
}

}  // namespace

Result<std::vector<std::byte>> readFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? std::streamoff(file.tellg()) : -1;
    std::vector<std::byte> bytes(size > 0 ? size_t(size) : 0);
    file.seekg(0);
    if (size >= 0 && file.read(reinterpret_cast<char*>(bytes.data()), size)) return bytes;
    return fail(path,
                "The file could not be read (" + std::generic_category().message(errno) + ").");
}

Result<std::string> hashOfFile(const std::string& path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return std::string();
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return toText(hash128(*bytes));
}

EvidenceWriter::EvidenceWriter(const EvidenceOptions& options, const std::string& golden) {
    const std::string root = options.folder.empty() ? evidenceFolder() : options.folder;
    const std::string name = options.name.empty() ? fs::path(golden).stem().string() : options.name;
    folder_ = (fs::absolute(root).lexically_normal() / folderName(name)).string();
}

Result<void> EvidenceWriter::write(const Frame& frame, const Verdict& verdict,
                                   const Comparison* comparison) {
    if (auto cleared = clear(); !cleared) return cleared;
    const auto hash = hashOfFile(verdict.golden);
    if (!hash) return tl::unexpected(hash.error());
    const ordered_json json = {
        {"version", kVersion},
        {"golden", fs::path(verdict.golden).lexically_proximate(folder_).string()},
        {"golden_hash", *hash},
        {"actual", actualName(frame)},
        {"passed", verdict.passed}};
    // The file that names the others comes first: what is there without it would never be removed.
    const std::string text = json.dump(2, ' ', false, ordered_json::error_handler_t::replace) +
                             "\n";
    if (auto ok = writeFile(path(kEvidenceFile), text); !ok) return ok;
    if (auto ok = saveActual(path(actualName(frame)), frame); !ok) return ok;
    if (!hash->empty()) {
        const auto bytes = readFile(verdict.golden);
        if (!bytes) return tl::unexpected(bytes.error());
        const std::string copy = "golden" + fs::path(verdict.golden).extension().string();
        if (auto ok = writeFile(path(copy), *bytes); !ok) return ok;
    }
    if (!comparison) return {};
    if (auto ok = saveHeatMap(path("error.png"), comparison->errors); !ok) return ok;
    return saveHeatMap(path("heat.png"), comparison->flipErrors);
}

Result<void> EvidenceWriter::takeApart(const Frame& frame) {
    if (!frame.takeApart) return {};
    auto breakdown = frame.takeApart();
    if (!breakdown) return tl::unexpected(breakdown.error());
    if (breakdown->title.empty()) breakdown->title = fs::path(folder_).filename().string();
    return writeBreakdown(path("breakdown"), *breakdown);
}

Result<void> EvidenceWriter::clear() {
    std::error_code error;
    if (!fs::exists(path(kEvidenceFile), error)) return {};
    for (const char* name : {"index.html", "frame.json", "commands.txt"})
        fs::remove(path("breakdown/") + name, error);
    if (fs::exists(path("breakdown/pictures"), error))
        for (const auto& entry : fs::directory_iterator(path("breakdown/pictures"), error))
            if (entry.path().extension() == ".png") fs::remove(entry.path(), error);
    for (const char* folder : {"breakdown/pictures", "breakdown"}) fs::remove(path(folder), error);
    for (const char* name : kOwnFiles) fs::remove(path(name), error);
    if (fs::exists(path(kEvidenceFile), error))
        return fail(path(kEvidenceFile), "What an earlier run left behind could not be removed.");
    fs::remove(folder_, error);  // where nobody has put anything else
    return {};
}

Result<Evidence> readEvidence(const std::string& folder) {
    const std::string file = folder + "/" + kEvidenceFile;
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const ordered_json json = ordered_json::parse(text, nullptr, false);
    const auto textAt = [&](const char* key) {
        return json.is_object() && json.contains(key) && json[key].is_string()
                   ? json[key].get<std::string>()
                   : std::string();
    };
    Evidence evidence;
    evidence.folder = folder;
    evidence.name = fs::path(folder).filename().string();
    const std::string golden = textAt("golden");
    if (!golden.empty())
        evidence.golden = (fs::absolute(folder) / golden).lexically_normal().string();
    evidence.goldenHash = textAt("golden_hash");
    const std::string actual = textAt("actual");
    evidence.linear = actual == "actual.exr";
    const bool good = json.is_object() && json.contains("version") && json["version"] == kVersion &&
                      (evidence.linear || actual == "actual.png") &&
                      imageFormatOf(evidence.golden).value_or(ImageFormat::jpeg) ==
                          (evidence.linear ? ImageFormat::exr : ImageFormat::png);
    if (!good)
        return fail(file, "This is no evidence of a test; run the test again, it writes it anew.");
    evidence.passed = json.contains("passed") && json["passed"] == true;
    evidence.actual = folder + "/" + actual;
    return evidence;
}

}  // namespace rushlight::golden
