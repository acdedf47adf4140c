#pragma once
// A frame taken apart: every pass with what it wrote, what it cost and what it read, in the order
// in which one explains a frame, as a page that needs nothing but a browser.

#include "renderer/renderer.h"

#include <functional>
#include <string>
#include <vector>

namespace rushlight {

/// What a picture's values mean; the page reads them out under the pointer.
enum class Readout : uint8_t {
    color,      ///< 8 bit sRGB
    unit,       ///< grey, 0 to 1
    direction,  ///< a unit vector v as v / 2 + 1/2
    velocity,   ///< red right, green up: half the root of the share of the screen that it moved,
                ///< about 1/2
    distance,   ///< grey, metres by the logarithm: white at `low`, black at `high`; shown in false
                ///< colour
    count,      ///< false colour from 0 to `high`
};

struct BreakdownPicture {
    std::string section;  ///< BreakdownSection::id
    std::string name;     ///< unique; the file is pictures/NAME.png
    std::string title, note;
    int pass = -1;  ///< of FrameReport::passes, whose image `image` it is; -1: drawn for the page
    int image = -1;
    Readout readout = Readout::color;
    float low = 0, high = 1;
    bool exact = false;  ///< values to be read: kept without loss in the page too
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba8;  ///< sRGB, opaque, rows from the top
};

struct BreakdownSection {
    const char* id;
    const char* title;
    const char* text;
};

struct Breakdown {
    std::string title;        ///< such as the scene's file; any text
    std::string host = "{}";  ///< a JSON object: what the host knows beyond the report, in the
                              ///< schema of --stats
    FrameReport report;       ///< without texels
    std::string commands;     ///< numbered, with labels
    std::vector<BreakdownPicture> pictures;
};

struct BreakdownOptions {
    uint32_t width = 1280, height = 720;
    std::function<void(uint32_t done, uint32_t count)> progress = {};  ///< frames drawn
};

/// In the order of the page.
std::span<const BreakdownSection> breakdownSections();
/// Of a pass, by its name.
const char* breakdownSectionOf(std::string_view pass);

/// Draws the frame several times: to warm up, once to be measured and read back pass by pass, and
/// once for every view into it. Shadows are drawn, not kept from before. Motion is that of
/// `previousTransforms`: what a world moved by itself is at rest. GPU times are those of the same
/// frame drawn just before. `input`'s DebugView is not used.
Result<Breakdown> takeBreakdown(Renderer& renderer, const FrameInput& input,
                                const BreakdownOptions& options);

/// A breakdown that was written before, to be shown beside another: its frame.json, and the folder
/// with its pictures.
struct WrittenBreakdown {
    std::string folder;
    std::string json;  ///< checked: it has what the page reads, and names no file outside of the
                       ///< folder
};
Result<WrittenBreakdown> loadBreakdown(const std::string& frameJson);

/// Writes index.html, which shows all without any other file, frame.json, commands.txt and
/// pictures/. The folder is made; an older breakdown in it is replaced, other files stay. An Error
/// where something else has one of these names, and where it cannot be written: then the folder is
/// as it was before.
Result<void> writeBreakdown(const std::string& folder, const Breakdown& breakdown,
                            const WrittenBreakdown* other = nullptr);

}  // namespace rushlight
