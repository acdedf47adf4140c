#include "sandbox/viewer/file_watch.h"

#include "engine/core/hash.h"

#include <system_error>
#include <utility>

namespace rushlight {
namespace fs = std::filesystem;
namespace {

/// Of one file: its name, its size and the time of its last write.
uint64_t fingerprintOf(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (error) return 0;
    const uintmax_t size = fs::file_size(file, error);
    const int64_t ticks = time.time_since_epoch().count();
    return hashText(file.native(), mixBits(uint64_t(ticks)) ^ mixBits(error ? 0 : size));
}

}  // namespace

FileWatch::FileWatch(fs::path path) : path_(std::move(path)) { accept(); }

void FileWatch::accept() { known_ = seen_ = fingerprint(); }

/// A sum, so that the order in which the folder lists its files does not matter.
uint64_t FileWatch::fingerprint() const {
    std::error_code error;
    if (!fs::is_directory(path_, error)) return fingerprintOf(path_);
    uint64_t sum = 0;
    size_t files = 0;
    const auto options = fs::directory_options::skip_permission_denied;
    fs::recursive_directory_iterator at(path_, options, error), end;
    for (; !error && at != end && files < kMaxFiles; at.increment(error)) {
        std::error_code ignored;
        if (!at->is_regular_file(ignored)) continue;
        sum += fingerprintOf(at->path());
        ++files;
    }
    return sum;
}

bool FileWatch::poll(double now) {
    if (now < next_) return false;
    next_ = now + kInterval;
    const uint64_t current = fingerprint();
    const bool settled = current == seen_;
    seen_ = current;
    if (!settled || current == known_) return false;
    known_ = current;
    return true;
}

}  // namespace rushlight
