#pragma once
// Small scenes as users build them, and mistakes that users make with them.

#include "renderer/answers/diagnose.h"
#include "tests/support/scenes/shapes.h"

#include <functional>
#include <string>
#include <vector>

namespace rushlight {

/// A scene that owns what its FrameInput points to, with its own resources, so that a fault may
/// damage all of it.
struct Stage {
    explicit Stage(Renderer& r) : renderer(r) {}
    ~Stage();
    Stage(const Stage&) = delete;

    Renderer& renderer;
    std::vector<MeshHandle> meshes;
    std::vector<MaterialHandle> materials;
    std::vector<Instance> instances;
    std::vector<DirectionalLight> suns;
    std::vector<PunctualLight> lamps;
    std::vector<AreaLight> panels;
    FrameInput input;
    vec3 eye{0, 3, 8}, target{0, 0.5f, 0};
    uvec2 size{96, 64};

    MaterialHandle paint(const MaterialDesc& desc);
    MaterialHandle paint(const vec3& color, float metallic = 0, float roughness = 0.8f);
    void repaint(const std::function<void(MaterialDesc&)>& change);  ///< all instances
    Instance& box(const vec3& center, const vec3& half, MaterialHandle material);
    Instance& card(const vec3& center, float half, MaterialHandle material, bool reversed = false);
    void look();               ///< from `eye` to `target`
    void scale(float factor);  ///< all transforms about the origin
    const FrameInput& frame();

private:
    MeshHandle cube_, card_, reversedCard_;
};

// The healthy scenes.
void buildYard(Stage&);    ///< boxes on a floor in the sun, a little ambient light
void buildCellar(Stage&);  ///< a closed room, two lamps, no other light
void buildShop(Stage&);    ///< boxes before a wall, a spot and an area light
void buildField(Stage&);   ///< 150 boxes in a row of rows, a sun in lux, an exposure value
void buildCards(Stage&);   ///< pictures that stand in the air, seen from the front

struct FaultyFrame {
    const char* name;
    Cause cause;
    void (*scene)(Stage&);
    std::function<void(Stage&)> mistake;
};
std::vector<FaultyFrame> faultyFrames();

struct HealthyFrame {
    const char* name;
    void (*scene)(Stage&);
    std::function<void(Stage&)> change;
};
std::vector<HealthyFrame> healthyFrames();

}  // namespace rushlight
