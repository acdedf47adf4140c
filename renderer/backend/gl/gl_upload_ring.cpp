#include "renderer/backend/gl/gl_upload_ring.h"

#include "renderer/backend/gl/gl_storage.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint64_t kFirstSlotSize = uint64_t(1) << 20;
constexpr GLuint64 kSecond = 1'000'000'000;

}  // namespace

GlUploadRing::GlUploadRing(const GlFunctions& gl, uint32_t slots, uint32_t alignment)
    : gl_(gl), slots_(std::clamp(slots, 1u, kMaxSlots)), alignment_(std::max(alignment, 256u)) {}

GlUploadRing::~GlUploadRing() {
    for (GLsync fence : fences_)
        if (fence) gl_.DeleteSync(fence);
    gl_.DeleteBuffers(1, &buffer_);
}

Result<void> GlUploadRing::allocate(uint64_t slotSize) {
    slotSize = (slotSize + alignment_ - 1) / alignment_ * alignment_;
    const uint64_t size = slotSize * slots_;
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    gl_.CreateBuffers(1, &buffer_);
    if (auto made = makeBufferStorage(gl_, buffer_, "upload ring", size, flags); !made) return made;
    mapped_ = static_cast<std::byte*>(gl_.MapNamedBufferRange(buffer_, 0, GLsizeiptr(size), flags));
    if (!mapped_) return fail("upload ring", "OpenGL cannot map the buffer of the frames' data.");
    slotSize_ = slotSize;
    return {};
}

Result<void> GlUploadRing::replace(uint64_t slotSize) {
    // GL keeps the old buffer's memory until the frames that read it are done.
    if (buffer_) {
        replaced_ = buffer_;
        gl_.DeleteBuffers(1, &buffer_);
    }
    for (GLsync& fence : fences_) {
        if (fence) gl_.DeleteSync(fence);
        fence = nullptr;
    }
    buffer_ = 0;
    mapped_ = nullptr;
    slotSize_ = 0;
    const Result<void> made = allocate(slotSize);
    if (!made && buffer_) gl_.DeleteBuffers(1, &buffer_);
    if (!made) buffer_ = 0;
    return made;
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

Result<void> GlUploadRing::prepare() { return replace(kFirstSlotSize); }

Result<void> GlUploadRing::begin(std::span<const std::byte> data) {
    waits_ = 0;
    slot_ = (slot_ + 1) % slots_;
    if (!mapped_ || data.size() > slotSize_)
        if (auto ok = replace(std::max<uint64_t>(std::bit_ceil(data.size()), kFirstSlotSize)); !ok)
            return ok;
    waitFor(slot_);
    if (!data.empty()) std::memcpy(mapped_ + base(), data.data(), data.size());
    return {};
}

void GlUploadRing::end() { fences_[slot_] = gl_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0); }

GLuint GlUploadRing::takeReplaced() { return std::exchange(replaced_, 0); }

}  // namespace rushlight
