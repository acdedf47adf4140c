#pragma once
// The bytes of a glTF file and of the files it names.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight::assets {

using Bytes = std::vector<uint8_t>;

/// A .gltf (all JSON) or a .glb taken into its chunks; the views point into `bytes`.
struct GltfContainer {
    Bytes bytes;
    bool binary = false;
    std::string_view json;
    std::span<const uint8_t> bin;
    bool hasBin = false;
};

/// All of a regular file; InputError when it cannot be read or is longer than the limit.
Bytes readFile(const std::filesystem::path& path, uint64_t maxBytes);

/// Checks magic, version, lengths and chunk order of the binary container.
GltfContainer readContainer(const std::filesystem::path& path, uint64_t maxBytes);

/// The file that a relative URI names (percent-decoded already). InputError for an absolute path, a
/// scheme, a path that leaves `folder`, also through a symbolic link.
std::filesystem::path resolveUri(const std::filesystem::path& folder,
                                 const std::string& decodedUri);

/// "%20" → " "; InputError when an escape is malformed.
std::string decodePercent(const std::string& uri);

bool isDataUri(std::string_view uri);

/// The bytes of "data:<type>;base64,<text>", or of percent-encoded text without ";base64".
Bytes decodeDataUri(std::string_view uri, std::string& mimeType);

}  // namespace rushlight::assets
