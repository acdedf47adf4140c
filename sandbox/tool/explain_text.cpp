#include "sandbox/tool/explain_text.h"

#include <cmath>
#include <cstdio>

namespace rushlight::tool {
namespace {

using nlohmann::ordered_json;

const char* toText(ToneMap map) {
    switch (map) {
        case ToneMap::none: return "none";
        case ToneMap::neutral: return "neutral";
        case ToneMap::agx: return "agx";
        case ToneMap::aces: return "aces";
    }
    return "?";
}

std::string nameOf(const LightShare& light) {
    const char* kind = light.kind == LightKind::sun        ? "sun "
                       : light.kind == LightKind::punctual ? "light "
                                                           : "area light ";
    return kind + std::to_string(light.index);
}

std::string quotedOr(const std::string& name, const char* kind, uint32_t number) {
    return name.empty() ? std::string(kind) + " " + std::to_string(number) : "\"" + name + "\"";
}

std::string describe(const InstanceFacts& object, const RenderSetup& setup) {
    const ObjectNames names = setup.objectNames(object.instance.id);
    std::string text = quotedOr(names.node, "object", object.index) + " (instance " +
                       std::to_string(object.index) + "), mesh " +
                       quotedOr(names.mesh, "number", object.instance.mesh.index()) + " level " +
                       std::to_string(object.lod) + " of " + std::to_string(object.lodCount) +
                       " (" + std::to_string(object.triangles) + " triangles), material ";
    return text + (names.material.empty() ? "without a name" : "\"" + names.material + "\"");
}

void row(const std::string& name, const vec3& v, const std::string& note = {}) {
    std::string line = "  " + name;
    line.resize(std::max<size_t>(line.size() + 1, 28), ' ');
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%11.5f %11.5f %11.5f", double(v.r), double(v.g),
                  double(v.b));
    std::printf("%s%s%s%s\n", line.c_str(), numbers, note.empty() ? "" : "   ", note.c_str());
}

void rowUnlessZero(const std::string& name, const vec3& v, const std::string& note = {}) {
    if (v != vec3(0)) row(name, v, note);
}

std::string percent(const char* what, float share) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %.1f %%", what, double(share) * 100);
    return text;
}

void printSurface(const PixelExplanation& p, const RenderSetup& setup) {
    if (p.blended) std::printf("in front  %s, blended\n", describe(*p.blended, setup).c_str());
    if (!p.surface) {
        std::printf("drawn     nothing opaque: the background\n");
        return;
    }
    const PixelSurface& s = *p.surface;
    std::printf("drawn     %s\n", s.object ? describe(*s.object, setup).c_str() : "an object");
    std::printf("at        (%.3f, %.3f, %.3f), %.3f m before the camera\n", double(s.position.x),
                double(s.position.y), double(s.position.z), double(s.viewDepth));
    std::printf(
        "surface   base colour (%.3f, %.3f, %.3f), metallic %.2f, roughness %.2f, "
        "normal (%.2f, %.2f, %.2f), occlusion %.2f\n",
        double(s.baseColor.r), double(s.baseColor.g), double(s.baseColor.b), double(s.metallic),
        double(s.roughness), double(s.normal.x), double(s.normal.y), double(s.normal.z),
        double(s.occlusion));
}

ordered_json json(const vec3& v) { return {v.x, v.y, v.z}; }

ordered_json json(const InstanceFacts& object, const RenderSetup& setup) {
    const ObjectNames names = setup.objectNames(object.instance.id);
    return {{"instance", object.index},     {"node", names.node}, {"mesh", names.mesh},
            {"material", names.material},   {"lod", object.lod},  {"lods", object.lodCount},
            {"triangles", object.triangles}};
}

}  // namespace

void printExplanation(const PixelExplanation& p, const RenderSetup& setup, uvec2 size) {
    std::printf("pixel     %u,%u of %ux%u: %d %d %d of 255\n", p.pixel.x, p.pixel.y, size.x, size.y,
                p.shown[0], p.shown[1], p.shown[2]);
    printSurface(p, setup);
    std::printf("\n  %-26s%11s %11s %11s\n", "radiance", "red", "green", "blue");
    rowUnlessZero("background", p.background);
    for (const LightShare& light : p.lights)
        row(nameOf(light), light.radiance,
            light.shadow < 0.9995f ? percent("in shadow by", 1 - light.shadow) : "");
    const std::string open = p.ambientVisibility < 0.9995f
                                 ? percent("occluded by", 1 - p.ambientVisibility)
                                 : "";
    rowUnlessZero("ambient, diffuse", p.ambientDiffuse, open);
    rowUnlessZero("ambient, mirrored", p.ambientSpecular);
    rowUnlessZero("emitted or unlit", p.emissive);
    rowUnlessZero("reflections of the screen", p.reflections);
    rowUnlessZero("fog", p.fog);
    rowUnlessZero("blended surfaces", p.blendedSurfaces);
    rowUnlessZero("bloom", p.bloom);
    row("= radiance", p.radiance);
    row("x exposure", p.radiance * p.exposure,
        "a factor of " + std::to_string(p.exposure) + ", EV100 " +
            std::to_string(std::log2(1 / (1.2f * std::max(p.exposure, 1e-30f)))));
    row(std::string("tone map ") + toText(p.toneMap), p.display);
    row("as sRGB, of 255", p.encoded * 255.0f);
    rowUnlessZero("dithering", p.dither * 255.0f);
    rowUnlessZero("anti-aliasing", p.antiAliasing * 255.0f);
    char off[48];
    std::snprintf(off, sizeof off, "off by %.2f at most", double(p.error) * 255);
    row("= sum, of 255", p.sum * 255.0f, off);
}

ordered_json explanationJson(const PixelExplanation& p, const RenderSetup& setup) {
    ordered_json j = {{"version", 1}, {"pixel", {p.pixel.x, p.pixel.y}}, {"shown", p.shown}};
    if (p.blended) j["in_front"] = json(*p.blended, setup);
    if (p.surface) {
        const PixelSurface& s = *p.surface;
        if (s.object) j["drawn"] = json(*s.object, setup);
        j["surface"] = {{"position", json(s.position)},    {"view_depth", s.viewDepth},
                        {"base_color", json(s.baseColor)}, {"metallic", s.metallic},
                        {"roughness", s.roughness},        {"normal", json(s.normal)},
                        {"occlusion", s.occlusion}};
    }
    j["background"] = json(p.background);
    j["lights"] = ordered_json::array();
    for (const LightShare& light : p.lights)
        j["lights"].push_back({{"light", nameOf(light)},
                               {"index", light.index},
                               {"radiance", json(light.radiance)},
                               {"shadow", light.shadow}});
    j["ambient_diffuse"] = json(p.ambientDiffuse);
    j["ambient_specular"] = json(p.ambientSpecular);
    j["ambient_visibility"] = p.ambientVisibility;
    j["emissive"] = json(p.emissive);
    j["reflections"] = json(p.reflections);
    j["fog"] = json(p.fog);
    j["blended"] = json(p.blendedSurfaces);
    j["bloom"] = json(p.bloom);
    j["radiance"] = json(p.radiance);
    j["exposure"] = p.exposure;
    j["tone_map"] = toText(p.toneMap);
    j["display"] = json(p.display);
    j["encoded"] = json(p.encoded);
    j["dither"] = json(p.dither);
    j["anti_aliasing"] = json(p.antiAliasing);
    j["sum"] = json(p.sum);
    j["error"] = p.error;
    return j;
}

}  // namespace rushlight::tool
