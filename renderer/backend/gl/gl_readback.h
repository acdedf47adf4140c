#pragma once
// Pixels on their way back: a pixel buffer and a fence a ticket, so that nobody has to wait for
// them.

#include "renderer/backend/gl/gl_resources.h"
#include "renderer/rhi/device.h"

#include <vector>

namespace rushlight {

class GlReadback {
public:
    explicit GlReadback(const GlFunctions& gl) : gl_(gl) {}
    ~GlReadback();

    // An Error where there is no memory to copy to: then nothing comes back under that ticket.
    Result<void> copyTexture(uint32_t ticket, const GlTexture& texture, uint32_t layer,
                             uint32_t mipLevel);
    Result<void> copyTarget(uint32_t ticket, GlState& state, const FrameTarget& target);
    bool take(uint32_t ticket, bool wait, ReadbackImage& image);

    // At once, waiting: what an image holds.
    void read(const GlTexture& texture, uint32_t layer, uint32_t mipLevel,
              std::span<std::byte> out);
    ReadbackImage readImage(const GlTexture& texture, uint32_t layer, uint32_t mipLevel);
    ReadbackImage readTarget(GlState& state, const FrameTarget& target);

private:
    struct Slot {
        uint32_t ticket = 0;
        bool used = false;
        GLuint buffer = 0;
        uint64_t capacity = 0;
        GLsync fence = nullptr;
        Format format = Format::none;
        uint32_t width = 0, height = 0;
    };
    Result<Slot*> open(uint32_t ticket, Format format, uint32_t width, uint32_t height);
    Result<void> reserve(Slot& slot);
    void close(Slot& slot);
    uint64_t size(const Slot& slot) const {
        return uint64_t(bytesPerTexel(slot.format)) * slot.width * slot.height;
    }

    const GlFunctions& gl_;
    std::vector<Slot> slots_;
};

/// Rows of any width, tightly packed, whatever the host has set. 4 is GL's default.
void setPixelPacking(const GlFunctions& gl, GLint alignment);
void setPixelUnpacking(const GlFunctions& gl, GLint alignment);

}  // namespace rushlight
