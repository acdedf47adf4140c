#include "renderer/rhi/validate.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

tl::unexpected<Error> refuse(std::string_view label, std::string message) {
    return fail(std::string(label), std::move(message));
}

std::string sizeText(const TextureDesc& desc) {
    return std::to_string(desc.width) + "x" + std::to_string(desc.height);
}

}  // namespace

Result<void> validate(const BufferDesc& desc, const DeviceLimits& limits) {
    if (desc.size == 0) return refuse(desc.label, "A buffer of 0 bytes cannot be made.");
    if (desc.size > limits.bufferSize)
        return refuse(desc.label, "A buffer of " + std::to_string(desc.size) +
                                      " bytes is over the limit of " +
                                      std::to_string(limits.bufferSize) + " bytes.");
    return {};
}

Result<void> validate(const TextureDesc& desc, const DeviceLimits& limits) {
    if (desc.format == Format::none) return refuse(desc.label, "A texture needs a format.");
    if (desc.width == 0 || desc.height == 0)
        return refuse(desc.label, "A texture of " + sizeText(desc) +
                                      " texels cannot be made; both sides must be at least 1.");
    const bool cubes = desc.kind == TextureKind::cubeArray;
    const bool cube = desc.kind == TextureKind::cube || cubes;
    const uint32_t limit = cube ? limits.cubeSize : limits.textureSize;
    if (desc.width > limit || desc.height > limit)
        return refuse(desc.label, "A texture of " + sizeText(desc) +
                                      " texels is over the limit of " + std::to_string(limit) +
                                      " texels a side.");
    const bool whole = cubes ? desc.layers > 0 && desc.layers % 6 == 0 : desc.layers == 6;
    if (cube && (!whole || desc.width != desc.height))
        return refuse(desc.label,
                      std::string(cubes ? "An array of cube textures needs 6 square layers for each"
                                        : "A cube texture needs 6 square layers") +
                          ", not " + std::to_string(desc.layers) + " of " + sizeText(desc) + ".");
    if (desc.kind == TextureKind::texture2d && desc.layers != 1)
        return refuse(desc.label, "A 2D texture has 1 layer, not " + std::to_string(desc.layers) +
                                      "; make it an array.");
    if (desc.layers == 0 || desc.layers > limits.textureLayers)
        return refuse(desc.label, "A texture of " + std::to_string(desc.layers) +
                                      " layers is outside of 1 to " +
                                      std::to_string(limits.textureLayers) + ".");
    const uint32_t full = uint32_t(std::bit_width(std::max(desc.width, desc.height)));
    if (desc.mipLevels == 0 || desc.mipLevels > full)
        return refuse(desc.label, "A texture of " + sizeText(desc) + " texels has 1 to " +
                                      std::to_string(full) + " mip levels, not " +
                                      std::to_string(desc.mipLevels) + ".");
    return {};
}

Result<void> validate(const PipelineDesc& desc) {
    if (desc.vertexShader.empty() || desc.fragmentShader.empty())
        return refuse(desc.label, "A pipeline needs a vertex and a fragment shader.");
    if (desc.vertexSource.empty() != desc.fragmentSource.empty())
        return refuse(desc.label, "A pipeline has the sources of both its shaders, or of none.");
    for (std::string_view define : desc.defines)
        if (define.empty() || define.find('\n') != define.npos)
            return refuse(desc.label, "A shader define must be one line of NAME or NAME VALUE.");
    if (desc.movingInstances &&
        (desc.layout == VertexLayout::none || desc.layout == VertexLayout::overlay))
        return refuse(desc.label, "A layout without instances cannot have moving ones.");
    return {};
}

uint64_t byteSize(Format format, const TextureRegion& region) {
    return uint64_t(bytesPerTexel(format)) * region.width * region.height * region.layerCount;
}

}  // namespace rushlight
