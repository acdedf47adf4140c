#pragma once
// What else a host asks of a frame than how it looks.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rushlight {

struct FrameOptions {
    bool hashPasses = false;  ///< fill PassReport::hashes; slow
    bool keepImages = false;  ///< fill PassImage::texels of the report; slow
    /// Not 0: passes are executed in another order that their accesses allow. The same pixels; for
    /// tests of what passes declare.
    uint64_t passOrderSeed = 0;
    bool timers = true;  ///< GPU timer queries around each pass
    /// Gets the frame as an RLF file (renderer/rhi/saved/frame_file.h) before it is executed; slow.
    std::vector<std::byte>* savedFrame = nullptr;
};

}  // namespace rushlight
