#include "renderer/capture/image_files.h"

#include "engine/core/check.h"
#include "renderer/capture/write_file.h"
#include "renderer/rhi/half_floats.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace rushlight {
namespace {

constexpr int kMaxSide = 16384;
constexpr float kLargestHalf = 65504;

/// A picture as OpenImageIO takes it: what `spec` describes, at `pixels`, a pixel every `stride`
/// bytes.
struct Encoding {
    const char* fileName;  // tells OpenImageIO the format
    OIIO::ImageSpec spec;
    const void* pixels = nullptr;
    OIIO::TypeDesc pixelType;
    OIIO::stride_t stride = 0;
    std::vector<uint8_t> storage;  // when the pixels had to be changed
    std::vector<uint16_t> halves;
};

template <class Value>
bool isOpaque(std::span<const Value> rgba, Value opaque) {
    for (size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != opaque) return false;
    return true;
}
bool isOpaque(const PictureView& view) {
    return view.rgba8.empty() ? isOpaque(view.rgba32f, 1.0f) : isOpaque(view.rgba8, uint8_t(255));
}

std::vector<uint8_t> overBlack(std::span<const uint8_t> rgba8) {
    std::vector<uint8_t> result(rgba8.begin(), rgba8.end());
    for (size_t i = 0; i < result.size(); ++i)
        result[i] = uint8_t((result[i] * rgba8[i | 3] + 127) / 255);
    return result;
}

Encoding encoding8(const char* fileName, const PictureView& view, int channels) {
    Encoding e{
        .fileName = fileName,
        .spec = OIIO::ImageSpec(int(view.width), int(view.height), channels, OIIO::TypeDesc::UINT8),
        .pixels = view.rgba8.data(),
        .pixelType = OIIO::TypeDesc::UINT8,
        .stride = 4,
        .storage = {},
        .halves = {}};
    e.spec.attribute("oiio:ColorSpace", "sRGB");
    return e;
}

Encoding pngEncoding(const PictureView& view, EncodeEffort effort) {
    Encoding e = encoding8("picture.png", view, isOpaque(view) ? 3 : 4);
    e.spec.attribute("oiio:UnassociatedAlpha", 1);
    // Level 1 with the "sub" filter: the fastest that still compresses; 8 is no filter.
    constexpr int kLevels[] = {0, 1, 6};
    e.spec.attribute("png:compressionLevel", kLevels[size_t(effort)]);
    if (effort != EncodeEffort::small)
        e.spec.attribute("png:filter", effort == EncodeEffort::none ? 8 : 16);
    return e;
}

Encoding jpegEncoding(const PictureView& view, EncodeEffort effort) {
    Encoding e = encoding8("picture.jpg", view, 3);
    const bool fast = effort != EncodeEffort::small;
    e.spec.attribute("Compression", fast ? "jpeg:95" : "jpeg:88");
    e.spec.attribute("jpeg:subsampling", fast ? "4:4:4" : "4:2:0");
    if (!isOpaque(view)) {
        e.storage = overBlack(view.rgba8);
        e.pixels = e.storage.data();
    }
    return e;
}

Encoding exrEncoding(const PictureView& view, EncodeEffort effort) {
    std::vector<uint16_t> halves(view.rgba32f.size());
    const bool exact = exactHalves(view.rgba32f, halves);  // as they are where a GPU drew them
    const bool fits = exact || std::ranges::all_of(view.rgba32f, [](float v) {
                          return !std::isfinite(v) || std::abs(v) <= kLargestHalf;
                      });
    Encoding e{.fileName = "picture.exr",
               .spec = OIIO::ImageSpec(int(view.width), int(view.height), isOpaque(view) ? 3 : 4,
                                       fits ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT),
               .pixels = view.rgba32f.data(),
               .pixelType = OIIO::TypeDesc::FLOAT,
               .stride = 16,
               .storage = {},
               .halves = std::move(halves)};
    if (exact) {
        e.pixels = e.halves.data();
        e.pixelType = OIIO::TypeDesc::HALF;
        e.stride = 8;
    }
    // Level 1 takes half the time of OpenEXR's own, 4, for files half as large again.
    constexpr const char* kCompressions[] = {"none", "zip:1", "zip"};
    e.spec.attribute("compression", kCompressions[size_t(effort)]);
    // OpenImageIO writes today's date when it is given none.
    e.spec.attribute("DateTime", "1970:01:01 00:00:00");
    return e;
}

/// Libraries end messages with new lines and full stops; ours are one line.
std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text;
}

Result<std::vector<std::byte>> run(const std::string& name, Encoding e,
                                   std::string_view description) {
    if (!description.empty()) e.spec.attribute("ImageDescription", std::string(description));
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(e.fileName);
    if (!output) return fail(name, "OpenImageIO was built without this format.");
    const bool written = output->set_ioproxy(&memory) && output->open(e.fileName, e.spec) &&
                         output->write_image(e.pixelType, e.pixels, e.stride) && output->close();
    if (!written)
        return fail(name,
                    "The picture could not be encoded (" + oneLine(output->geterror()) + ").");
    const auto all = std::as_bytes(std::span(bytes));
    return std::vector<std::byte>(all.begin(), all.end());
}

void premultiply(std::vector<float>& rgba) {
    for (size_t i = 0; i < rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) rgba[i + c] *= rgba[i + 3];
}

/// Grey, grey with alpha, RGB or RGBA, into RGBA.
std::vector<float> toRgba(const std::vector<float>& from, size_t channels) {
    const size_t count = from.size() / channels;
    const bool grey = channels < 3;
    const bool alpha = channels == 2 || channels >= 4;
    std::vector<float> rgba(count * 4, 1.0f);
    for (size_t i = 0; i < count; ++i) {
        const float* pixel = from.data() + i * channels;
        for (size_t c = 0; c < 3; ++c) rgba[i * 4 + c] = pixel[grey ? 0 : c];
        if (alpha) rgba[i * 4 + 3] = pixel[grey ? 1 : 3];
    }
    return rgba;
}

}  // namespace

Result<ImageFormat> imageFormatOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    if (extension == ".png") return ImageFormat::png;
    if (extension == ".jpg" || extension == ".jpeg") return ImageFormat::jpeg;
    if (extension == ".exr") return ImageFormat::exr;
    return fail(path,
                "The extension \"" + extension +
                    "\" is none that pictures are written as; use "
                    ".png, .jpg or .exr.",
                ErrorKind::wrongUse);
}

Result<std::vector<std::byte>> encodeImage(const std::string& name, ImageFormat format,
                                           const PictureView& view, EncodeEffort effort) {
    const size_t values = size_t(view.width) * view.height * 4;
    RL_CHECK(values > 0 && (view.rgba8.size() == values) != (view.rgba32f.size() == values),
             "a picture has as many values as its size says, of one kind");
    const bool linear = !view.rgba32f.empty();
    if (linear != (format == ImageFormat::exr))
        return fail(name,
                    linear ? "A linear picture with high range is written as .exr."
                           : "An 8 bit sRGB picture is written as .png or .jpg.",
                    ErrorKind::wrongUse);
    switch (format) {
        case ImageFormat::png: return run(name, pngEncoding(view, effort), view.description);
        case ImageFormat::jpeg: return run(name, jpegEncoding(view, effort), view.description);
        case ImageFormat::exr: return run(name, exrEncoding(view, effort), view.description);
    }
    RL_CHECK(false, "an image format is one of the enumeration");
}

Result<void> saveImage(const std::string& path, const PictureView& view, EncodeEffort effort) {
    const auto format = imageFormatOf(path);
    if (!format) return tl::unexpected(format.error());
    const auto bytes = encodeImage(path, *format, view, effort);
    if (!bytes) return tl::unexpected(bytes.error());
    return writeFile(path, *bytes);
}

Result<Picture> loadPicture(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // its own premultiplication rounds
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input)
        return fail(path, "The picture could not be read (" + oneLine(OIIO::geterror()) + ").");
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxSide || spec.height > kMaxSide ||
        spec.nchannels < 1 || spec.depth > 1)
        return fail(path, "The picture has " + std::to_string(spec.width) + "x" +
                              std::to_string(spec.height) + " pixels and " +
                              std::to_string(spec.nchannels) +
                              " channels; 1 to 16,384 pixels a side and one layer are read.");
    const int channels = std::min(spec.nchannels, 4);
    std::vector<float> values(size_t(spec.width) * size_t(spec.height) * size_t(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
        return fail(path, "The picture is damaged (" + oneLine(input->geterror()) + ").");

    Picture picture;
    picture.width = uint32_t(spec.width);
    picture.height = uint32_t(spec.height);
    picture.linear = spec.format.is_floating_point();
    picture.description = std::string(spec.get_string_attribute("ImageDescription"));
    picture.rgba = toRgba(values, size_t(channels));
    // Float formats are premultiplied by convention; OpenEXR has no other.
    if (!picture.linear) premultiply(picture.rgba);
    return picture;
}

}  // namespace rushlight
