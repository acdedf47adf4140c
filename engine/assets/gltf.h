#pragma once
// glTF 2.0 files (.gltf, .glb) as plain CPU data. The file is not trusted: whatever is wrong with
// it is an Error.

#include "engine/assets/model.h"
#include "engine/core/jobs.h"
#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace rushlight::assets {

enum class MissingImages : uint8_t {
    refuse,   ///< an image that cannot be had is an Error
    replace,  ///< it becomes a checker and is named in Model::warnings
};

struct LoadOptions {
    JobSystem* jobs = nullptr;  ///< decodes images; null: the calling thread does
    bool strict = false;        ///< what is approximated or unsupported is an Error
    MissingImages missingImages = MissingImages::refuse;

    uint64_t maxFileBytes = 2ull << 30;    ///< of one file
    uint32_t maxImageSide = 16384;         ///< pixels
    uint64_t maxImagePixels = 1ull << 29;  ///< of all images together
    uint64_t maxElements = 1ull << 28;     ///< vertices and indices of all geometries together
    uint32_t maxNodes = 1u << 20;          ///< after instancing
};

/// The files that a .gltf or .glb file names, sorted, each once: the model is made of them and of
/// the file itself. What loadModel would refuse to read is not among them; there are none where the
/// file is no glTF.
std::vector<std::filesystem::path> namedFiles(const std::filesystem::path& path);

/// Reads no file outside the folder of `path`.
Result<Model> loadModel(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace rushlight::assets
