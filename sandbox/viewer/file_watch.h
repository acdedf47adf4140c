#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace rushlight {

/// Tells when a file, or any file in or below a folder, was changed, added or removed; by asking
/// for the times of last write four times a second. A change is told when nothing has changed any
/// more for one interval: an editor or an exporter is then done writing.
class FileWatch {
public:
    static constexpr double kInterval = 0.25;  // seconds
    static constexpr size_t kMaxFiles = 4096;  // of a folder; those beyond are not watched

    explicit FileWatch(std::filesystem::path path);

    /// `now` in seconds. True once for each change.
    bool poll(double now);
    /// What is there now is known: no change will be told for it.
    void accept();

private:
    uint64_t fingerprint() const;

    std::filesystem::path path_;
    uint64_t known_ = 0;
    uint64_t seen_ = 0;
    double next_ = 0;
};

}  // namespace rushlight
