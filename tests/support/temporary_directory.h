#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace rushlight {

/// A directory of its own that is removed at the end.
class TemporaryDirectory {
public:
    TemporaryDirectory()
        : path_((std::filesystem::temp_directory_path() / "rushlight-XXXXXX").string()) {
        if (!mkdtemp(path_.data())) std::abort();
    }
    ~TemporaryDirectory() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    const std::string& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = std::filesystem::path(path_) / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
    }

private:
    std::string path_;
};

}  // namespace rushlight
