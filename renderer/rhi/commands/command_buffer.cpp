#include "renderer/rhi/commands/command_buffer.h"

#include <algorithm>

namespace rushlight {

BufferRange CommandBuffer::allocate(uint64_t size, uint64_t alignment) {
    const uint64_t offset = (dataSize_ + alignment - 1) & ~(alignment - 1);
    if (offset + size > data_.size()) data_.resize(std::max(offset + size, 2 * data_.size()));
    std::fill(data_.begin() + ptrdiff_t(dataSize_), data_.begin() + ptrdiff_t(offset), std::byte{});
    dataSize_ = offset + size;
    return {{}, 0, offset, size};
}

void CommandBuffer::append(const CommandBuffer& other) {
    RL_CHECK(other.dataSize_ == 0, "only the frame's own command buffer holds data");
    commands_.insert(commands_.end(), other.commands_.begin(), other.commands_.end());
}

void CommandBuffer::assign(std::span<const std::byte> commands, std::span<const std::byte> data) {
    commands_.assign(commands.begin(), commands.end());
    data_.assign(data.begin(), data.end());
    dataSize_ = data.size();
}

void CommandBuffer::clear() {
    commands_.clear();
    dataSize_ = 0;
}

}  // namespace rushlight
