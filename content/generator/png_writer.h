#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace rushlight::content {

/// 8 bits a channel, rows from the top. `channels` is 1, 3 or 4.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<uint8_t> bytes;
};

/// A PNG without any ancillary chunk. The same picture gives the same bytes everywhere.
std::vector<uint8_t> encodePng(const Picture& picture);

/// Writes a whole file; ends the program with a message when it cannot.
void writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes);

}  // namespace rushlight::content
