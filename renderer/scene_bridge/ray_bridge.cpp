#include "renderer/scene_bridge/ray_bridge.h"

namespace rushlight {
namespace {

class Filler final : public ResourceSink {
public:
    explicit Filler(RayScene& scene) : scene_(scene) {}
    Result<void> image(ImageHandle h, const ImageDesc& d) override { return scene_.setImage(h, d); }
    Result<void> mesh(MeshHandle h, const MeshDesc& d) override { return scene_.setMesh(h, d); }
    Result<void> material(MaterialHandle h, const MaterialDesc& d) override {
        return scene_.setMaterial(h, d);
    }

private:
    RayScene& scene_;
};

}  // namespace

Result<std::unique_ptr<RayScene>> makeRayScene(const SceneBridge& bridge, JobSystem& jobs) {
    auto scene = RayScene::create(jobs);
    if (!scene) return scene;
    Filler filler(**scene);
    if (auto ok = bridge.describe(filler); !ok) return tl::unexpected(ok.error());
    FrameInput input;
    bridge.fill(input);
    if (auto ok = (*scene)->build(input.instances); !ok) return tl::unexpected(ok.error());
    return scene;
}

}  // namespace rushlight
