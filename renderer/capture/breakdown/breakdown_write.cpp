#include "renderer/capture/breakdown/breakdown.h"
#include "renderer/capture/breakdown/breakdown_json.h"
#include "renderer/capture/breakdown/breakdown_page.h"
#include "renderer/capture/breakdown/breakdown_pictures.h"
#include "renderer/capture/image_files.h"
#include "renderer/capture/write_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace rushlight {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr uint32_t kLargestInPage = 1280;

std::string base64(std::span<const std::byte> bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        for (size_t k = 0; k < count; ++k) group |= uint32_t(bytes[i + k]) << (16 - 8 * k);
        for (size_t k = 0; k < 4; ++k)
            text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

struct Pixels {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba8;
    std::vector<float> rgba32f;
};

/// A picture in the page: as small as can be without losing what is read from it. `file` are its
/// bytes as a PNG.
Result<std::string> inPage(const std::string& name, Pixels pixels, bool exact,
                           std::span<const std::byte> file) {
    if (exact && std::max(pixels.width, pixels.height) <= kLargestInPage)
        return "data:image/png;base64," + base64(file);
    shrinkPicture(pixels.width, pixels.height, pixels.rgba8, kLargestInPage);
    const auto bytes = encodeImage(name, exact ? ImageFormat::png : ImageFormat::jpeg,
                                   PictureView(pixels), EncodeEffort::small);
    if (!bytes) return tl::unexpected(bytes.error());
    return (exact ? "data:image/png;base64," : "data:image/jpeg;base64,") + base64(*bytes);
}

Result<std::string> otherInPage(const std::string& path, bool exact) {
    const auto picture = loadPicture(path);
    if (!picture) return tl::unexpected(picture.error());
    Pixels pixels{picture->width, picture->height, std::vector<uint8_t>(picture->rgba.size()), {}};
    std::ranges::transform(picture->rgba, pixels.rgba8.begin(),
                           [](float v) { return uint8_t(255 * std::clamp(v, 0.0f, 1.0f) + 0.5f); });
    const auto file = encodeImage(path, ImageFormat::png, PictureView(pixels), EncodeEffort::small);
    if (!file) return tl::unexpected(file.error());
    return inPage(path, std::move(pixels), exact, *file);
}

/// A folder beside the files that are to be replaced: all is written here before anything is moved.
class Stage {
public:
    explicit Stage(const std::string& folder)
        : folder_(folder), path_(folder + "/.breakdown-" + std::to_string(getpid())) {}
    ~Stage() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        if (madeFolder_ && !moved_) fs::remove(folder_, ignored);  // succeeds when it is empty
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    Result<void> open() {
        std::error_code error;
        if (fs::exists(folder_) && !fs::is_directory(folder_))
            return fail(folder_, "This is a file; name a folder.");
        madeFolder_ = fs::create_directories(folder_, error);
        if (!error) fs::create_directories(path_ + "/" + kPictureFolder, error);
        if (error)
            return fail(folder_, "The folder cannot be written (" + error.message() +
                                     "); what was there before is untouched.");
        return {};
    }
    template <class Content>
    Result<void> write(const std::string& name, const Content& content) {
        if (auto ok = writeFile(path_ + "/" + name, content); !ok)
            return fail(folder_ + "/" + name, ok.error().message);
        names_.push_back(name);
        return {};
    }
    Result<void> move() {
        std::error_code error;
        fs::create_directories(folder_ + "/" + kPictureFolder, error);
        for (const std::string& name : names_) {
            if (!error) fs::rename(path_ + "/" + name, folder_ + "/" + name, error);
            if (error)
                return fail(folder_ + "/" + name,
                            "The file cannot be put in place (" + error.message() + ").");
            moved_ = true;
        }
        return {};
    }
    const std::vector<std::string>& names() const { return names_; }

private:
    std::string folder_, path_;
    std::vector<std::string> names_;
    bool madeFolder_ = false, moved_ = false;
};

/// Pictures of the breakdown that is in the folder already. An Error where the files are somebody
/// else's.
Result<std::vector<std::string>> olderPictures(const std::string& folder) {
    std::error_code ignored;
    std::vector<std::string> files;
    if (fs::exists(folder + "/frame.json", ignored)) {
        if (const auto older = loadBreakdown(folder + "/frame.json")) {
            const ordered_json json = ordered_json::parse(older->json);
            for (const auto& picture : json["breakdown"]["pictures"])
                files.push_back(picture["file"].get<std::string>());
            return files;
        }
    }
    for (const char* name : {"index.html", "frame.json", "commands.txt", kPictureFolder})
        if (fs::exists(folder + "/" + name, ignored))
            return fail(folder,
                        std::string("It has a ") + name +
                            " that is no breakdown's and would be lost; name another folder.",
                        ErrorKind::wrongUse);
    return files;
}

class Writer {
public:
    Writer(const std::string& folder, const Breakdown& breakdown, const WrittenBreakdown* other)
        : folder_(folder), breakdown_(breakdown), other_(other), stage_(folder) {}

    Result<void> write() {
        const auto older = olderPictures(folder_);
        if (!older) return tl::unexpected(older.error());
        auto json = breakdownJson(breakdown_);
        if (!json) return tl::unexpected(json.error());
        page_ = *json;
        Result<void> step = stage_.open();
        if (step) step = writePictures();
        if (step && other_) step = addOther();
        if (step) step = stage_.write("commands.txt", std::string_view(breakdown_.commands));
        const std::string text = textForFile(*json);
        if (step) step = stage_.write("frame.json", std::string_view(text));
        const std::string html = page();
        if (step) step = stage_.write("index.html", std::string_view(html));
        if (step) step = stage_.move();
        if (step) removeStale(*older);
        return step;
    }

private:
    Result<void> writePictures() {
        ordered_json data = ordered_json::object();
        for (const BreakdownPicture& picture : breakdown_.pictures) {
            Pixels pixels{picture.width, picture.height, picture.rgba8, {}};
            const auto file = encodeImage(picture.name, ImageFormat::png, PictureView(pixels),
                                          picture.exact ? EncodeEffort::small : EncodeEffort::fast);
            if (!file) return tl::unexpected(file.error());
            const std::string name = std::string(kPictureFolder) + "/" + picture.name + ".png";
            if (auto ok = stage_.write(name, *file); !ok) return ok;
            auto shown = inPage(picture.name, std::move(pixels), picture.exact, *file);
            if (!shown) return tl::unexpected(shown.error());
            data[picture.name] = std::move(*shown);
        }
        page_["data"] = std::move(data);
        page_["commands"] = breakdown_.commands;
        return {};
    }

    Result<void> addOther() {
        ordered_json other = ordered_json::parse(other_->json);
        ordered_json data = ordered_json::object();
        for (const auto& picture : other["breakdown"]["pictures"]) {
            const std::string file = picture["file"].get<std::string>();
            auto shown = otherInPage(other_->folder.empty() ? file : other_->folder + "/" + file,
                                     picture["exact"].get<bool>());
            if (!shown) return tl::unexpected(shown.error());
            const std::string name = picture["name"].get<std::string>();
            if (page_["data"].contains(name) && page_["data"][name] == *shown) continue;
            data[name] = std::move(*shown);
        }
        page_["compared"] = comparePasses(page_["passes"], other["passes"]);
        other["data"] = std::move(data);
        page_["other"] = std::move(other);
        return {};
    }

    /// The parts in their places; nothing of the frame is outside of the data.
    std::string page() const {
        const PageParts parts = breakdownPageParts();
        std::string html(parts.html);
        const auto put = [&](std::string_view mark, std::string_view text) {
            html.replace(html.find(mark), mark.size(), text);
        };
        put("{{STYLE}}", parts.style);
        std::string script;
        for (const std::string_view part : parts.scripts) script += part;
        put("{{SCRIPT}}", script);
        put("{{DATA}}", textForPage(page_));
        return html;
    }

    void removeStale(const std::vector<std::string>& older) const {
        const std::set<std::string> written(stage_.names().begin(), stage_.names().end());
        std::error_code ignored;
        for (const std::string& file : older)
            if (!written.contains(file)) fs::remove(folder_ + "/" + file, ignored);
    }

    const std::string& folder_;
    const Breakdown& breakdown_;
    const WrittenBreakdown* other_;
    Stage stage_;
    ordered_json page_;
};

}  // namespace

Result<void> writeBreakdown(const std::string& folder, const Breakdown& breakdown,
                            const WrittenBreakdown* other) {
    return Writer(folder, breakdown, other).write();
}

}  // namespace rushlight
