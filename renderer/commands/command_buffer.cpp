#include "renderer/commands/command_buffer.h"

namespace rushlight {

BufferRange CommandBuffer::allocate(uint64_t size, uint64_t alignment) {
    const uint64_t offset = (data_.size() + alignment - 1) & ~(alignment - 1);
    data_.resize(offset + size);
    return {{}, 0, offset, size};
}

void CommandBuffer::append(const CommandBuffer& other) {
    RL_CHECK(other.data_.empty(), "only the frame's own command buffer holds data");
    commands_.insert(commands_.end(), other.commands_.begin(), other.commands_.end());
}

void CommandBuffer::assign(std::span<const std::byte> commands, std::span<const std::byte> data) {
    commands_.assign(commands.begin(), commands.end());
    data_.assign(data.begin(), data.end());
}

void CommandBuffer::clear() {
    commands_.clear();
    data_.clear();
}

}  // namespace rushlight
