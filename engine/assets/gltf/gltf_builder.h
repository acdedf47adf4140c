#pragma once
// Turns a checked GltfDocument into a Model. One file per part; all share this state.

#include "engine/assets/gltf/gltf_accessor.h"
#include "engine/assets/gltf/gltf_document.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rushlight::assets {

class GltfBuilder {
public:
    GltfBuilder(const GltfDocument& document, const LoadOptions& options)
        : document_(document),
          gltf_(document.gltf),
          options_(options),
          reader_(document, options.maxElements) {}

    Model build();

private:
    // gltf_materials.cpp
    void buildMaterials();
    Material buildMaterial(const tinygltf::Material& source, const std::string& what);
    TextureUse buildTexture(int texture, int texCoord, const tinygltf::ExtensionMap& extensions,
                            bool isColor, const std::string& what);
    int imageFor(int texture, bool isColor);
    void noteMaterialExtensions(const tinygltf::Material& source, const std::string& what);
    void decodeImages();

    // gltf_transmission.cpp
    void buildTransmission(const tinygltf::Material& source, const std::string& what,
                           Material& material);
    void buildVolume(const tinygltf::Value& value, Material& material);

    // gltf_geometry.cpp
    void buildMeshes();
    void buildPrimitive(Mesh& mesh, const tinygltf::Primitive& source, const std::string& what);
    int geometryFor(const tinygltf::Primitive& source, const std::string& what);
    Geometry readGeometry(const tinygltf::Primitive& source, int tangentUv,
                          const std::string& what);
    void readAttributes(Geometry& geometry, const tinygltf::Primitive& source,
                        const std::string& what);
    void readMorphTargets(Geometry& geometry, const tinygltf::Primitive& source,
                          const std::string& what);
    std::vector<uint32_t> readIndices(const tinygltf::Primitive& source) const;
    int tangentUvSet(const tinygltf::Primitive& source) const;

    // gltf_attributes.cpp
    void checkAttribute(const std::string& semantic, int accessor, size_t vertexCount,
                        bool isTarget, const std::string& what) const;
    void checkIndices(const tinygltf::Primitive& source, const std::string& what) const;
    void noteAttributes(const tinygltf::Primitive& source, const std::string& what);

    // gltf_nodes.cpp
    void buildNodes();
    void buildInstances(int node, const tinygltf::Value& extension);
    void buildScene();
    void buildCameras();
    void buildLights();

    // gltf_light_patterns.cpp
    void buildLightProfiles();
    void buildNodeLight(int node, const tinygltf::Node& source);
    bool readLightExtras(Light& light, const tinygltf::Value& extras);
    void useProfile(Light& light, int profile, bool itsCandela);
    // gltf_area_lights.cpp
    void buildAreaLight(size_t node, const tinygltf::Value& extras);

    // gltf_surroundings.cpp
    void buildReflectionProbe(size_t node, const tinygltf::Value& extras);
    void buildImageBasedLight();
    void readFace(ImageBasedLight& light, uint32_t level, int image);

    // gltf_animation.cpp
    void buildSkins();
    void checkSkinnedNodes() const;
    void buildAnimations();
    AnimationChannel buildChannel(const tinygltf::Animation& animation,
                                  const tinygltf::AnimationChannel& source,
                                  const std::string& what);

    void noteExtensions();
    void exact(std::string property) { exact_.insert(std::move(property)); }
    void approximated(std::string property) { approximated_.insert(std::move(property)); }
    void unsupported(std::string property) { unsupported_.insert(std::move(property)); }

    const GltfDocument& document_;
    const tinygltf::Model& gltf_;
    const LoadOptions& options_;
    AccessorReader reader_;
    Model model_;
    std::map<std::pair<int, bool>, int> imageOf_;  ///< (source, is colour) → Model::images
    std::vector<int> imageSources_;                ///< of each of Model::images
    std::map<std::vector<int>, int> geometryOf_;
    uint64_t elements_ = 0;
    std::set<std::string> exact_, approximated_, unsupported_;
};

}  // namespace rushlight::assets
