#pragma once
// A glTF file that is being shown: its plain data, its GPU resources, its lights and what the
// player bumps into.

#include "engine/assets/model.h"
#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "engine/physics/triangle_grid.h"
#include "renderer/frame/frame_input.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

class Renderer;

/// Where to look from: a node of the file with a camera, or a place to stand.
struct LevelCamera {
    vec3 position{0};
    vec3 forward{0, 0, -1};
    bool perspective = true;
    float verticalFov = 0.785f;
    float orthoHalfHeight = 1;
    float nearPlane = 0.05f;
    float farPlane = 0;
};

class Level {
public:
    /// `renderer` must outlive the level. On an Error nothing of it stays in the renderer.
    static Result<std::unique_ptr<Level>> load(const std::string& path, Renderer& renderer,
                                               JobSystem* jobs);
    ~Level();
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

    /// Moves what the file's first animation moves, which plays over and over, and puts the lights
    /// back to what the file says.
    Result<void> advanceTo(double seconds);

    const assets::Model& model() const;
    std::span<const Instance> instances() const;
    std::span<const mat4x3> previousTransforms() const;
    std::span<const DirectionalLight> directionalLights() const;
    std::span<PunctualLight> punctualLights();
    /// Those of the file's nodes; none before captureReflections.
    std::span<const ReflectionProbe> reflectionProbes() const;
    /// Where the file has some: see SceneBridge::captureReflections.
    Result<void> captureReflections(const FrameInput& input);
    /// The name of the node that carries a punctual light.
    const std::string& punctualName(size_t index) const;
    /// Made when first asked for: only who walks needs it.
    const TriangleGrid& collision();
    Aabb bounds() const;

    /// World transform of the first node with this name, in the pose of the file.
    std::optional<mat4> nodeNamed(std::string_view name) const;
    /// By node name, camera name or index. Empty `name`: the first camera, if there is one.
    std::optional<LevelCamera> camera(std::string_view name) const;
    /// One that sees everything, from the front and a little above.
    LevelCamera framingCamera() const;

private:
    struct Scene;
    Level();

    std::unique_ptr<Scene> scene_;
    std::optional<TriangleGrid> collision_;
};

/// The shown triangles of a model in the pose of the file, in world space.
std::vector<CollisionTriangle> collisionTriangles(const assets::Model& model);

}  // namespace rushlight
