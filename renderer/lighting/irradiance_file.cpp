#include "engine/core/hash.h"
#include "renderer/lighting/irradiance_volume.h"

#include <array>
#include <cstring>
#include <type_traits>

namespace rushlight {
namespace {

constexpr std::array<char, 8> kMagic = {'R', 'L', 'P', 'R', 'O', 'B', 'E', 0};
constexpr uint32_t kVersion = 2;

/// Followed by IrradianceVolume::records and ::distances.
struct FileHeader {
    std::array<char, 8> magic = kMagic;
    uint32_t version = kVersion;
    glm::uvec3 counts{0};
    vec3 origin{0};
    vec3 spacing{0};
    uint64_t lightHash = 0;
    uint64_t payloadHash = 0;
    uint64_t headerHash = 0;  ///< of all before
};
static_assert(sizeof(FileHeader) == 72 && std::is_trivially_copyable_v<FileHeader>);

uint64_t hashOfHeader(const FileHeader& header) {
    return hashBytes(&header, offsetof(FileHeader, headerHash));
}

}  // namespace

std::vector<std::byte> encodeIrradianceVolume(const IrradianceVolume& volume) {
    const size_t recordBytes = volume.records.size() * sizeof(uvec4);
    const size_t distanceBytes = volume.distances.size() * sizeof(uint32_t);
    FileHeader header;
    std::vector<std::byte> bytes(sizeof header + recordBytes + distanceBytes);
    std::byte* payload = bytes.data() + sizeof header;
    std::memcpy(payload, volume.records.data(), recordBytes);
    std::memcpy(payload + recordBytes, volume.distances.data(), distanceBytes);
    header.counts = volume.grid.counts;
    header.origin = volume.grid.origin;
    header.spacing = volume.grid.spacing;
    header.lightHash = volume.lightHash;
    header.payloadHash = hashBytes(payload, recordBytes + distanceBytes);
    header.headerHash = hashOfHeader(header);
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

Result<IrradianceVolume> decodeIrradianceVolume(std::span<const std::byte> bytes,
                                                const std::string& path) {
    FileHeader header;
    if (bytes.size() < sizeof header)
        return fail(path, "This is no file of light probes: it has " +
                              std::to_string(bytes.size()) + " bytes, fewer than its header.");
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != kMagic)
        return fail(path, "This is no file of light probes; make one with rushlight bake.");
    if (header.version != kVersion)
        return fail(path, "It is of version " + std::to_string(header.version) +
                              " of the format, this program reads version " +
                              std::to_string(kVersion) + "; bake it again.");
    if (header.headerHash != hashOfHeader(header))
        return fail(path, "Its header is damaged; bake it again.");
    IrradianceVolume volume;
    volume.grid = {header.origin, header.spacing, header.counts};
    const double count = double(header.counts.x) * header.counts.y * header.counts.z;
    if (count >= 1 && count <= kMaxProbes) volume = makeIrradianceVolume(volume.grid);
    volume.lightHash = header.lightHash;
    const size_t recordBytes = volume.records.size() * sizeof(uvec4);
    const size_t distanceBytes = volume.distances.size() * sizeof(uint32_t);
    const auto payload = bytes.subspan(sizeof header);
    if (payload.size() != recordBytes + distanceBytes)
        return fail(path, "It has " + std::to_string(bytes.size()) +
                              " bytes where its header says " +
                              std::to_string(sizeof header + recordBytes + distanceBytes) +
                              "; it was cut short or added to. Bake it again.");
    if (hashBytes(payload.data(), payload.size()) != header.payloadHash)
        return fail(path, "Its contents do not match their checksum; bake it again.");
    if (recordBytes) std::memcpy(volume.records.data(), payload.data(), recordBytes);
    if (distanceBytes)
        std::memcpy(volume.distances.data(), payload.data() + recordBytes, distanceBytes);
    if (auto ok = checkIrradianceVolume(volume, path); !ok) return tl::unexpected(ok.error());
    return volume;
}

}  // namespace rushlight
