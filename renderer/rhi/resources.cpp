#include "renderer/rhi/resources.h"

namespace rushlight {
namespace {

struct FormatFacts {
    const char* name;
    uint32_t bytes;
};

// Indexed by Format.
constexpr FormatFacts kFormats[] = {
    {"none", 0},      {"r8", 1},       {"rg8", 2},      {"rgba8", 4},   {"rgba8-srgb", 4},
    {"rgb10a2", 4},   {"r16f", 2},     {"rg16f", 4},    {"rgba16f", 8}, {"r11g11b10f", 4},
    {"r32f", 4},      {"rg32f", 8},    {"rgba32f", 16}, {"r16ui", 2},   {"r32ui", 4},
    {"rgba32ui", 16}, {"depth32f", 4}, {"depth16", 2},
};
static_assert(std::size(kFormats) == size_t(Format::depth16) + 1);

}  // namespace

uint32_t bytesPerTexel(Format format) { return kFormats[size_t(format)].bytes; }
const char* toText(Format format) { return kFormats[size_t(format)].name; }
bool isDepth(Format format) { return format == Format::depth32f || format == Format::depth16; }

uint64_t imageBytes(const TextureDesc& desc, uint32_t mipLevel) {
    return uint64_t(bytesPerTexel(desc.format)) * mipSize(desc.width, mipLevel) *
           mipSize(desc.height, mipLevel);
}

bool isInteger(Format format) {
    return format == Format::r16ui || format == Format::r32ui || format == Format::rgba32ui;
}

bool isTexelBufferFormat(Format format) {
    return format != Format::none && format != Format::rgba8Srgb && format != Format::rgb10a2 &&
           format != Format::r11g11b10f && !isDepth(format);
}

}  // namespace rushlight
