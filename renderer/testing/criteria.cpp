#include "renderer/testing/criteria.h"

#include "renderer/testing/program_folder.h"

namespace rushlight::golden {

namespace fs = std::filesystem;

fs::path findSourceFile(const fs::path& name) {
    std::error_code ignored;
    if (name.is_absolute() || fs::exists(name, ignored)) return name;
    for (fs::path folder = programFolder();; folder = folder.parent_path()) {
        if (fs::exists(folder / name, ignored)) return (folder / name).lexically_normal();
        if (!folder.has_relative_path()) return name;
    }
}

GoldenPath::GoldenPath(const fs::path& path, std::source_location where)
    : text(path.is_absolute() ? path.string()
                              : (findSourceFile(where.file_name()).parent_path() / path).string()) {
}

}  // namespace rushlight::golden
