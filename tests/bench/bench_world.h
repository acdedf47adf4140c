#pragma once
// A plain of objects that is seen as densely whatever its size, for benchmarks.

#include "renderer/renderer.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <memory>
#include <vector>

namespace rushlight {

class BenchWorld {
public:
    struct Desc {
        uint32_t objects = 3000;
        uint32_t meshes = 3000;      ///< different ones; as many as objects: no two draws merge
        uint32_t visible = 3000;     ///< about as many are before the camera, if there are as many
        uint32_t movingPercent = 0;  ///< of all objects, each frame
        GlLoadFunction loadGl = nullptr;
        JobSystem* jobs = nullptr;
        void (*change)(FrameInput&) = nullptr;  ///< touches each frame's input before it is
                                                ///< rendered
    };

    explicit BenchWorld(const Desc& desc);

    /// Moves what moves, turns the camera a little, and renders. Shadow maps are not kept.
    void frame();
    const FrameReport& report() const { return renderer_->report(); }
    Renderer& renderer() { return *renderer_; }
    FrameSettings settings;

private:
    Desc desc_;
    std::unique_ptr<Renderer> renderer_;
    WorldHandle world_;
    std::vector<Instance> instances_;
    std::vector<InstanceHandle> handles_;
    std::vector<DirectionalLight> suns_;
    float reach_ = 0;  ///< metres that the camera sees
    vec3 middle_{0};
    uint32_t frameNumber_ = 0;
    CapturedImage image_;
};

}  // namespace rushlight
