#pragma once

#include <filesystem>

namespace rushlight::golden {

/// Where the program that runs lies; the working directory where that cannot be known.
inline std::filesystem::path programFolder() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::current_path() : program.parent_path();
}

}  // namespace rushlight::golden
