// Light that comes with the level's file.
#include "renderer/scene_bridge/scene_surroundings.h"
#include "sandbox/viewer/viewer_app.h"

namespace rushlight {

Result<void> ViewerApp::useLevelLight() {
    if (levelEnvironment_) {
        renderer_->destroy(environment_);
        environment_ = {};
        levelEnvironment_ = settings_.hasEnvironment = false;
    }
    const auto& light = level_->model().imageBasedLight;
    if (light && options_.environment.empty()) {
        const auto made = renderer_->createPrefilteredEnvironment(environmentOf(*light));
        if (!made) return tl::unexpected(made.error());
        environment_ = *made;
        levelEnvironment_ = settings_.hasEnvironment = true;
        lighting_.environmentIntensity = options_.lighting.environmentIntensity * light->intensity;
    }
    if (options_.reflectionProbes)
        if (auto done = level_->captureReflections(describeScene()); !done) return done;
    settings_.hasReflectionProbes = !level_->reflectionProbes().empty();
    return {};
}

}  // namespace rushlight
