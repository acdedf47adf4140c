#include "sandbox/tool/render_setup.h"

#include "engine/assets/gltf.h"
#include "engine/jobs/tbb_jobs.h"
#include "renderer/capture/image_files.h"
#include "renderer/scene_bridge/scene_surroundings.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/probes.h"
#include "sandbox/viewer/program_files.h"

#include <chrono>
#include <cmath>
#include <filesystem>

namespace rushlight::tool {
namespace {

constexpr uint32_t kBakedEnvironmentWidth = 1024;

template <class Named>
std::vector<std::string> namesOf(const std::vector<Named>& objects) {
    std::vector<std::string> names;
    for (const Named& object : objects) names.push_back(object.name);
    return names;
}

mat4 lookAt(const vec3& eye, const vec3& target, const vec3& up) {
    const vec3 forward = glm::normalize(target - eye);
    const bool parallel = glm::length(glm::cross(forward, up)) < 1e-6f * glm::length(up);
    return glm::lookAt(eye, target, parallel ? vec3(0, 0, 1) : up);
}

void logToStandardError(void*, LogLevel level, std::string_view message) {
    if (level >= LogLevel::warning) printWarning(std::string(message));
}

}  // namespace

Result<std::unique_ptr<RenderSetup>> RenderSetup::open(const RenderOptions& options,
                                                       bool pinRasterThreads) {
    const auto start = std::chrono::steady_clock::now();
    std::unique_ptr<RenderSetup> setup(new RenderSetup(options));
    setup->jobs_ = createTbbJobs(options.threads);
    Result<void> step = setup->loadScene();
    if (step) step = setup->startRenderer(pinRasterThreads);
    if (step) step = setup->loadEnvironment();
    if (step) step = setup->chooseCamera();
    if (!step) return tl::unexpected(step.error());
    setup->chooseLights();
    if (step = setup->loadProbes(); !step) return tl::unexpected(step.error());
    if (step = setup->captureReflections(); !step) return tl::unexpected(step.error());
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() -
                                                              start;
    setup->loadMs_ = elapsed.count();
    return setup;
}

Result<std::unique_ptr<RenderSetup>> RenderSetup::openToBake(const RenderOptions& options) {
    std::unique_ptr<RenderSetup> setup(new RenderSetup(options));
    setup->jobs_ = createTbbJobs(options.threads);
    Result<void> step = setup->loadScene();
    if (step) step = setup->createRenderer(nullptr);
    if (step) step = setup->loadEnvironment();
    if (step) step = setup->chooseCamera();
    if (!step) return tl::unexpected(step.error());
    setup->chooseLights();
    return setup;
}

RenderSetup::~RenderSetup() {
    if (renderer_ && probes_) renderer_->destroy(probes_);
    if (renderer_ && environment_) renderer_->destroy(environment_);
}

Result<void> RenderSetup::loadScene() {
    assets::LoadOptions load;
    load.jobs = jobs_.get();
    load.strict = options_.strict;
    auto model = assets::loadModel(options_.scene, load);
    if (!model) return tl::unexpected(model.error());
    model_ = std::move(*model);
    for (const std::string& warning : model_.warnings) printWarning(warning);
    if (options_.animation.empty()) return {};
    const auto found = findNamed(options_.scene, "animation", options_.animation,
                                 namesOf(model_.animations));
    if (!found) return tl::unexpected(found.error());
    animation_ = *found;
    return {};
}

Result<void> RenderSetup::startRenderer(bool pinRasterThreads) {
    auto context = createOffscreenContext(options_.context, {.pinRasterThreads = pinRasterThreads});
    if (!context) return tl::unexpected(context.error());
    context_ = std::move(*context);
    return createRenderer(context_->loader());
}

Result<void> RenderSetup::createRenderer(GlLoadFunction loader) {
    RendererDesc desc;
    desc.loadGl = loader;
    desc.jobs = jobs_.get();
    desc.log.write = logToStandardError;
    desc.cacheDirectory = userCacheDirectory();
    auto renderer = Renderer::create(desc);
    if (!renderer) return tl::unexpected(renderer.error());
    renderer_ = std::move(*renderer);
    auto bridge = SceneBridge::create(*renderer_, model_);
    if (!bridge) return tl::unexpected(bridge.error());
    bridge_ = std::move(*bridge);
    auto& unsupported = model_.fidelity.unsupported;
    unsupported.insert(unsupported.end(), bridge_->notes().begin(), bridge_->notes().end());
    return setTime(options_.time);
}

Result<void> RenderSetup::makeSkyEnvironment() {
    const float elevation = glm::radians(options_.sky->elevation);
    const float azimuth = glm::radians(options_.sky->azimuth);
    SkyDesc desc;
    desc.sunDirection = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth)};
    desc.turbidity = options_.sky->turbidity;
    auto sky = makeSky(desc, *jobs_);
    if (!sky) return tl::unexpected(Error{"--sky", sky.error().message, sky.error().kind});
    sky_ = std::move(*sky);
    return useEnvironment(sky_->environment("sky"));
}

Result<void> RenderSetup::loadEnvironment() {
    if (options_.sky) return makeSkyEnvironment();
    if (options_.environment.empty() && model_.imageBasedLight)
        return useFileEnvironment(*model_.imageBasedLight);
    if (options_.environment.empty()) {
        if (options_.background != Background::environment) return {};
        return fail("--background environment",
                    "There is no environment; name one with --environment.", ErrorKind::wrongUse);
    }
    const auto picture = loadPicture(options_.environment);
    if (!picture) return tl::unexpected(picture.error());
    if (!picture->linear)
        return fail(options_.environment,
                    "An environment is linear radiance in floats; use a .hdr or .exr file.");
    std::vector<vec3> pixels(picture->pixelCount());
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = {picture->rgba[i * 4], picture->rgba[i * 4 + 1], picture->rgba[i * 4 + 2]};
    return useEnvironment({options_.environment, picture->width, picture->height, pixels});
}

Result<void> RenderSetup::useFileEnvironment(const assets::ImageBasedLight& light) {
    if (options_.probes != "off" || !context_)
        environmentPixels_ = equirectOf(light, kBakedEnvironmentWidth, environmentSize_);
    fileIntensity_ = light.intensity;
    hasEnvironment_ = true;
    if (!context_) return {};
    const auto created = renderer_->createPrefilteredEnvironment(environmentOf(light));
    if (!created) return tl::unexpected(created.error());
    environment_ = *created;
    return {};
}

// With the light that the frames have; the probes' own light is left out of each other.
Result<void> RenderSetup::captureReflections() {
    if (!options_.reflectionProbes || !bridge_->hasReflectionProbes()) return {};
    return bridge_->captureReflections(frame());
}

Result<void> RenderSetup::useEnvironment(const EnvironmentDesc& desc) {
    if (options_.probes != "off" || !context_) {
        environmentPixels_.assign(desc.pixels.begin(), desc.pixels.end());
        environmentSize_ = {desc.width, desc.height};
    }
    hasEnvironment_ = true;
    if (!context_) return {};
    const auto created = renderer_->createEnvironment(desc);
    if (!created) return tl::unexpected(created.error());
    environment_ = *created;
    return {};
}

Result<void> RenderSetup::chooseCamera() {
    if (!options_.camera.empty()) {
        const auto found = findNamed(options_.scene, "camera", options_.camera,
                                     namesOf(model_.cameras));
        if (!found) return tl::unexpected(found.error());
        if (!bridge_->cameraView(*found))
            return fail(options_.scene,
                        "No node of the shown scene has the camera \"" + options_.camera + "\".");
        camera_ = *found;
        return {};
    }
    const Aabb bounds = bridge_->bounds();
    view_ = viewThatFrames(bounds, glm::radians(options_.verticalFov),
                           float(options_.size.x) / float(options_.size.y));
    if (options_.eye) {
        const float distance = glm::length(*options_.target - *options_.eye);
        if (!(distance > 0) || glm::length(options_.up) == 0)
            return fail("--eye", "It is the same point as --target, or --up is zero.",
                        ErrorKind::wrongUse);
        view_.viewFromWorld = lookAt(*options_.eye, *options_.target, options_.up);
        const float size = bounds.isEmpty() ? distance : glm::length(bounds.halfExtent());
        view_.nearPlane = std::clamp(std::min(distance, size) * 0.01f, 1e-4f, 0.1f);
    } else {
        for (int camera = 0; camera_ < 0 && camera < int(model_.cameras.size()); ++camera)
            if (bridge_->cameraView(camera)) camera_ = camera;
    }
    return {};
}

BakeLighting RenderSetup::bakeLighting() const {
    const FrameInput input = frame();
    const Lighting& from = input.lighting;
    BakeLighting lighting;
    lighting.directional = from.directional;
    lighting.punctual = from.punctual;
    lighting.area = from.area;
    lighting.patterns = &bridge_->lightPatterns();
    lighting.environment = {"environment", environmentSize_.x, environmentSize_.y,
                            environmentPixels_};
    lighting.environmentRotation = from.environmentRotation;
    lighting.environmentIntensity = from.environmentIntensity;
    lighting.ambientSky = from.ambientSky;
    lighting.ambientGround = from.ambientGround;
    return lighting;
}

Result<IrradianceVolume> RenderSetup::bakeProbes() {
    return tool::bakeProbes(*bridge_, bakeLighting(), options_.probeSpacing, options_.probeSamples,
                            *jobs_);
}

// A file that is named is used as it is, one that merely lies there only under the light that it
// was baked for.
Result<void> RenderSetup::loadProbes() {
    if (options_.probes == "off") return {};
    const bool named = !options_.probes.empty(), bakes = options_.probes == "bake";
    const std::string path = named ? options_.probes : defaultProbePath(options_.scene);
    if (std::error_code ignored; !named && !std::filesystem::exists(path, ignored)) return {};
    const auto volume = bakes ? bakeProbes() : readProbes(path);
    if (!volume) return tl::unexpected(volume.error());
    const bool sameLight = bakes || volume->lightHash == hashOf(bakeLighting());
    environmentPixels_ = {};
    if (!sameLight)
        printWarning(path + ": the probes were baked under other light than is asked for" +
                     (named ? "."
                            : "; they are not used. Name the file with --probes to use it "
                              "all the same, or bake again."));
    if (!sameLight && !named) return {};
    const auto created = renderer_->createIrradianceVolume(*volume);
    if (!created) return tl::unexpected(created.error());
    probes_ = *created;
    return {};
}

void RenderSetup::chooseLights() {
    if (bridge_->hasLights() || hasEnvironment_ || options_.ambient) return;
    defaultLights_ = defaultLights(frame().view);
    model_.fidelity.approximated.push_back(
        "lighting: the file has no lights and no environment was given; a sun from behind the "
        "camera and ambient light are used.");
}

Result<void> RenderSetup::setTime(float seconds) { return bridge_->pose(animation_, seconds); }

FrameInput RenderSetup::frame() const {
    FrameInput input;
    bridge_->fill(input);
    input.view = camera_ >= 0 ? *bridge_->cameraView(camera_) : view_;
    input.settings = settingsFrom(options_);
    Lighting& lighting = input.lighting;
    lighting.environment = environment_;
    lighting.irradianceVolume = probes_;
    lighting.environmentRotation = glm::radians(options_.environmentRotation);
    lighting.environmentIntensity = options_.environmentIntensity * fileIntensity_;
    lighting.background = options_.background.value_or(environment_ ? Background::environment
                                                                    : Background::color);
    lighting.backgroundColor = options_.backgroundColor;
    lighting.ambientSky = lighting.ambientGround = options_.ambient.value_or(vec3(0));
    lighting.fog = options_.fog;
    if (sky_) {
        lighting.directional = {&sky_->sun, 1};
        lighting.sunDisk = {-sky_->sun.direction, kSunAngularRadius, sky_->sunRadiance};
        const bool chosen = options_.autoExposure || options_.exposureValue ||
                            options_.exposureScale != 1;
        if (!chosen) {
            input.settings.useExposureValue = true;
            input.settings.exposureValue = sky_->exposureValue;
        }
    }
    if (defaultLights_) {
        lighting.directional = {&defaultLights_->sun, 1};
        lighting.ambientSky = defaultLights_->ambientSky;
        lighting.ambientGround = defaultLights_->ambientGround;
    }
    return input;
}

}  // namespace rushlight::tool
