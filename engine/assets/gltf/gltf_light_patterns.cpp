// Profiles and cookies of lights: EXT_lights_ies, and what extras name.
#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/ies.h"
#include "engine/assets/input_error.h"

namespace rushlight::assets {

void GltfBuilder::buildLightProfiles() {
    for (const ImageSource& source : document_.lightProfiles) {
        if (!source.problem.empty())
            refuse("light profile '" + source.name + "': " + source.problem);
        const std::string_view text(reinterpret_cast<const char*>(source.bytes.data()),
                                    source.bytes.size());
        auto profile = parseIes(source.name, text);
        if (!profile) refuse("light profile '" + source.name + "': " + profile.error().message);
        if (hasTiltFactors(text)) approximated("EXT_lights_ies: tilt factors are not applied");
        model_.lightProfiles.push_back(std::move(*profile));
    }
}

void GltfBuilder::useProfile(Light& light, int profile, bool itsCandela) {
    light.profile = profile;
    if (!itsCandela) return;
    const double candela = double(light.intensity) *
                           double(model_.lightProfiles[size_t(profile)].largestCandela);
    if (candela > 1e30)
        refuse("light '" + light.name + "': with its profile it shines with " +
               std::to_string(candela) + " candela; the limit is 1e30.");
    light.intensity = float(candela);
}

bool GltfBuilder::readLightExtras(Light& light, const tinygltf::Value& extras) {
    if (!extras.IsObject() || !extras.Has("rushlight")) return false;
    const tinygltf::Value& ours = extras.Get("rushlight");
    if (ours.Has("lightProfile") && light.type != LightType::directional) {
        const bool itsCandela = ours.Has("useProfileCandela") &&
                                ours.Get("useProfileCandela").Get<bool>();
        useProfile(light, ours.Get("lightProfile").GetNumberAsInt(), itsCandela);
        exact("light profiles of extras.rushlight");
    }
    if (ours.Has("lightCookie") && light.type != LightType::directional) {
        light.cookie = imageFor(ours.Get("lightCookie").GetNumberAsInt(), true);
        exact("light cookies of extras.rushlight");
    }
    if (light.type == LightType::directional &&
        (ours.Has("lightProfile") || ours.Has("lightCookie")))
        unsupported("profiles and cookies of directional lights");
    return true;
}

// Extras of a node change the light of KHR_lights_punctual that it has, for it alone.
// EXT_lights_ies is a light of its own.
void GltfBuilder::buildNodeLight(int index, const tinygltf::Node& source) {
    Node& node = model_.nodes[size_t(index)];
    if (node.light >= 0) {
        Light own = model_.lights[size_t(node.light)];
        if (readLightExtras(own, source.extras)) {
            node.light = int(model_.lights.size());
            model_.lights.push_back(std::move(own));
        }
    }
    const auto found = source.extensions.find("EXT_lights_ies");
    if (found == source.extensions.end() || !found->second.Has("light")) return;
    Light light;
    light.name = node.name;
    light.type = LightType::point;
    if (found->second.Has("multiplier"))
        light.intensity = float(found->second.Get("multiplier").GetNumberAsDouble());
    if (found->second.Has("color"))
        for (int c = 0; c < 3; ++c)
            light.color[c] = float(found->second.Get("color").Get(size_t(c)).GetNumberAsDouble());
    useProfile(light, found->second.Get("light").GetNumberAsInt(), true);
    model_.lights.push_back(std::move(light));
    exact("EXT_lights_ies");
    if (node.light < 0) {
        node.light = int(model_.lights.size()) - 1;
        return;
    }
    Node holder;
    holder.name = node.name;
    holder.parent = index;
    holder.light = int(model_.lights.size()) - 1;
    node.children.push_back(int(model_.nodes.size()));
    model_.nodes.push_back(std::move(holder));
}

}  // namespace rushlight::assets
