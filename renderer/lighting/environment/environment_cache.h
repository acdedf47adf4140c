#pragma once
// Prefiltered environments on disk, one file each, named by the hash of what they were made from.

#include "engine/core/log.h"
#include "renderer/lighting/environment/environment.h"

#include <optional>
#include <string>

namespace rushlight {

/// `directory`/environment-<hash>.rlenv
std::string environmentCachePath(const std::string& directory, uint64_t hash);

/// Nothing when the file is absent, of another version or hash, not exactly as long as it says, or
/// its payload does not hash to what the header holds.
std::optional<PrefilteredEnvironment> loadPrefiltered(const std::string& path, uint64_t hash);

/// Writes a temporary file beside `path` and renames it, so that readers never see half a file.
Result<void> savePrefiltered(const std::string& path, uint64_t hash,
                             const PrefilteredEnvironment& environment);

/// From the cache if it is there and good, else computed and stored. An empty directory: no cache.
/// That the cache cannot be read or written is logged and costs time only.
Result<PrefilteredEnvironment> prefilterEnvironmentCached(const EnvironmentDesc& desc,
                                                          const std::string& directory,
                                                          JobSystem& jobs, const LogSink& log);

}  // namespace rushlight
