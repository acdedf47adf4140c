#include "sandbox/tool/probes.h"

#include "renderer/scene_bridge/ray_bridge.h"
#include "sandbox/tool/progress.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rushlight::tool {

std::string defaultProbePath(const std::string& scene) {
    return std::filesystem::path(scene).replace_extension(".probes").string();
}

Result<IrradianceVolume> bakeProbes(const SceneBridge& bridge, const BakeLighting& lighting,
                                    float spacing, uint32_t samples, JobSystem& jobs) {
    const auto scene = makeRayScene(bridge, jobs);
    if (!scene) return tl::unexpected(scene.error());
    ProbeBakeDesc desc;
    desc.spacing = spacing;
    desc.samples = samples;
    Progress progress("probe");
    desc.user = &progress;
    desc.progress = [](void* user, uint32_t done, uint32_t count) {
        static_cast<const Progress*>(user)->show(done, count);
    };
    return bakeIrradiance(**scene, lighting, desc, jobs);
}

Result<IrradianceVolume> readProbes(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? std::streamoff(file.tellg()) : -1;
    if (size < 0)
        return fail(path,
                    "The file could not be read (" + std::generic_category().message(errno) + ").");
    // A volume of the most probes has 19 MB.
    if (size > 64 << 20)
        return fail(path,
                    "This is no file of light probes: it has " + std::to_string(size) + " bytes.");
    std::vector<std::byte> bytes(static_cast<size_t>(size));
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), size))
        return fail(path, "The file could not be read to its end.");
    return decodeIrradianceVolume(bytes, path);
}

}  // namespace rushlight::tool
