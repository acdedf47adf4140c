#pragma once
// A loaded model as resources of a Renderer and as the spans of a FrameInput. Used on the
// renderer's thread.

#include "engine/assets/model.h"
#include "renderer/lighting/light_patterns.h"
#include "renderer/renderer.h"
#include "renderer/scene_bridge/resource_sink.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rushlight {

/// What a file calls an object; names may be empty.
struct ObjectNames {
    std::string node, mesh, material;
};

class SceneBridge {
public:
    /// Uploads all that the shown scene uses: an image once per use as colour or as data, a mesh
    /// once per geometry, or per node where it is skinned or morphed. `renderer` and `model` must
    /// outlive the bridge. What Renderer refuses is an Error.
    static Result<std::unique_ptr<SceneBridge>> create(Renderer& renderer,
                                                       const assets::Model& model);
    ~SceneBridge();  ///< destroys the resources

    /// Moves the scene to `seconds` of an animation (-1: the file's own pose). Where it was before
    /// becomes the previous transform of what moved. Deformed meshes are computed and sent only
    /// when something changed.
    Result<void> pose(int animation, float seconds);

    /// Fills the instances, previous transforms, lights and captured reflection probes. The spans
    /// are good until the next pose().
    void fill(FrameInput& input) const;

    /// Hands over what the renderer was given, deformed meshes in their present pose.
    Result<void> describe(ResourceSink& sink) const;

    bool hasLights() const;
    /// Profiles and cookies of its lights, for rays.
    const LightPatternSet& lightPatterns() const;

    /// Captures the light around the nodes that have reflection probes, in the present pose, as
    /// `input` lights it: what fill() gave, and what else a frame has. Before the first time fill()
    /// gives no probes; a later time captures anew. Two bounces: each is captured twice, with six
    /// frames and a prefiltering.
    Result<void> captureReflections(const FrameInput& input);
    bool hasReflectionProbes() const;

    /// Of an index into FrameInput::instances of fill(), which is Instance::id too.
    ObjectNames objectNames(uint32_t instance) const;

    Aabb bounds() const;  ///< of all instances, world space; empty when nothing is shown

    /// The camera of Model::cameras in its pose; nothing when no shown node has it.
    std::optional<View> cameraView(int camera) const;

    /// What the model has and a frame cannot take, in sentences.
    const std::vector<std::string>& notes() const;

private:
    struct State;
    explicit SceneBridge(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

}  // namespace rushlight
