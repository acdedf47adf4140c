// What makes lights uneven: EXT_lights_ies, and the cookies and profiles that extras name.
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>

namespace rushlight::assets {

std::optional<JsonObject> extrasOf(const JsonObject& owner) {
    if (!owner.has("extras") || !owner.json()["extras"].is_object()) return std::nullopt;
    const JsonObject extras(owner.json()["extras"], owner.what() + " extras");
    const Json* ours = extras.object("rushlight");
    if (!ours) return std::nullopt;
    return JsonObject(*ours, extras.what() + ".rushlight");
}

size_t checkLightProfiles(const Counts& counts, const JsonObject& root) {
    const Json* json = findExtension(root, "EXT_lights_ies");
    if (!json) return 0;
    const JsonObject extension(*json, "EXT_lights_ies");
    forEach(
        extension, "lights", "light profile",
        [&](const JsonObject& profile) {
            profile.text("uri");
            profile.text("name");
            profile.index("bufferView", counts.bufferViews);
            profile.oneOf("mimeType", {"application/x-ies-lm-63"});
            if (profile.has("uri") == profile.has("bufferView"))
                profile.wrong("it must have either a uri or a bufferView.");
            if (profile.has("bufferView") && !profile.has("mimeType"))
                profile.wrong("it has a bufferView but no mimeType.");
        },
        Need::required);
    return extension.json()["lights"].size();
}

void checkNodeProfile(const Counts& counts, const JsonObject& node) {
    const Json* json = findExtension(node, "EXT_lights_ies");
    if (!json) return;
    const JsonObject light(*json, node.what() + " EXT_lights_ies");
    light.index("light", counts.lightProfiles, Need::required);
    light.number("multiplier", 0, FLT_MAX);
    light.numbers("color", 3, 0, 1);
}

// Extras belong to whoever wrote them: one object of our name is looked at, and that strictly.
void checkLightExtras(const Counts& counts, const JsonObject& owner) {
    const std::optional<JsonObject> ours = extrasOf(owner);
    if (!ours) return;
    ours->index("lightProfile", counts.lightProfiles);
    ours->index("lightCookie", counts.textures);
    ours->boolean("useProfileCandela");
}

}  // namespace rushlight::assets
