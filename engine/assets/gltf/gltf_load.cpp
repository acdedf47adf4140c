#include "engine/assets/gltf.h"

#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/gltf/gltf_schema.h"
#include "engine/assets/input_error.h"

#include <exception>

namespace rushlight::assets {
/// Extensions of materials are noted with the materials that have them, most others where they are
/// used.
void GltfBuilder::noteExtensions() {
    for (const std::string& name : document_.extensionsUsed) {
        if (name == "KHR_mesh_quantization" || name == "EXT_meshopt_compression") exact(name);
        if (isSupportedExtension(name) || name.rfind("KHR_materials_", 0) == 0) continue;
        unsupported("extension " + name);
    }
}

Model GltfBuilder::build() {
    model_.path = document_.path.string();
    model_.generator = gltf_.asset.generator;
    reader_.checkAll(options_.strict);
    buildMaterials();
    buildMeshes();
    buildCameras();
    buildLightProfiles();
    buildLights();
    buildNodes();
    buildScene();
    buildImageBasedLight();
    buildSkins();
    checkSkinnedNodes();
    buildAnimations();
    noteExtensions();
    decodeImages();
    model_.fidelity.exact.assign(exact_.begin(), exact_.end());
    model_.fidelity.approximated.assign(approximated_.begin(), approximated_.end());
    model_.fidelity.unsupported.assign(unsupported_.begin(), unsupported_.end());
    if (options_.strict && !unsupported_.empty())
        refuse("strict loading refuses what is unsupported: " + *unsupported_.begin() + ".");
    if (options_.strict && !approximated_.empty())
        refuse("strict loading refuses what is approximated: " + *approximated_.begin() + ".");
    return std::move(model_);
}

Result<Model> loadModel(const std::filesystem::path& path, const LoadOptions& options) {
    try {
        const GltfDocument document = readDocument(path, options);
        return GltfBuilder(document, options).build();
    } catch (const InputError& error) {
        return fail(path.string(), error.message);
    } catch (const std::exception& error) {
        return fail(path.string(), std::string("it cannot be loaded: ") + error.what() + ".");
    }
}

}  // namespace rushlight::assets
