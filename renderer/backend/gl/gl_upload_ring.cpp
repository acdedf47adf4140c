#include "renderer/backend/gl/gl_upload_ring.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint64_t kFirstSlotSize = uint64_t(1) << 20;
constexpr GLuint64 kSecond = 1'000'000'000;

}  // namespace

GlUploadRing::GlUploadRing(const GlFunctions& gl, uint32_t slots, uint32_t alignment)
    : gl_(gl), slots_(std::clamp(slots, 1u, kMaxSlots)), alignment_(std::max(alignment, 256u)) {
    allocate(kFirstSlotSize);
}

GlUploadRing::~GlUploadRing() {
    for (GLsync fence : fences_)
        if (fence) gl_.DeleteSync(fence);
    gl_.DeleteBuffers(1, &buffer_);
}

void GlUploadRing::allocate(uint64_t slotSize) {
    slotSize_ = (slotSize + alignment_ - 1) / alignment_ * alignment_;
    const GLsizeiptr size = GLsizeiptr(slotSize_ * slots_);
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    gl_.CreateBuffers(1, &buffer_);
    gl_.NamedBufferStorage(buffer_, size, nullptr, flags);
    gl_.label(GL_BUFFER, buffer_, "upload ring");
    mapped_ = static_cast<std::byte*>(gl_.MapNamedBufferRange(buffer_, 0, size, flags));
    RL_CHECK(mapped_ || gl_.resetStatus() != GL_NO_ERROR, "the driver cannot map the upload ring");
}

void GlUploadRing::waitFor(uint32_t slot) {
    GLsync& fence = fences_[slot];
    if (!fence) return;
    if (gl_.ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) {
        ++waits_;
        while (gl_.ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kSecond) ==
               GL_TIMEOUT_EXPIRED) {
        }
    }
    gl_.DeleteSync(fence);
    fence = nullptr;
}

void GlUploadRing::begin(std::span<const std::byte> data) {
    waits_ = 0;
    slot_ = (slot_ + 1) % slots_;
    if (data.size() > slotSize_) {
        // GL keeps the old buffer's memory until the frames that read it are done.
        replaced_ = buffer_;
        gl_.DeleteBuffers(1, &buffer_);
        for (GLsync& fence : fences_) {
            if (fence) gl_.DeleteSync(fence);
            fence = nullptr;
        }
        allocate(std::bit_ceil(data.size()));
    }
    waitFor(slot_);
    if (!data.empty() && mapped_) std::memcpy(mapped_ + base(), data.data(), data.size());
}

void GlUploadRing::end() { fences_[slot_] = gl_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0); }

GLuint GlUploadRing::takeReplaced() { return std::exchange(replaced_, 0); }

}  // namespace rushlight
