#include "renderer/capture/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

std::string reasonOf(int error) { return std::generic_category().message(error); }

tl::unexpected<Error> cannotWrite(const std::string& path, int error) {
    return fail(path, "The file could not be written (" + reasonOf(error) +
                          "); what was there before is untouched.");
}

/// 0 or errno.
int writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes = bytes.subspan(size_t(written));
    }
    return 0;
}

/// 0 or errno. Network file systems report a full disk when the file is closed.
int writeTo(const std::string& path, int flags, std::span<const std::byte> bytes) {
    const int file = open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    const int error = writeAll(file, bytes);
    if (close(file) != 0 && error == 0) return errno;
    return error;
}

}  // namespace

Result<void> writeFile(const std::string& path, std::span<const std::byte> bytes) {
    std::error_code ignored;
    const fs::path target = fs::weakly_canonical(path, ignored);
    if (target.empty()) return fail(path, "This is not a path that a file can have.");
    const fs::file_status status = fs::status(target, ignored);
    if (fs::is_directory(status)) return fail(path, "This is a folder; name a file in it.");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (const int error = writeTo(target, 0, bytes)) return cannotWrite(path, error);
        return {};
    }

    fs::create_directories(target.parent_path(), ignored);
    const std::string temporary = target.string() + ".part-" + std::to_string(getpid());
    int error = writeTo(temporary, O_CREAT | O_TRUNC, bytes);
    if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error == 0) return {};
    unlink(temporary.c_str());
    return cannotWrite(path, error);
}

Result<void> writeFile(const std::string& path, std::string_view text) {
    return writeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace rushlight
