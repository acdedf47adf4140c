#include "sandbox/viewer/program_files.h"

#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace rushlight {
namespace fs = std::filesystem;

fs::path findProgramFile(const fs::path& relative) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path folder = program.parent_path(); !error && !folder.empty();
         folder = folder.parent_path()) {
        if (fs::exists(folder / relative, error)) return folder / relative;
        if (folder == folder.root_path()) break;
    }
    error.clear();
    const fs::path installed = program.parent_path().parent_path() / "share" / "rushlight" /
                               relative;
    if (fs::exists(installed, error)) return installed;
    if (fs::exists(relative, error)) return relative;
    return {};
}

std::string userCacheDirectory() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    fs::path folder;
    if (cache && *cache)
        folder = fs::path(cache) / "rushlight";
    else if (home && *home)
        folder = fs::path(home) / ".cache" / "rushlight";
    else
        return {};
    std::error_code error;
    fs::create_directories(folder, error);
    return error ? std::string() : folder.string();
}

std::string freeFileName(const std::string& folder, const std::string& stem,
                         const std::string& extension) {
    std::error_code error;
    fs::create_directories(folder, error);
    for (int number = 1;; ++number) {
        char name[32];
        std::snprintf(name, sizeof name, "-%03d.", number);
        const fs::path path = fs::path(folder) / (stem + name + extension);
        if (!fs::exists(path, error)) return path.string();
    }
}

}  // namespace rushlight
