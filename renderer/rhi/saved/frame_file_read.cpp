#include "engine/core/quoted.h"
#include "renderer/rhi/commands/command_stream.h"
#include "renderer/rhi/commands/validate_commands.h"
#include "renderer/rhi/saved/frame_file.h"
#include "renderer/rhi/saved/frame_file_layout.h"

#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 16384;
constexpr uint32_t kMaxLayers = 2048;
constexpr uint32_t kMaxLevels = 15;
// Textures that the frame fills itself cost the file nothing. A frame has a few targets of its
// size, and shadow maps of any: what is more is damage, not a frame.
constexpr uint64_t kFreeBytesPerPixel = 256;
constexpr uint64_t kFreeBytes = uint64_t(1) << 30;

/// Reads the description. After the first fault it reads zeroes, and `fault` says what it was.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::string fault;
    bool good() const { return fault.empty(); }
    void refuse(const std::string& what) {
        if (good()) fault = what;
        rest_ = {};
    }
    size_t left() const { return rest_.size(); }

    template <class T>
    T get() {
        T value{};
        if (rest_.size() < sizeof value) {
            refuse("the description ends too early");
            return value;
        }
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_ = rest_.subspan(sizeof value);
        return value;
    }
    Hash128 hash() {
        const uint64_t low = get<uint64_t>();
        return {low, get<uint64_t>()};
    }
    std::string text() {
        const size_t size = count(1, "bytes of a text");
        std::string value(reinterpret_cast<const char*>(rest_.data()), size);
        rest_ = rest_.subspan(size);
        if (value.find('\0') != value.npos) refuse("a text holds a zero");
        return value;
    }
    /// A number of things that take at least `bytesEach`: never more than there can be.
    uint32_t count(uint64_t bytesEach, const char* what) {
        const uint32_t value = get<uint32_t>();
        if (good() && value > left() / bytesEach)
            refuse("there is no room for " + std::to_string(value) + " " + what);
        return good() ? value : 0;
    }
    template <class Enum>
    Enum choice(Enum highest, const char* what) {
        const auto value = get<std::underlying_type_t<Enum>>();
        if (value > std::underlying_type_t<Enum>(highest))
            refuse(std::string(what) + " " + std::to_string(value) + " is unknown");
        return good() ? Enum(value) : Enum{};
    }
    bool flag() {
        const uint8_t value = get<uint8_t>();
        if (value > 1) refuse("a switch is " + std::to_string(value) + ", not 0 or 1");
        return value == 1;
    }
    float number() {
        const float value = get<float>();
        if (!std::isfinite(value)) refuse("a number is not finite");
        return value;
    }
    uint32_t size(uint32_t highest, const char* what) {
        const uint32_t value = get<uint32_t>();
        if (value < 1 || value > highest)
            refuse(std::string(what) + " is " + std::to_string(value) + ", not 1 to " +
                   std::to_string(highest));
        return good() ? value : 1;
    }

private:
    std::span<const std::byte> rest_;
};

class FrameReader {
public:
    FrameReader(SavedFrame& frame, std::span<const std::byte> description)
        : frame_(frame), in_(description) {}

    void read(std::span<const std::byte> blobBytes) {
        FrameTarget& target = frame_.target;
        target.width = in_.size(kMaxSide, "the frame's width");
        target.height = in_.size(kMaxSide, "the frame's height");
        const uint32_t flags = in_.get<uint32_t>();
        if (flags > rlf::kTopRowFirst) in_.refuse("the frame's flags are unknown");
        target.topRowFirst = flags == rlf::kTopRowFirst;
        const uint32_t commands = in_.get<uint32_t>();
        const uint32_t data = in_.get<uint32_t>();
        readBlobs(blobBytes);
        for (uint32_t n = in_.count(17, "buffers"); n > 0 && in_.good(); --n) readBuffer();
        for (uint32_t n = in_.count(26, "textures"); n > 0 && in_.good(); --n) readTexture();
        for (uint32_t n = in_.count(11, "samplers"); n > 0 && in_.good(); --n) readSampler();
        for (uint32_t n = in_.count(36, "pipelines"); n > 0 && in_.good(); --n) readPipeline();
        if (in_.good() && in_.left() > 0) in_.refuse("the description is too long");
        if (freeBytes_ > kFreeBytes + kFreeBytesPerPixel * target.width * target.height)
            in_.refuse("the textures without contents take " + std::to_string(freeBytes_) +
                       " bytes, which no frame of this size does");
        const auto commandBytes = blob(commands), dataBytes = blob(data);
        if (in_.good()) frame_.commands.assign(commandBytes, dataBytes);
    }
    const std::string& fault() const { return in_.fault; }

private:
    std::span<const std::byte> blob(uint32_t number) {
        if (number > frame_.blobs.count())
            in_.refuse("blob " + std::to_string(number) + " is named, of " +
                       std::to_string(frame_.blobs.count()));
        return in_.good() && number ? frame_.blobs.bytes(number) : std::span<const std::byte>();
    }
    /// The number of a blob of that many bytes.
    uint32_t contents(uint64_t size, const std::string& label) {
        const uint32_t number = in_.get<uint32_t>();
        if (const size_t bytes = blob(number).size(); in_.good() && number && bytes != size)
            in_.refuse(quoted(label) + " takes " + std::to_string(size) + " bytes, its contents " +
                       std::to_string(bytes));
        return number;
    }

    void readBlobs(std::span<const std::byte> bytes) {
        const uint32_t count = in_.count(24, "blobs");
        for (uint32_t i = 1; i <= count && in_.good(); ++i) {
            const Hash128 promised = in_.hash();
            const uint64_t size = in_.get<uint64_t>();
            if (size > bytes.size()) {
                in_.refuse("blob " + std::to_string(i) + " goes beyond the end of the file");
                return;
            }
            const auto part = bytes.first(size);
            bytes = bytes.subspan(size);
            if (const Hash128 hash = hash128(part); hash != promised)
                in_.refuse("blob " + std::to_string(i) + " has the hash " + toText(hash) +
                           ", not " + toText(promised) + ": the file is damaged");
            frame_.blobs.addView(promised, part);
        }
        if (in_.good() && !bytes.empty()) in_.refuse("there are bytes after the last blob");
    }

    void readBuffer() {
        SavedBuffer buffer;
        buffer.label = in_.text();
        buffer.size = in_.get<uint64_t>();
        buffer.usage = in_.choice(BufferUsage::texel, "a buffer's usage");
        buffer.contents = contents(buffer.size, buffer.label);
        if (in_.good() && !buffer.contents) in_.refuse(quoted(buffer.label) + " has no contents");
        frame_.buffers.push_back(std::move(buffer));
    }

    void readTexture() {
        SavedTexture texture;
        texture.label = in_.text();
        TextureDesc& d = texture.desc;
        d.kind = in_.choice(TextureKind::cubeArray, "a texture's kind");
        d.format = in_.choice(Format::depth16, "a texture's format");
        if (d.format == Format::none) in_.refuse(quoted(texture.label) + " has no format");
        d.width = in_.size(kMaxSide, "a texture's width");
        d.height = in_.size(kMaxSide, "a texture's height");
        d.layers = in_.size(kMaxLayers, "a texture's number of layers");
        d.mipLevels = in_.size(kMaxLevels, "a texture's number of mip levels");
        if (in_.left() / 4 < size_t(d.layers) * d.mipLevels)
            in_.refuse("the description ends too early");
        for (uint32_t level = 0; level < d.mipLevels && in_.good(); ++level) {
            const uint64_t size = imageBytes(d, level);
            for (uint32_t layer = 0; layer < d.layers && in_.good(); ++layer) {
                texture.contents.push_back(contents(size, texture.label));
                if (!texture.contents.back()) freeBytes_ += size;
            }
        }
        frame_.textures.push_back(std::move(texture));
    }

    void readSampler() {
        SamplerDesc s;
        s.wrapU = in_.choice(TextureWrap::mirroredRepeat, "a sampler's wrap");
        s.wrapV = in_.choice(TextureWrap::mirroredRepeat, "a sampler's wrap");
        for (TextureFilter* filter : {&s.magnify, &s.minify, &s.mipmap})
            *filter = in_.choice(TextureFilter::linear, "a sampler's filter");
        s.useMipmaps = in_.flag();
        s.compareGreaterEqual = in_.flag();
        s.maxAnisotropy = in_.number();
        frame_.samplers.push_back(s);
    }

    void readPipeline() {
        SavedPipeline pipeline;
        pipeline.label = in_.text();
        pipeline.vertexShader = in_.text();
        pipeline.fragmentShader = in_.text();
        pipeline.vertexSource = in_.get<uint32_t>();
        pipeline.fragmentSource = in_.get<uint32_t>();
        blob(pipeline.vertexSource), blob(pipeline.fragmentSource);
        PipelineDesc& d = pipeline.desc;
        d.layout = in_.choice(VertexLayout::overlay, "a pipeline's vertex layout");
        d.movingInstances = in_.flag();
        d.cull = in_.choice(CullMode::front, "a pipeline's culling");
        d.depthClamp = in_.flag();
        d.depthTest = in_.choice(CompareOp::less, "a pipeline's depth test");
        d.depthWrite = in_.flag();
        d.blend = in_.choice(BlendMode::absorbing, "a pipeline's blending");
        d.lines = in_.flag();
        d.depthBias = in_.number();
        d.depthBiasSlope = in_.number();
        frame_.pipelines.push_back(std::move(pipeline));
    }

    SavedFrame& frame_;
    Reader in_;
    uint64_t freeBytes_ = 0;
};

template <class T>
T at(std::span<const std::byte> bytes, size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// The size of the description, of a file whose header is right.
Result<uint64_t> checkHeader(std::span<const std::byte> file, const std::string& name) {
    const size_t known = std::min(file.size(), rlf::kMagic.size());
    if (known == 0 || std::memcmp(file.data(), rlf::kMagic.data(), known) != 0)
        return fail(name, "This is no RLF file: it does not begin as one.");
    const auto truncated = [&](uint64_t size) {
        return fail(name, "The file is truncated at byte " + std::to_string(file.size()) + " of " +
                              (size ? std::to_string(size) : "its header") + ".");
    };
    if (file.size() < rlf::kHeaderBytes) return truncated(0);
    if (const uint32_t version = at<uint32_t>(file, 8); version != rlf::kVersion)
        return fail(name, "The file's version is " + std::to_string(version) + "; version " +
                              std::to_string(rlf::kVersion) +
                              " is read. Save the frame again with this program.");
    const uint64_t size = at<uint64_t>(file, 16), description = at<uint64_t>(file, 24);
    if (file.size() < size) return truncated(size);
    if (file.size() != size || at<uint32_t>(file, 12) != 0)
        return fail(name, "The header is damaged: the file has " + std::to_string(file.size()) +
                              " bytes, not " + std::to_string(size) + ".");
    if (description > size - rlf::kHeaderBytes)
        return fail(name, "The header is damaged: its description does not fit into the file.");
    const Hash128 hash = hash128(file.subspan(rlf::kHeaderBytes, description));
    if (hash != Hash128{at<uint64_t>(file, 32), at<uint64_t>(file, 40)})
        return fail(name, "The description's hash is wrong: the file is damaged.");
    return description;
}

}  // namespace

Result<SavedFrame> decodeFrame(std::vector<std::byte> file, const std::string& name) {
    const auto description = checkHeader(file, name);
    if (!description) return tl::unexpected(description.error());
    SavedFrame frame;
    frame.blobs.keep(std::move(file));
    const auto bytes = frame.blobs.kept().subspan(rlf::kHeaderBytes);
    FrameReader reader(frame, bytes.first(*description));
    reader.read(bytes.subspan(*description));
    if (!reader.fault().empty()) return fail(name, "The file is wrong: " + reader.fault() + ".");
    if (auto whole = checkCommandStream(frame.commands.commandBytes(), name); !whole)
        return tl::unexpected(whole.error());
    CommandValidator validator;
    if (const auto faults = validator.validate(frame.commands, frame, ValidationRules::memory);
        !faults.empty())
        return fail(name, faults[0].text());
    return frame;
}

}  // namespace rushlight
