#include "renderer/capture/breakdown/breakdown_json.h"

#include "renderer/capture/report_json.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <map>

namespace rushlight {

using nlohmann::ordered_json;

namespace {

const char* toText(Readout readout) {
    switch (readout) {
        case Readout::color: return "color";
        case Readout::unit: return "unit";
        case Readout::direction: return "direction";
        case Readout::velocity: return "velocity";
        case Readout::distance: return "distance";
        case Readout::count: return "count";
    }
    return "color";
}

std::string hexOf(uint64_t hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016" PRIx64, hash);
    return digits;
}

ordered_json imagesJson(const PassReport& pass) {
    ordered_json images = ordered_json::array();
    for (size_t i = 0; i < pass.images.size(); ++i) {
        const PassImage& image = pass.images[i];
        ordered_json entry = {
            {"name", image.name},   {"format", rushlight::toText(image.format)},
            {"width", image.width}, {"height", image.height},
            {"layer", image.layer}, {"bytes_per_pixel", bytesPerTexel(image.format)}};
        if (i < pass.hashes.size()) entry["hash"] = hexOf(pass.hashes[i]);
        images.push_back(std::move(entry));
    }
    return images;
}

/// What the frame cost beside its passes, so that the sums are the frame's.
ordered_json outsideJson(const FrameReport& report) {
    uint32_t calls = report.glCalls, changes = report.stateChanges;
    for (const PassReport& pass : report.passes)
        calls -= pass.glCalls, changes -= pass.stateChanges;
    return {{"gl_calls", calls}, {"state_changes", changes}};
}

ordered_json pictureJson(const BreakdownPicture& picture) {
    return {{"name", picture.name},
            {"file", std::string(kPictureFolder) + "/" + picture.name + ".png"},
            {"section", picture.section},
            {"pass", picture.pass},
            {"image", picture.image},
            {"title", picture.title},
            {"note", picture.note},
            {"readout", toText(picture.readout)},
            {"low", picture.low},
            {"high", picture.high},
            {"exact", picture.exact},
            {"width", picture.width},
            {"height", picture.height}};
}

std::string dump(const ordered_json& json, int indent) {
    // Names come from files and may be no UTF-8.
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::vector<std::string> hashesOf(const ordered_json& pass) {
    std::vector<std::string> hashes;
    for (const ordered_json& image : pass.value("images", ordered_json::array()))
        hashes.push_back(image.value("name", "") + " " + image.value("hash", ""));
    return hashes;
}

ordered_json comparedPair(const ordered_json& a, const ordered_json& b) {
    ordered_json counters = ordered_json::array();
    for (const char* key : {"draws", "triangles", "gl_calls", "state_changes", "bytes_per_pixel"})
        if (a.value(key, ordered_json()) != b.value(key, ordered_json())) counters.push_back(key);
    return {{"outputs", hashesOf(a) != hashesOf(b)}, {"counters", counters}};
}

int rankOf(const ordered_json& pair) {
    if (pair["outputs"] == true) return 0;
    if (pair["a"].is_null() || pair["b"].is_null()) return 1;
    return pair["counters"].empty() ? 3 : 2;
}

}  // namespace

Result<ordered_json> breakdownJson(const Breakdown& breakdown) {
    ordered_json json = ordered_json::parse(breakdown.host, nullptr, false);
    if (!json.is_object())
        return fail("breakdown", "what the host says of the frame is no JSON object.",
                    ErrorKind::wrongUse);
    if (!json.contains("version")) json["version"] = 1;
    ordered_json frame = json.value("frame", ordered_json::object());
    if (!frame.is_object()) frame = ordered_json::object();
    frame.update(frameJson(breakdown.report));
    json["frame"] = std::move(frame);
    ordered_json passes = passesJson(breakdown.report);
    for (size_t i = 0; i < passes.size(); ++i) {
        passes[i]["section"] = breakdownSectionOf(breakdown.report.passes[i].name);
        passes[i]["images"] = imagesJson(breakdown.report.passes[i]);
    }
    json["passes"] = std::move(passes);
    ordered_json sections = ordered_json::array(), pictures = ordered_json::array();
    for (const BreakdownSection& section : breakdownSections())
        sections.push_back({{"id", section.id}, {"title", section.title}, {"text", section.text}});
    for (const BreakdownPicture& picture : breakdown.pictures)
        pictures.push_back(pictureJson(picture));
    json["breakdown"] = {{"title", breakdown.title},
                         {"outside_passes", outsideJson(breakdown.report)},
                         {"sections", std::move(sections)},
                         {"pictures", std::move(pictures)}};
    return json;
}

ordered_json comparePasses(const ordered_json& a, const ordered_json& b) {
    // The n-th pass of a name is compared with the n-th.
    std::map<std::pair<std::string, int>, size_t> ofB;
    std::map<std::string, int> seen;
    const auto keyOf = [&](const ordered_json& pass) {
        const std::string name = pass.value("name", "");
        return std::pair(name, seen[name]++);
    };
    for (size_t i = 0; i < b.size(); ++i) ofB[keyOf(b[i])] = i;
    seen.clear();
    std::vector<ordered_json> pairs;
    for (size_t i = 0; i < a.size(); ++i) {
        const auto found = ofB.find(keyOf(a[i]));
        ordered_json pair = {{"name", a[i].value("name", "")},
                             {"a", i},
                             {"b", nullptr},
                             {"outputs", false},
                             {"counters", ordered_json::array()}};
        if (found != ofB.end()) {
            pair["b"] = found->second;
            pair.update(comparedPair(a[i], b[found->second]));
            ofB.erase(found);
        }
        pairs.push_back(std::move(pair));
    }
    for (const auto& [key, index] : ofB)
        pairs.push_back({{"name", key.first},
                         {"a", nullptr},
                         {"b", index},
                         {"outputs", false},
                         {"counters", ordered_json::array()}});
    std::ranges::stable_sort(pairs, {}, rankOf);
    return pairs;
}

std::string textForFile(const ordered_json& json) { return dump(json, 2) + "\n"; }

std::string textForPage(const ordered_json& json) {
    std::string text;
    for (const char c : dump(json, -1)) {
        if (c == '<')
            text += "\\u003c";  // no end tag, no comment
        else
            text += c;
    }
    return text;
}

}  // namespace rushlight
