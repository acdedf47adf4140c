#pragma once
// EXT_meshopt_compression, decoded by meshoptimizer.

#include "engine/assets/gltf/gltf_document.h"
#include "engine/assets/json_object.h"

namespace rushlight::assets {

/// The rules of the extension on one buffer view, if it has it.
void checkMeshoptView(const JsonObject& root, const JsonObject& view, size_t bufferCount);

/// Decodes all compressed views into GltfDocument::decodedViews. The buffers must have been read.
void decodeMeshopt(GltfDocument& document, const Json& gltf, const LoadOptions& options);

}  // namespace rushlight::assets
