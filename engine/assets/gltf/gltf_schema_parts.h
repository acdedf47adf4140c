#pragma once
// The parts of checkSchema: gltf_schema_data.cpp, gltf_schema_looks.cpp, gltf_schema_scene.cpp.

#include "engine/assets/json_object.h"

#include <optional>

namespace rushlight::assets {

/// How many of each there are, for references.
struct Counts {
    size_t accessors = 0, buffers = 0, bufferViews = 0, cameras = 0, images = 0, lights = 0;
    size_t lightProfiles = 0, imageBasedLights = 0;
    size_t materials = 0, meshes = 0, nodes = 0, samplers = 0, scenes = 0, skins = 0, textures = 0;
};

/// Calls `check` with each object of an array property of `parent`.
template <class Check>
void forEach(const JsonObject& parent, const char* key, const char* kind, const Check& check,
             Need need = Need::optional, const std::string& prefix = {}) {
    const Json* array = parent.array(key, need);
    if (!array) return;
    for (size_t i = 0; i < array->size(); ++i)
        check(JsonObject((*array)[i], prefix + nameOf(kind, i, (*array)[i])));
}

/// What the extras of `owner` say to us, an object; nothing where they do not.
std::optional<JsonObject> extrasOf(const JsonObject& owner);

/// The extension object of that name, or null.
const Json* findExtension(const JsonObject& owner, const char* name);

void checkBuffers(const Counts& counts, const JsonObject& root);
void checkAccessors(const Counts& counts, const JsonObject& root);
void checkTextures(const Counts& counts, const JsonObject& root);
void checkMaterials(const Counts& counts, const JsonObject& root);
void checkMeshes(const Counts& counts, const JsonObject& root);
void checkCameras(const JsonObject& root);
size_t checkLights(const Counts& counts, const JsonObject& root);         ///< how many there are
size_t checkLightProfiles(const Counts& counts, const JsonObject& root);  ///< how many there are
void checkNodeProfile(const Counts& counts, const JsonObject& node);
void checkLightExtras(const Counts& counts, const JsonObject& owner);
size_t checkImageBasedLights(const Counts& counts, const JsonObject& root);  ///< how many there are
void checkImageBasedLightOf(const JsonObject& scene, size_t lights);
void checkReflectionProbe(const JsonObject& node);
void checkAreaLight(const JsonObject& node);
void checkNodes(const Counts& counts, const JsonObject& root);
void checkSkins(const Counts& counts, const JsonObject& root);
void checkAnimations(const Counts& counts, const JsonObject& root);

}  // namespace rushlight::assets
