#include "tests/bench/bench_world.h"

#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 1280, kHeight = 720;

}  // namespace

BenchWorld::BenchWorld(const Desc& desc) : desc_(desc) {
    RendererDesc renderer;
    renderer.loadGl = desc.loadGl;
    renderer.jobs = desc.jobs;
    renderer_ = std::move(Renderer::create(renderer).value());
    std::vector<MeshHandle> meshes;
    const Shape shapes[] = {makeCube(), makeSphere(8, 12), makeSphere(12, 18)};
    for (uint32_t i = 0; i < desc.meshes; ++i)
        meshes.push_back(renderer_->createMesh(shapes[i % 3].desc()).value());
    std::vector<MaterialHandle> materials;
    for (uint32_t i = 0; i < 40; ++i) {
        MaterialDesc material;
        material.doubleSided = i % 4 == 0;
        material.roughness = float(i) / 40;
        materials.push_back(renderer_->createMaterial(material).value());
    }
    Random random(1);
    const uint32_t side = uint32_t(std::ceil(std::sqrt(float(desc.objects))));
    constexpr float kSpacing = 3;
    for (uint32_t i = 0; i < desc.objects; ++i) {
        Instance instance;
        instance.mesh = meshes[random.below(desc.meshes)];
        if (desc.meshes >= desc.objects) instance.mesh = meshes[i];
        instance.material = materials[random.below(40)];
        instance.worldFromLocal[3] = vec3(float(i % side), 0, float(i / side)) * kSpacing;
        instance.id = i;
        instances_.push_back(instance);
    }
    handles_.resize(instances_.size());
    world_ = renderer_->createWorld();
    if (!renderer_->addInstances(world_, instances_, handles_)) std::abort();
    suns_.push_back({glm::normalize(vec3(-1, -2, -0.5f)), vec3(3), true});
    middle_ = vec3(float(side) * kSpacing / 2, 0, float(side) * kSpacing / 2);
    // The view covers a sector of about 90 degrees.
    reach_ = std::sqrt(float(desc.visible) * kSpacing * kSpacing * 4 / kPi);
    settings.shadowCaching = false;
    settings.shadowDistance = reach_;
}

void BenchWorld::frame() {
    ++frameNumber_;
    const uint32_t moving = uint32_t(uint64_t(desc_.objects) * desc_.movingPercent / 100);
    for (uint32_t i = 0; i < moving; ++i) {
        const uint32_t which = uint32_t(uint64_t(i) * desc_.objects / moving);
        instances_[which].worldFromLocal[3].y = 0.5f * std::sin(0.1f * float(frameNumber_ + i));
        if (!renderer_->updateInstances(world_, {&handles_[which], 1}, {&instances_[which], 1}))
            std::abort();
    }
    FrameInput input;
    const bool all = desc_.visible >= desc_.objects;
    const float angle = 0.001f * float(frameNumber_ % 100);
    const vec3 eye = all ? middle_ + vec3(-1.5f, 1, 0) * reach_ : middle_ + vec3(0, 4, 0);
    const vec3 towards = vec3(std::cos(angle), all ? -0.55f : -0.05f, std::sin(angle));
    input.view.viewFromWorld = glm::lookAt(eye, eye + towards, vec3(0, 1, 0));
    input.view.verticalFov = 1.0f;
    input.view.farPlane = all ? reach_ * 10 : reach_;
    input.world = world_;
    input.lighting.directional = suns_;
    input.settings = settings;
    FrameOptions options;
    options.timers = false;
    if (desc_.change) desc_.change(input);
    if (!desc_.loadGl) {
        if (!renderer_->render(input, {0, kWidth, kHeight}, options)) std::abort();
        return;
    }
    const auto ticket = renderer_->renderOffscreen(input, kWidth, kHeight, CaptureKind::display,
                                                   options);
    if (!ticket || !renderer_->takeCapture(*ticket, true, image_)) std::abort();
}

}  // namespace rushlight
