#pragma once
// The options that all rendering subcommands share, read once.

#include "engine/core/result.h"
#include "renderer/context/context.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/quality.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace rushlight::tool {

struct FrameRange {
    uint32_t first = 0;
    uint32_t last = 0;
};

struct Shard {
    uint32_t index = 1;  ///< from 1
    uint32_t count = 1;
};

/// Angles in degrees; azimuth 0 is -z, 90 is +x.
struct SkyOption {
    float elevation = 45;
    float azimuth = 135;
    float turbidity = 2;
};

struct RenderOptions {
    std::string scene;
    uvec2 size{1280, 720};
    ContextChoice context = ContextChoice::automatic;
    uint32_t threads = 0;  ///< 0: one a core

    std::string camera;  ///< name or index; empty: the first
    std::optional<vec3> eye;
    std::optional<vec3> target;
    vec3 up{0, 1, 0};
    float verticalFov = 45;  ///< degrees

    std::string environment;
    std::optional<SkyOption> sky;
    Fog fog;
    float environmentRotation = 0;  ///< degrees
    float environmentIntensity = 1;
    std::optional<vec3> ambient;
    std::optional<Background> background;
    vec3 backgroundColor{0};

    float exposureScale = 1;
    std::optional<float> exposureValue;
    bool autoExposure = false;
    ToneMap toneMap = ToneMap::neutral;

    std::string probes;  ///< a file, off, bake; empty: the file beside the scene, if there is one
    bool reflectionProbes = true;  ///< those of the file are captured
    float probeSpacing = 0;        ///< metres; 0: chosen
    uint32_t probeSamples = 512;

    std::string animation;  ///< name or index; empty: none
    float time = 0;

    Quality quality = Quality::high;
    std::optional<bool> shadows;
    std::optional<bool> shadowCaching;
    std::optional<uint32_t> shadowCascades;
    std::optional<uint32_t> shadowResolution;
    std::optional<bool> lightShadows;
    std::optional<uint32_t> shadowAtlasSize;
    std::optional<ShadowFilter> shadowFilter;
    std::optional<AmbientOcclusion> ambientOcclusion;
    std::optional<float> ambientOcclusionRadius;
    std::optional<bool> reflections;
    std::optional<ContactShadows> contactShadows;
    std::optional<bool> bloom;
    std::optional<bool> dither;
    std::optional<AntiAliasing> antiAliasing;
    std::optional<bool> occlusionCulling;
    std::optional<float> lodError;
    std::optional<float> shadowLodError;
    std::optional<float> smallObjects;

    uint32_t warmup = 0;
    bool strict = false;
    std::string stats;
};

/// Refuses what is not a number or infinite: ranges alone let NaN pass.
CLI::Validator finiteNumber();

void addRenderOptions(CLI::App& command, RenderOptions& options);
/// What bears on the light of a scene, for what renders no picture.
void addBakeOptions(CLI::App& command, RenderOptions& options);
/// --context alone, for what renders no scene.
void addContextOption(CLI::App& command, ContextChoice& choice);

/// The quality level's settings with the single switches over them.
FrameSettings settingsFrom(const RenderOptions& options);

/// "A-B" with A <= B, and "I/N" with 1 <= I <= N; throw CLI::ValidationError.
FrameRange parseFrames(const std::string& text);
Shard parseShard(const std::string& text);

/// The position of a name, or of a number in range, in `names`. ErrorKind::badInput with what there
/// is.
Result<int> findNamed(const std::string& scene, const char* kind, const std::string& wanted,
                      const std::vector<std::string>& names);

}  // namespace rushlight::tool
