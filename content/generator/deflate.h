#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight::content {

/// A zlib stream (RFC 1950, 1951) of Huffman-coded literals and runs of one byte. Filtered rows of
/// natural textures hold few longer repeats, so that a full search would gain little; in return the
/// bytes depend on no library's version.
std::vector<uint8_t> zlibCompress(std::span<const uint8_t> data);

}  // namespace rushlight::content
