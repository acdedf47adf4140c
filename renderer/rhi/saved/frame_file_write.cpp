#include "renderer/rhi/saved/frame_file.h"
#include "renderer/rhi/saved/frame_file_layout.h"

#include <bit>

namespace rushlight {
namespace {

static_assert(std::endian::native == std::endian::little, "RLF files are written as memory is");

class Writer {
public:
    std::vector<std::byte> bytes;

    template <class T>
    void put(T value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        append(std::as_bytes(std::span(&value, 1)));
    }
    template <class T, class... More>
    void put(T first, More... more) {
        put(first);
        (put(more), ...);
    }
    void hash(const Hash128& value) { put(value.low, value.high); }
    void text(std::string_view value) {
        put(uint32_t(value.size()));
        append(std::as_bytes(std::span(value)));
    }
    void append(std::span<const std::byte> more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
    }
};

void writeResources(Writer& out, const SavedFrame& frame) {
    out.put(uint32_t(frame.buffers.size()));
    for (const SavedBuffer& buffer : frame.buffers) {
        out.text(buffer.label);
        out.put(buffer.size, buffer.usage, buffer.contents);
    }
    out.put(uint32_t(frame.textures.size()));
    for (const SavedTexture& texture : frame.textures) {
        const TextureDesc& d = texture.desc;
        out.text(texture.label);
        out.put(d.kind, d.format, d.width, d.height, d.layers, d.mipLevels);
        for (const uint32_t number : texture.contents) out.put(number);
    }
    out.put(uint32_t(frame.samplers.size()));
    for (const SamplerDesc& s : frame.samplers)
        out.put(s.wrapU, s.wrapV, s.magnify, s.minify, s.mipmap, uint8_t(s.useMipmaps),
                uint8_t(s.compareGreaterEqual), s.maxAnisotropy);
    out.put(uint32_t(frame.pipelines.size()));
    for (const SavedPipeline& pipeline : frame.pipelines) {
        const PipelineDesc& d = pipeline.desc;
        out.text(pipeline.label);
        out.text(pipeline.vertexShader);
        out.text(pipeline.fragmentShader);
        out.put(pipeline.vertexSource, pipeline.fragmentSource, d.layout,
                uint8_t(d.movingInstances), d.cull, uint8_t(d.depthClamp), d.depthTest,
                uint8_t(d.depthWrite), d.blend, uint8_t(d.lines), d.depthBias, d.depthBiasSlope);
    }
}

}  // namespace

std::vector<std::byte> encodeFrame(const SavedFrame& frame) {
    std::vector<std::pair<Hash128, std::span<const std::byte>>> blobs;
    for (uint32_t i = 1; i <= frame.blobs.count(); ++i)
        blobs.emplace_back(frame.blobs.hash(i), frame.blobs.bytes(i));
    const auto add = [&](std::span<const std::byte> bytes) {
        if (bytes.empty()) return 0u;
        const Hash128 hash = hash128(bytes);
        if (const uint32_t known = frame.blobs.find(hash))
            return known;  // of a frame that was read
        blobs.emplace_back(hash, bytes);
        return uint32_t(blobs.size());
    };
    Writer description;
    description.put(frame.target.width, frame.target.height,
                    frame.target.topRowFirst ? rlf::kTopRowFirst : 0u);
    const uint32_t commands = add(frame.commands.commandBytes());
    const uint32_t data = add(frame.commands.data());
    description.put(commands, data, uint32_t(blobs.size()));
    uint64_t blobBytes = 0;
    for (const auto& [hash, bytes] : blobs) {
        description.hash(hash);
        description.put(uint64_t(bytes.size()));
        blobBytes += bytes.size();
    }
    writeResources(description, frame);

    Writer file;
    const uint64_t size = rlf::kHeaderBytes + description.bytes.size() + blobBytes;
    file.bytes.reserve(size);
    file.append(std::as_bytes(std::span(rlf::kMagic)));
    file.put(rlf::kVersion, uint32_t(0), size, uint64_t(description.bytes.size()));
    file.hash(hash128(description.bytes));
    file.append(description.bytes);
    for (const auto& [hash, bytes] : blobs) file.append(bytes);
    return std::move(file.bytes);
}

}  // namespace rushlight
