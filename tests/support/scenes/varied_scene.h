#pragma once
// A RandomScene with what metamorphic tests need beside it: descriptions that can be given once
// more, ground and walls for shadows to fall on, lamps with shadows, area lights, fog, ambient
// occlusion, coloured panes. Nothing in it follows earlier frames.

#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shapes.h"

namespace rushlight {

struct SceneVariation {
    bool twinMeshes = false;  ///< every second object has a mesh of its own with the same triangles
    bool lods = true;
    bool glows = true;  ///< materials may be emissive or unlit
    bool glass = true;  ///< the seeds that have panes have them
};

class VariedScene : public RandomScene {
public:
    VariedScene(Renderer& renderer, uint64_t seed, const SceneVariation& variation = {});

    /// As RandomScene::frame, with the areas and the fog.
    FrameInput frame(uint32_t index);

    /// Moves everything, the camera's view too, by a rigid transform; frame() gives the moved view
    /// from then on.
    void move(const mat4& transform);

    std::vector<AreaLight> areas;
    Fog fog;
    bool hasGlass = false;

private:
    void makeMaterials(Renderer& renderer, const SceneVariation& variation);
    void addBuilding(Renderer& renderer, const SceneVariation& variation);
    void addLamps();
    Instance& add(MeshHandle mesh, MaterialHandle material, const vec3& center, const vec3& size);

    Random random_;
    std::vector<MaterialHandle> materials_;
    mat4 sceneFromMoved_{1};
};

}  // namespace rushlight
