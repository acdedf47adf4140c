#pragma once
// The frames' data blocks: one persistently mapped coherent buffer with a slot for each frame in
// flight.

#include "engine/core/check.h"
#include "renderer/backend/gl/gl_functions.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace rushlight {

class GlUploadRing {
public:
    static constexpr uint32_t kMaxSlots = 3;

    /// `alignment`: what uniform and texel buffer offsets must be multiples of.
    GlUploadRing(const GlFunctions& gl, uint32_t slots, uint32_t alignment);
    ~GlUploadRing();

    /// Makes the buffer, once, before the first frame.
    Result<void> prepare();
    /// Copies a frame's data to the next slot, waiting for the frame that used it last. A block
    /// larger than a slot makes a larger buffer; see takeReplaced(). An Error where that cannot be
    /// had: the frame has no data then, and the next one tries again.
    Result<void> begin(std::span<const std::byte> data);
    /// All commands that read the slot were submitted.
    void end();

    GLuint buffer() const { return buffer_; }
    GLintptr base() const { return GLintptr(slot_ * slotSize_); }
    uint32_t waits() const { return waits_; }  ///< of the last begin
    GLuint takeReplaced();  ///< the buffer that begin() deleted, once; 0 when none

private:
    Result<void> replace(uint64_t slotSize);
    Result<void> allocate(uint64_t slotSize);
    void waitFor(uint32_t slot);

    const GlFunctions& gl_;
    uint32_t slots_;
    uint64_t alignment_;
    uint64_t slotSize_ = 0;
    GLuint buffer_ = 0;
    GLuint replaced_ = 0;
    std::byte* mapped_ = nullptr;
    uint32_t slot_ = 0;
    uint32_t waits_ = 0;
    std::array<GLsync, kMaxSlots> fences_{};
};

}  // namespace rushlight
