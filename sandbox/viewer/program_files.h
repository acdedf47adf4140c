#pragma once

#include <filesystem>
#include <string>

namespace rushlight {

/// Finds a file or folder that belongs to the program ("shaders", "content/square/square.gltf"):
/// upwards from the program's own folder, as in the build tree, then in share/rushlight of an
/// installation, then in the working directory. Empty when it is nowhere.
std::filesystem::path findProgramFile(const std::filesystem::path& relative);

/// Where this user's caches are kept: $XDG_CACHE_HOME/rushlight, else ~/.cache/rushlight; made when
/// absent. Empty when it cannot be had: then nothing is cached.
std::string userCacheDirectory();

/// `folder`/`stem`-NNN.`extension` with the first number that is free; the folder is made.
std::string freeFileName(const std::string& folder, const std::string& stem,
                         const std::string& extension);

}  // namespace rushlight
