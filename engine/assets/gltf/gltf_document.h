#pragma once
// A glTF file after its structure has been checked: tinygltf's structs, and the bytes they refer
// to.

#include "engine/assets/gltf.h"
#include "engine/assets/gltf/gltf_file.h"
#include "engine/assets/gltf/tinygltf_config.h"

#include <span>
#include <vector>

namespace rushlight::assets {

/// The encoded bytes of an image, or why they could not be had.
struct ImageSource {
    std::string name;  ///< the URI or the name in the file
    std::span<const uint8_t> bytes;
    std::string problem;
};

/// Every index in `gltf` is in range and every number legal. `gltf.buffers` and `gltf.images` are
/// empty; see below.
struct GltfDocument {
    std::filesystem::path path;
    GltfContainer container;
    tinygltf::Model gltf;
    std::vector<std::span<const uint8_t>> buffers;
    std::vector<ImageSource> images;
    std::vector<ImageSource> lightProfiles;  ///< of EXT_lights_ies
    std::vector<std::string> extensionsUsed;
    std::vector<std::span<const uint8_t>> decodedViews;  ///< of compressed buffer views; else empty
    std::vector<Bytes> owned;  ///< what the spans point into, besides `container`

    /// Empty when the view is -1.
    std::span<const uint8_t> viewBytes(int bufferView) const;
};

/// Throws InputError.
GltfDocument readDocument(const std::filesystem::path& path, const LoadOptions& options);

}  // namespace rushlight::assets
