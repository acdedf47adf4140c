#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace rushlight::assets {

/// Whether loadModel honours an extension, so that a file may require it.
bool isSupportedExtension(std::string_view name);

/// Checks the JSON of a glTF 2.0 file against the rules that need no buffer: types, required
/// properties, ranges, enumerations, references, extensions, hierarchy. Throws InputError that says
/// what is wrong and where.
void checkSchema(const nlohmann::json& gltf);

}  // namespace rushlight::assets
