#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// The highest of any run of indices, in a time that does not grow with the run: a file may ask for
/// as many and as long ones as it likes.
class IndexBounds {
public:
    IndexBounds() = default;
    /// Of uint32 indices at any alignment, which are not copied; bytes after the last whole one are
    /// left out.
    explicit IndexBounds(std::span<const std::byte> indices);

    /// Of `count` indices, at least one, all of which are there.
    uint32_t highest(size_t first, size_t count) const;

private:
    uint32_t scan(size_t first, size_t end) const;

    std::span<const std::byte> indices_;
    /// [k][b]: of 2^k whole blocks from block b on.
    std::vector<std::vector<uint32_t>> blocks_;
};

}  // namespace rushlight
