#include "engine/assets/image.h"

#include "engine/assets/gltf/gltf_file.h"
#include "engine/assets/input_error.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace rushlight::assets {
namespace {

using OIIO::ImageInput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

bool beginsWith(std::span<const uint8_t> bytes, std::string_view magic, size_t at = 0) {
    return bytes.size() >= at + magic.size() &&
           std::memcmp(bytes.data() + at, magic.data(), magic.size()) == 0;
}

/// The OpenImageIO reader for the bytes; the format is told by the content, never by a name.
const char* formatOf(std::span<const uint8_t> bytes) {
    using namespace std::string_view_literals;
    if (beginsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return "png";
    if (beginsWith(bytes, "\xff\xd8\xff"sv)) return "jpeg";
    if (beginsWith(bytes, "RIFF"sv) && beginsWith(bytes, "WEBP"sv, 8)) return "webp";
    if (beginsWith(bytes, "#?"sv)) return "hdr";
    if (beginsWith(bytes, "\x76\x2f\x31\x01"sv)) return "openexr";
    return nullptr;
}

/// libjpeg fills up what a truncated file lacks, so the end-of-image marker is looked for: it must
/// follow the first start-of-scan of the image itself (an embedded preview lies inside an
/// application segment, which is skipped).
bool isWholeJpeg(std::span<const uint8_t> bytes) {
    size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == 0xff && bytes[at + 1] != 0xda)
        at += bytes[at + 1] == 0xff ? 1 : 2 + (size_t(bytes[at + 2]) << 8 | bytes[at + 3]);
    for (size_t i = bytes.size(); i >= at + 4; --i)
        if (bytes[i - 2] == 0xff && bytes[i - 1] == 0xd9) return true;
    return false;
}

struct OpenImage {
    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;
    std::unique_ptr<ImageInput> input;
};

/// OpenImageIO's own threads are off: the caller brings its job system.
void configureOnce() {
    static const bool done = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
    (void)done;
}

OpenImage open(std::span<const uint8_t> bytes) {
    configureOnce();
    const char* format = formatOf(bytes);
    if (!format) refuse("it is neither PNG, JPEG, WebP, Radiance HDR nor OpenEXR.");
    OpenImage image;
    image.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(
        const_cast<uint8_t*>(bytes.data()), bytes.size());
    image.input = ImageInput::create(format);
    if (!image.input) refuse("OpenImageIO has no reader for " + std::string(format) + ".");
    if (!image.input->supports("ioproxy"))
        refuse("OpenImageIO cannot read " + std::string(format) + " from memory.");
    ImageSpec config, spec;
    config.attribute("oiio:UnassociatedAlpha", 1);
    void* proxy = image.memory.get();
    config.attribute("oiio:ioproxy", TypeDesc::PTR, &proxy);
    if (!image.input->open(std::string("memory.") + format, spec, config))
        refuse("it cannot be decoded: " + image.input->geterror());
    return image;
}

void checkSize(const ImageSpec& spec, const ImageLimits& limits) {
    const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1) refuse("its size is " + size + ".");
    if (uint32_t(spec.width) > limits.maxSide || uint32_t(spec.height) > limits.maxSide)
        refuse("it has " + size + " pixels; the limit is " + std::to_string(limits.maxSide) +
               " a side.");
    if (uint64_t(spec.width) * uint64_t(spec.height) > limits.maxPixels)
        refuse("it has " + size + " pixels; the limit is " + std::to_string(limits.maxPixels) +
               " in all.");
}

template <class T>
std::vector<T> readPixels(ImageInput& input, int channels, TypeDesc type) {
    const ImageSpec& spec = input.spec();
    std::vector<T> raw(size_t(spec.width) * size_t(spec.height) * size_t(channels));
    if (!input.read_image(0, 0, 0, channels, type, raw.data()))
        refuse("it cannot be decoded: " + input.geterror());
    if (input.has_error()) refuse("it is damaged: " + input.geterror());
    return raw;
}

/// Grey, grey-alpha and RGB widened to RGBA.
std::vector<uint8_t> toRgba(const std::vector<uint8_t>& raw, int channels) {
    if (channels == 4) return raw;
    const size_t pixels = raw.size() / size_t(channels);
    std::vector<uint8_t> out(pixels * 4);
    const uint8_t* in = raw.data();
    for (size_t i = 0; i < pixels; ++i, in += channels) {
        uint8_t* to = &out[i * 4];
        to[0] = in[0];
        to[1] = channels >= 3 ? in[1] : in[0];
        to[2] = channels >= 3 ? in[2] : in[0];
        to[3] = channels == 2 ? in[1] : 255;
    }
    return out;
}

Image decode(const std::string& name, std::span<const uint8_t> bytes, const ImageLimits& limits) {
    require(!bytes.empty(), "it is empty.");
    if (beginsWith(bytes, "\xff\xd8\xff") && !isWholeJpeg(bytes))
        refuse("the JPEG is cut short: it has no end-of-image marker.");
    OpenImage open_ = open(bytes);
    const ImageSpec& spec = open_.input->spec();
    checkSize(spec, limits);
    const int channels = std::min(spec.nchannels, 4);
    Image image;
    image.name = name;
    image.width = uint32_t(spec.width);
    image.height = uint32_t(spec.height);
    std::vector<uint8_t> raw = readPixels<uint8_t>(*open_.input, channels, TypeDesc::UINT8);
    image.pixels = channels == 4 ? std::move(raw) : toRgba(raw, channels);
    return image;
}

HdrImage decodeHdr(std::span<const uint8_t> bytes, const ImageLimits& limits) {
    require(!bytes.empty(), "it is empty.");
    OpenImage open_ = open(bytes);
    const ImageSpec& spec = open_.input->spec();
    checkSize(spec, limits);
    const int channels = std::min(spec.nchannels, 3);
    const std::vector<float> raw = readPixels<float>(*open_.input, channels, TypeDesc::FLOAT);
    HdrImage image;
    image.width = uint32_t(spec.width);
    image.height = uint32_t(spec.height);
    image.pixels.resize(size_t(spec.width) * size_t(spec.height));
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = raw[i * size_t(channels) + size_t(std::min(c, channels - 1))];
            if (!std::isfinite(value))
                refuse("pixel " + std::to_string(i % image.width) + ", " +
                       std::to_string(i / image.width) + " is not finite.");
            image.pixels[i][c] = std::max(value, 0.0f);
        }
    return image;
}

}  // namespace

Result<Image> decodeImage(const std::string& name, std::span<const uint8_t> bytes,
                          const ImageLimits& limits) {
    try {
        return decode(name, bytes, limits);
    } catch (const InputError& error) {
        return fail("image '" + name + "'", error.message);
    } catch (const std::exception& error) {
        return fail("image '" + name + "'", std::string("it cannot be decoded: ") + error.what());
    }
}

Result<uvec2> readImageSize(const std::string& name, std::span<const uint8_t> bytes) {
    try {
        const OpenImage image = open(bytes);
        return uvec2(uint32_t(image.input->spec().width), uint32_t(image.input->spec().height));
    } catch (const InputError& error) {
        return fail("image '" + name + "'", error.message);
    } catch (const std::exception& error) {
        return fail("image '" + name + "'", std::string("it cannot be decoded: ") + error.what());
    }
}

Image makeMissingImage(const std::string& name) {
    Image image;
    image.name = name;
    image.width = image.height = 8;
    for (uint32_t i = 0; i < 64; ++i) {
        const uint8_t lit = ((i / 8 + i) & 1) ? 255 : 0;
        image.pixels.insert(image.pixels.end(), {lit, 0, lit, 255});
    }
    return image;
}

Result<HdrImage> loadHdr(const std::filesystem::path& path, const ImageLimits& limits) {
    try {
        return decodeHdr(readFile(path, 1ull << 31), limits);
    } catch (const InputError& error) {
        return fail(path.string(), error.message);
    } catch (const std::exception& error) {
        return fail(path.string(), std::string("it cannot be decoded: ") + error.what());
    }
}

}  // namespace rushlight::assets
