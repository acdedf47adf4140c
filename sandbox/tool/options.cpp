#include "sandbox/tool/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <span>

namespace rushlight::tool {
namespace {

/// The whole of `text` as a finite number.
template <class T>
bool parseNumber(std::string_view text, T& value) {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return !text.empty() && parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() &&
           std::isfinite(double(value));
}

[[noreturn]] void refuse(const std::string& text, const char* wanted) {
    throw CLI::ValidationError("\"" + text + "\" is not " + wanted);
}

/// Numbers with commas between them, as many as there are; false where one is none or there are too
/// many.
bool parseNumbers(std::string_view text, std::span<float* const> numbers) {
    for (float* number : numbers) {
        const size_t comma = text.find(',');
        if (!parseNumber(text.substr(0, comma), *number)) return false;
        if (comma == text.npos) return true;
        text.remove_prefix(comma + 1);
    }
    return false;
}

SkyOption parseSky(const std::string& text) {
    SkyOption sky;
    float* const parts[] = {&sky.elevation, &sky.azimuth, &sky.turbidity};
    if (parseNumbers(text, parts)) return sky;
    refuse(text, "a sky as 30, 30,135 or 30,135,2: elevation, azimuth and turbidity");
}

Fog parseFog(const std::string& text) {
    Fog fog;
    float* const parts[] = {&fog.density, &fog.heightFalloff, &fog.height, &fog.anisotropy};
    if (parseNumbers(text, parts)) return fog;
    refuse(text, "fog as 0.02 or 0.02,0.1,0,0.3: density, falloff, height and anisotropy");
}

vec3 parseVector(const std::string& text) {
    vec3 v;
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const size_t comma = rest.find(',');
        if ((i < 2) != (comma != rest.npos) || !parseNumber(rest.substr(0, comma), v[i]))
            refuse(text, "three numbers with commas between them");
        if (i < 2) rest.remove_prefix(comma + 1);
    }
    return v;
}

/// "A<separator>B" of unsigned numbers.
bool parsePair(std::string_view text, char separator, uint32_t& a, uint32_t& b) {
    const size_t at = text.find(separator);
    return at != text.npos && parseNumber(text.substr(0, at), a) &&
           parseNumber(text.substr(at + 1), b);
}

uvec2 parseSize(const std::string& text) {
    uvec2 size;
    if (!parsePair(text, 'x', size.x, size.y) || size.x < 1 || size.y < 1 || size.x > 16384 ||
        size.y > 16384)
        refuse(text, "a size as 1280x720, 1 to 16384 pixels a side");
    return size;
}

template <class T>
CLI::Option* addChoice(CLI::App& app, const char* name, T& target,
                       const std::map<std::string, T>& choices, const char* help) {
    return app
        .add_option_function<std::string>(
            name, [&target, choices](const std::string& text) { target = choices.at(text); }, help)
        ->check(CLI::IsMember(choices));
}

void addSwitch(CLI::App& app, const char* name, std::optional<bool>& target, const char* help) {
    app.add_option_function<std::string>(
           name, [&target](const std::string& text) { target = text == "on"; }, help)
        ->check(CLI::IsMember({"on", "off"}));
}

template <class Target>
void addVector(CLI::App& app, const char* name, Target& target, const char* help) {
    app.add_option_function<std::string>(
        name, [&target](const std::string& text) { target = parseVector(text); }, help);
}

void addCameraOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("--camera", o.camera, "A camera of the file, by name or index (the first)");
    addVector(app, "--eye", o.eye, "x,y,z: look from here instead, with --target");
    addVector(app, "--target", o.target, "x,y,z: the point to look at");
    addVector(app, "--up", o.up, "x,y,z: up in the picture (0,1,0)");
    app.add_option("--fov", o.verticalFov, "Vertical field of view in degrees, with --eye")
        ->check(finiteNumber())
        ->check(CLI::Range(0.1f, 179.0f))
        ->capture_default_str();
    app.get_option("--eye")
        ->needs(app.get_option("--target"))
        ->excludes(app.get_option("--camera"));
    app.get_option("--target")->needs(app.get_option("--eye"));
}

void addLightOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("--environment", o.environment,
                   "An equirectangular picture (.hdr, .exr) as light");
    app.add_option("--environment-rotation", o.environmentRotation, "Degrees about the up axis")
        ->check(finiteNumber());
    app.add_option("--environment-intensity", o.environmentIntensity, "A factor on its light")
        ->check(finiteNumber())
        ->check(CLI::NonNegativeNumber);
    app.add_option_function<std::string>(
           "--sky", [&o](const std::string& text) { o.sky = parseSky(text); },
           "ELEVATION[,AZIMUTH[,TURBIDITY]]: a clear sky with its sun, in degrees, as light, "
           "background and exposure; "
           "it takes the place of the file's directional lights")
        ->excludes(app.get_option("--environment"));
    app.add_option_function<std::string>(
        "--fog", [&o](const std::string& text) { o.fog = parseFog(text); },
        "DENSITY[,FALLOFF[,HEIGHT[,ANISOTROPY]]]: fog of so much extinction per metre at a height, "
        "falling off "
        "upwards per metre; anisotropy -0.95 to 0.95");
    addVector(app, "--ambient", o.ambient, "r,g,b: light from all around, without an environment");
    app.add_option_function<std::string>(
        "--background",
        [&o](const std::string& text) {
            o.background = text == "environment"   ? Background::environment
                           : text == "transparent" ? Background::transparent
                                                   : Background::color;
            if (*o.background == Background::color) o.backgroundColor = parseVector(text);
        },
        "environment, transparent, or r,g,b in linear radiance");
}

void addProbeOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("--probe-spacing", o.probeSpacing,
                   "Metres between baked light probes (such that there are about 4,096)")
        ->check(finiteNumber())
        ->check(CLI::PositiveNumber);
    app.add_option("--samples", o.probeSamples, "Paths that a baked light probe traces")
        ->check(CLI::Range(16u, 65536u))
        ->capture_default_str();
}

void addAnimationOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("--animation", o.animation, "An animation of the file, by name or index");
    app.add_option("--time", o.time, "The moment of the animation, in seconds")
        ->check(finiteNumber())
        ->needs(app.get_option("--animation"));
}

void addDisplayOptions(CLI::App& app, RenderOptions& o) {
    CLI::Option* scale = app.add_option("--exposure-scale", o.exposureScale,
                                        "A linear factor on radiance")
                             ->check(finiteNumber())
                             ->check(CLI::NonNegativeNumber)
                             ->capture_default_str();
    app.add_option_function<std::string>(
           "--exposure",
           [&o](const std::string& text) {
               float value = 0;
               o.autoExposure = text == "auto";
               if (o.autoExposure) return;
               if (!parseNumber(text, value)) refuse(text, "an EV100 value or auto");
               o.exposureValue = value;
           },
           "An EV100 value, or auto")
        ->excludes(scale);
    addChoice<ToneMap>(app, "--tonemap", o.toneMap,
                       {{"none", ToneMap::none},
                        {"neutral", ToneMap::neutral},
                        {"agx", ToneMap::agx},
                        {"aces", ToneMap::aces}},
                       "How radiance becomes a display's colours (neutral)");
    addAnimationOptions(app, o);
}

void addQualityOptions(CLI::App& app, RenderOptions& o) {
    addChoice<Quality>(app, "--quality", o.quality,
                       {{"low", Quality::low},
                        {"medium", Quality::medium},
                        {"high", Quality::high},
                        {"ultra", Quality::ultra}},
                       "Sets what the switches below do not (high)");
    addSwitch(app, "--shadows", o.shadows, "Shadows of the sun");
    addSwitch(app, "--shadow-cache", o.shadowCaching, "Keep shadow maps that nothing changes");
    app.add_option("--shadow-cascades", o.shadowCascades, "Shadow maps along the view")
        ->check(CLI::Range(1u, 4u));
    app.add_option("--shadow-resolution", o.shadowResolution, "Pixels a side of a shadow map")
        ->check(CLI::Range(64u, 8192u));
    addSwitch(app, "--light-shadows", o.lightShadows, "Shadows of point and spot lights");
    app.add_option("--shadow-atlas", o.shadowAtlasSize, "Pixels a side of the map that they share")
        ->check(CLI::Range(256u, 16384u));
    const std::map<std::string, ShadowFilter> filters = {
        {"hard", ShadowFilter::hard}, {"pcf", ShadowFilter::pcf}, {"soft", ShadowFilter::soft}};
    app.add_option_function<std::string>(
           "--shadow-filter",
           [&o, filters](const std::string& text) { o.shadowFilter = filters.at(text); },
           "Edges of shadows: sharp, filtered, or softer with distance")
        ->check(CLI::IsMember(filters));
    addChoice<std::optional<ContactShadows>>(app, "--contact-shadows", o.contactShadows,
                                             {{"off", ContactShadows::off},
                                              {"sun", ContactShadows::sun},
                                              {"on", ContactShadows::lights}},
                                             "Detail finer than shadow maps shadows what is next "
                                             "to it: of the sun, or (on) of lamps too");
    addChoice<std::optional<AmbientOcclusion>>(app, "--ao", o.ambientOcclusion,
                                               {{"off", AmbientOcclusion::off},
                                                {"on", AmbientOcclusion::medium},
                                                {"low", AmbientOcclusion::low},
                                                {"medium", AmbientOcclusion::medium},
                                                {"high", AmbientOcclusion::high}},
                                               "Surfaces hide ambient light from each other");
    app.add_option("--ao-radius", o.ambientOcclusionRadius, "Metres over which they do (1)")
        ->check(finiteNumber())
        ->check(CLI::PositiveNumber);
    app.add_option_function<std::string>(
           "--reflection-probes",
           [&o](const std::string& text) { o.reflectionProbes = text == "on"; },
           "Capture the file's reflection probes when it is loaded, and mirror them (on)")
        ->check(CLI::IsMember({"on", "off"}));
    addSwitch(app, "--ssr", o.reflections, "Smooth surfaces mirror what the picture shows");
    addSwitch(app, "--bloom", o.bloom, "A glow around bright light");
    addSwitch(app, "--dither", o.dither, "Dither before 8 bit, against banding");
    app.add_option_function<std::string>(
           "--aa",
           [&o](const std::string& text) {
               o.antiAliasing = text == "fxaa" ? AntiAliasing::fxaa : AntiAliasing::off;
           },
           "Anti-aliasing")
        ->check(CLI::IsMember({"off", "fxaa"}));
    const auto addPixels = [&](const char* name, std::optional<float>& value, const char* text) {
        app.add_option(name, value, text)->check(finiteNumber())->check(CLI::NonNegativeNumber);
    };
    addSwitch(app, "--occlusion", o.occlusionCulling, "Leave out what is hidden behind others");
    addPixels("--lod-error", o.lodError,
              "Pixels that a simplified mesh may be off; 0: meshes as they are");
    addPixels("--shadow-lod-error", o.shadowLodError,
              "The same of shadows, in texels of their map");
    addPixels("--small-objects", o.smallObjects,
              "Leave out objects that are fewer pixels, or shadow texels, across; 0: none");
}

}  // namespace

void addRenderOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("SCENE", o.scene, "A .gltf or .glb file")->required();
    app.add_option_function<std::string>(
        "--size", [&o](const std::string& text) { o.size = parseSize(text); },
        "Pixels, WxH (1280x720)");
    addContextOption(app, o.context);
    app.add_option("--threads", o.threads, "Threads that build a frame; 0: one a core")
        ->check(CLI::Range(0u, 256u));
    app.add_option("--warmup", o.warmup, "Frames to render before the first that counts")
        ->check(CLI::Range(0u, 100000u));
    app.add_flag("--strict", o.strict, "What is approximated or unsupported is an error");
    app.add_option("--stats", o.stats, "Write the numbers of the last frame as JSON");
    addCameraOptions(app, o);
    addLightOptions(app, o);
    app.add_option("--probes", o.probes,
                   "Indirect light: a file of rushlight bake, off, or bake now (the .probes file "
                   "beside the scene, if it was baked under this light)");
    addProbeOptions(app, o);
    addDisplayOptions(app, o);
    addQualityOptions(app, o);
}

void addBakeOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("SCENE", o.scene, "A .gltf or .glb file")->required();
    app.add_option("--threads", o.threads, "Threads that trace; 0: one a core")
        ->check(CLI::Range(0u, 256u));
    app.add_flag("--strict", o.strict, "What is approximated or unsupported is an error");
    addLightOptions(app, o);
    addProbeOptions(app, o);
    addAnimationOptions(app, o);
}

void addContextOption(CLI::App& app, ContextChoice& choice) {
    addChoice<ContextChoice>(app, "--context", choice,
                             {{"auto", ContextChoice::automatic},
                              {"egl", ContextChoice::egl},
                              {"osmesa", ContextChoice::osmesa},
                              {"window", ContextChoice::window}},
                             "How to get OpenGL (auto)");
}

CLI::Validator finiteNumber() {
    return {[](std::string& text) {
                double value = 0;
                return parseNumber(std::string_view(text), value)
                           ? std::string()
                           : "\"" + text + "\" is not a finite number";
            },
            "NUMBER"};
}

FrameSettings settingsFrom(const RenderOptions& o) {
    FrameSettings settings = frameSettings(o.quality);
    const auto choose = [](auto& setting, const auto& asked) {
        if (asked) setting = *asked;
    };
    choose(settings.shadows, o.shadows);
    choose(settings.shadowCaching, o.shadowCaching);
    choose(settings.shadowCascades, o.shadowCascades);
    choose(settings.shadowResolution, o.shadowResolution);
    choose(settings.lightShadows, o.lightShadows);
    choose(settings.shadowAtlasSize, o.shadowAtlasSize);
    settings.shadowTileSize = std::min(settings.shadowTileSize, settings.shadowAtlasSize);
    choose(settings.shadowFilter, o.shadowFilter);
    choose(settings.ambientOcclusion, o.ambientOcclusion);
    choose(settings.ambientOcclusionRadius, o.ambientOcclusionRadius);
    choose(settings.reflections, o.reflections);
    choose(settings.contactShadows, o.contactShadows);
    choose(settings.bloom, o.bloom);
    choose(settings.antiAliasing, o.antiAliasing);
    choose(settings.dither, o.dither);
    choose(settings.occlusionCulling, o.occlusionCulling);
    choose(settings.lodPixelError, o.lodError);
    choose(settings.shadowLodTexelError, o.shadowLodError);
    choose(settings.smallObjectPixels, o.smallObjects);
    settings.exposureScale = o.exposureScale;
    settings.useExposureValue = o.exposureValue.has_value();
    settings.exposureValue = o.exposureValue.value_or(0);
    settings.autoExposure = o.autoExposure;
    settings.toneMap = o.toneMap;
    return settings;
}

FrameRange parseFrames(const std::string& text) {
    FrameRange range;
    if (!parsePair(text, '-', range.first, range.last) || range.first > range.last)
        refuse(text, "a range of frames as 0-119");
    return range;
}

Shard parseShard(const std::string& text) {
    Shard shard;
    if (!parsePair(text, '/', shard.index, shard.count) || shard.index < 1 ||
        shard.index > shard.count)
        refuse(text, "a part of a sequence as 1/4");
    return shard;
}

Result<int> findNamed(const std::string& scene, const char* kind, const std::string& wanted,
                      const std::vector<std::string>& names) {
    for (size_t i = 0; i < names.size(); ++i)
        if (names[i] == wanted) return int(i);
    uint32_t index = 0;
    if (parseNumber(std::string_view(wanted), index) && index < names.size()) return int(index);
    std::string message = std::string("There is no ") + kind + " \"" + wanted + "\"; ";
    if (names.empty()) return fail(scene, message + "the file has none.");
    message += "the file has " + std::to_string(names.size()) + ", 0 to " +
               std::to_string(names.size() - 1) + ":";
    for (size_t i = 0; i < names.size() && i < 8; ++i) message += " \"" + names[i] + "\"";
    return fail(scene, message + (names.size() > 8 ? " ..." : "."));
}

}  // namespace rushlight::tool
