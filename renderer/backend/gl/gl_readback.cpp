#include "renderer/backend/gl/gl_readback.h"

#include "renderer/backend/gl/gl_enums.h"
#include "renderer/backend/gl/gl_storage.h"
#include "renderer/rhi/validate.h"

#include <algorithm>
#include <cstring>

namespace rushlight {
namespace {

constexpr GLuint64 kSecond = 1'000'000'000;

void copyOut(const GlFunctions& gl, const GlTexture& texture, uint32_t layer, uint32_t mipLevel,
             uint64_t size, void* destination) {
    const GlFormat& format = glFormat(texture.format);
    setPixelPacking(gl, 1);
    gl.GetTextureSubImage(texture.name, GLint(mipLevel), 0, 0, GLint(layer),
                          GLsizei(mipSize(texture.width, mipLevel)),
                          GLsizei(mipSize(texture.height, mipLevel)), 1, format.external,
                          format.type, GLsizei(size), destination);
    setPixelPacking(gl, 4);
}

void copyOut(const GlFunctions& gl, GlState& state, const FrameTarget& target, void* destination) {
    state.bindFramebuffer(target.framebuffer);
    setPixelPacking(gl, 1);
    gl.ReadPixels(0, 0, GLsizei(target.width), GLsizei(target.height), GL_RGBA, GL_UNSIGNED_BYTE,
                  destination);
    setPixelPacking(gl, 4);
}

}  // namespace

void setPixelPacking(const GlFunctions& gl, GLint alignment) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, alignment);
    for (GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS,
                        GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_SWAP_BYTES})
        gl.PixelStorei(name, 0);
}

void setPixelUnpacking(const GlFunctions& gl, GLint alignment) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, alignment);
    for (GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
                        GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES})
        gl.PixelStorei(name, 0);
}

GlReadback::~GlReadback() {
    for (const Slot& slot : slots_) {
        if (slot.fence) gl_.DeleteSync(slot.fence);
        gl_.DeleteBuffers(1, &slot.buffer);
    }
}

Result<void> GlReadback::reserve(Slot& slot) {
    if (slot.capacity >= size(slot)) return {};
    if (slot.buffer) gl_.DeleteBuffers(1, &slot.buffer);
    slot.capacity = 0;
    gl_.CreateBuffers(1, &slot.buffer);
    if (auto made = makeBufferStorage(gl_, slot.buffer, "readback", size(slot),
                                      GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
        !made)
        return made;
    slot.capacity = size(slot);
    return {};
}

Result<GlReadback::Slot*> GlReadback::open(uint32_t ticket, Format format, uint32_t width,
                                           uint32_t height) {
    auto found = std::ranges::find(slots_, false, &Slot::used);
    if (found == slots_.end()) found = slots_.insert(slots_.end(), Slot{});
    Slot& slot = *found;
    slot.ticket = ticket;
    slot.format = format;
    slot.width = width;
    slot.height = height;
    if (auto ok = reserve(slot); !ok) return tl::unexpected(ok.error());
    slot.used = true;
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer);
    return &slot;
}

void GlReadback::close(Slot& slot) {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    slot.fence = gl_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

Result<void> GlReadback::copyTexture(uint32_t ticket, const GlTexture& texture, uint32_t layer,
                                     uint32_t mipLevel) {
    RL_CHECK(layer < texture.layers && mipLevel < texture.mipLevels,
             "a readback names a mip level or layer that does not exist");
    const auto slot = open(ticket, texture.format, mipSize(texture.width, mipLevel),
                           mipSize(texture.height, mipLevel));
    if (!slot) return tl::unexpected(slot.error());
    copyOut(gl_, texture, layer, mipLevel, size(**slot), nullptr);
    close(**slot);
    return {};
}

Result<void> GlReadback::copyTarget(uint32_t ticket, GlState& state, const FrameTarget& target) {
    const auto slot = open(ticket, Format::rgba8, target.width, target.height);
    if (!slot) return tl::unexpected(slot.error());
    copyOut(gl_, state, target, nullptr);
    close(**slot);
    return {};
}

bool GlReadback::take(uint32_t ticket, bool wait, ReadbackImage& image) {
    const auto found = std::ranges::find_if(
        slots_, [&](const Slot& slot) { return slot.used && slot.ticket == ticket; });
    if (found == slots_.end()) return false;
    while (gl_.ClientWaitSync(found->fence, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kSecond : 0) ==
           GL_TIMEOUT_EXPIRED)
        if (!wait) return false;
    gl_.DeleteSync(found->fence);
    found->fence = nullptr;
    found->used = false;
    image.format = found->format;
    image.width = found->width;
    image.height = found->height;
    image.bytes.resize(size(*found));
    const void* mapped = gl_.MapNamedBufferRange(found->buffer, 0, GLsizeiptr(size(*found)),
                                                 GL_MAP_READ_BIT);
    if (!mapped) return false;  // no memory, or no context any more
    std::memcpy(image.bytes.data(), mapped, image.bytes.size());
    gl_.UnmapNamedBuffer(found->buffer);
    return true;
}

void GlReadback::read(const GlTexture& texture, uint32_t layer, uint32_t mipLevel,
                      std::span<std::byte> out) {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    copyOut(gl_, texture, layer, mipLevel, out.size(), out.data());
}

ReadbackImage GlReadback::readImage(const GlTexture& texture, uint32_t layer, uint32_t mipLevel) {
    ReadbackImage image{
        texture.format, mipSize(texture.width, mipLevel), mipSize(texture.height, mipLevel), {}};
    image.bytes.resize(size_t(bytesPerTexel(image.format)) * image.width * image.height);
    copyOut(gl_, texture, layer, mipLevel, image.bytes.size(), image.bytes.data());
    return image;
}

ReadbackImage GlReadback::readTarget(GlState& state, const FrameTarget& target) {
    ReadbackImage image{Format::rgba8, target.width, target.height, {}};
    image.bytes.resize(size_t(image.width) * image.height * bytesPerTexel(image.format));
    copyOut(gl_, state, target, image.bytes.data());
    return image;
}

}  // namespace rushlight
