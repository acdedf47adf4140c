#pragma once
// A scene with something of everything, made from a seed.

#include "renderer/renderer.h"
#include "tests/support/random.h"

namespace rushlight {

class RandomScene {
public:
    /// Makes its resources in `renderer`, which outlives it. Seeds that end in 1 have an
    /// environment, which takes long.
    RandomScene(Renderer& renderer, uint64_t seed);

    /// Frame `index` along the camera's way; the spans stay good until the next call.
    FrameInput frame(uint32_t index);

    std::vector<Instance> instances;
    std::vector<mat4x3> previousTransforms;
    std::vector<DirectionalLight> suns;
    std::vector<PunctualLight> lights;
    std::vector<ReflectionProbe> reflectionProbes;
    FrameSettings settings;

private:
    void makeMaterials(Renderer& renderer, uint64_t seed);
    void makeInstances();
    void makeLights();

    Random random_;
    std::vector<MeshHandle> meshes_;
    std::vector<MaterialHandle> materials_;
    ImageHandle overlayImage_;
    EnvironmentHandle environment_;
    std::vector<OverlayVertex> overlayVertices_;
    std::vector<uint32_t> overlayIndices_;
    std::vector<OverlayBatch> overlayBatches_;
    vec3 eye_{0};
};

}  // namespace rushlight
