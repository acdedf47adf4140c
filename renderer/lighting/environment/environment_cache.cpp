#include "renderer/lighting/environment/environment_cache.h"

#include "engine/core/hash.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rushlight {
namespace {

constexpr std::array<char, 8> kMagic = {'R', 'L', 'E', 'N', 'V', '\r', '\n', 0};
constexpr uint32_t kFileVersion = 2;

/// The header is followed by the halves of the irradiance, the specular and the background cube.
/// Little-endian, as all our platforms.
struct FileHeader {
    std::array<char, 8> magic = kMagic;
    uint32_t version = kFileVersion;
    uint32_t specularSize = 0;
    uint32_t specularLevels = 0;
    uint32_t backgroundSize = 0;
    uint64_t sourceHash = 0;
    uint64_t payloadHash = 0;  ///< of irradiance, specular and background, in this order
};
static_assert(sizeof(FileHeader) == 40 && std::is_trivially_copyable_v<FileHeader>);

uint64_t hashPayload(const PrefilteredEnvironment& e) {
    uint64_t hash = hashBytes(e.irradiance.halves.data(), e.irradiance.halves.size() * 2);
    hash = hashBytes(e.specular.halves.data(), e.specular.halves.size() * 2, hash);
    return hashBytes(e.background.halves.data(), e.background.halves.size() * 2, hash);
}

bool isPlausible(const FileHeader& h, uint64_t hash) {
    return h.magic == kMagic && h.version == kFileVersion && h.sourceHash == hash &&
           h.specularSize == kEnvironmentSize && h.specularLevels == kEnvironmentLevels &&
           h.backgroundSize >= kEnvironmentSize && h.backgroundSize <= kMaxBackgroundSize;
}

bool readHalves(std::ifstream& file, CubeTexels& cube) {
    cube.halves.resize(CubeTexels::halfCount(cube.size, cube.levels));
    file.read(reinterpret_cast<char*>(cube.halves.data()), std::streamsize(cube.halves.size() * 2));
    return bool(file);
}

void writeHalves(std::ofstream& file, const CubeTexels& cube) {
    file.write(reinterpret_cast<const char*>(cube.halves.data()),
               std::streamsize(cube.halves.size() * 2));
}

}  // namespace

std::string environmentCachePath(const std::string& directory, uint64_t hash) {
    char name[48];
    std::snprintf(name, sizeof name, "environment-%016llx.rlenv",
                  static_cast<unsigned long long>(hash));
    return (std::filesystem::path(directory) / name).string();
}

std::optional<PrefilteredEnvironment> loadPrefiltered(const std::string& path, uint64_t hash) {
    std::error_code error;
    const uintmax_t bytes = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    FileHeader header;
    if (error || !file || !file.read(reinterpret_cast<char*>(&header), sizeof header)) return {};
    if (!isPlausible(header, hash)) return {};
    PrefilteredEnvironment result;
    result.irradiance = {kIrradianceSize, 1, {}};
    result.specular = {header.specularSize, header.specularLevels, {}};
    result.background = {header.backgroundSize, 1, {}};
    const size_t halves = CubeTexels::halfCount(kIrradianceSize, 1) +
                          CubeTexels::halfCount(header.specularSize, header.specularLevels) +
                          CubeTexels::halfCount(header.backgroundSize, 1);
    if (bytes != sizeof header + halves * 2) return {};
    if (!readHalves(file, result.irradiance) || !readHalves(file, result.specular) ||
        !readHalves(file, result.background))
        return {};
    if (hashPayload(result) != header.payloadHash) return {};
    return result;
}

Result<void> savePrefiltered(const std::string& path, uint64_t hash,
                             const PrefilteredEnvironment& environment) {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    if (!parent.empty()) std::filesystem::create_directories(parent, error);

    FileHeader header;
    header.specularSize = environment.specular.size;
    header.specularLevels = environment.specular.levels;
    header.backgroundSize = environment.background.size;
    header.sourceHash = hash;
    header.payloadHash = hashPayload(environment);

    // The process number keeps two programs that fill one cache apart.
    const std::string temporary = path + "." + std::to_string(::getpid()) + ".tmp";
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    writeHalves(file, environment.irradiance);
    writeHalves(file, environment.specular);
    writeHalves(file, environment.background);
    file.close();
    if (!file) {
        std::filesystem::remove(temporary, error);
        return fail(path,
                    "The prefiltered environment could not be written; check that the "
                    "directory is writable and the disk has 20 MB free.");
    }
    std::filesystem::rename(temporary, path, error);
    if (!error) return {};
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    return fail(path,
                "The prefiltered environment could not be renamed into place: " + reason + ".");
}

Result<PrefilteredEnvironment> prefilterEnvironmentCached(const EnvironmentDesc& desc,
                                                          const std::string& directory,
                                                          JobSystem& jobs, const LogSink& log) {
    if (directory.empty()) return prefilterEnvironment(desc, jobs);
    const uint64_t hash = environmentHash(desc);
    const std::string path = environmentCachePath(directory, hash);
    if (auto cached = loadPrefiltered(path, hash)) return std::move(*cached);
    std::error_code error;
    if (std::filesystem::exists(path, error))
        log(LogLevel::warning, path +
                                   ": the cached environment is damaged or of another version; "
                                   "it is computed again.");
    auto result = prefilterEnvironment(desc, jobs);
    if (!result) return result;
    if (auto saved = savePrefiltered(path, hash, *result); !saved)
        log(LogLevel::warning, saved.error().text());
    return result;
}

}  // namespace rushlight
