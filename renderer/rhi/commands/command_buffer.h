#pragma once

#include "engine/core/check.h"
#include "renderer/rhi/commands/commands.h"
#include "renderer/rhi/resource_lookup.h"

#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace rushlight {

/// A frame's commands and the data block they refer to. Clearing keeps the memory.
/// Not thread-safe: one per recording thread, appended in order.
class CommandBuffer {
public:
    /// Appends a command.
    template <class Command>
    void push(const Command& command) {
        static_assert(std::is_trivially_copyable_v<Command> && alignof(Command) <= 8);
        constexpr size_t size = sizeof(Header) + padded(sizeof(Command));
        const size_t at = commands_.size();
        commands_.resize(at + size);
        const Header header{Command::kType, uint16_t(0), uint32_t(padded(sizeof(Command)))};
        std::memcpy(commands_.data() + at, &header, sizeof header);
        std::memcpy(commands_.data() + at + sizeof header, &command, sizeof command);
    }

    /// Reserves `size` bytes of the data block, aligned to `alignment` (a power of two), all of
    /// which are to be written: they may hold what an earlier frame left. Gaps are zero. Spans are
    /// good until the next allocation, offsets until clear().
    BufferRange allocate(uint64_t size, uint64_t alignment = 256);
    std::span<std::byte> bytes(const BufferRange& range) {
        RL_CHECK(!range.buffer && range.offset + range.size <= dataSize_,
                 "the range is not of this command buffer's data block");
        return {data_.data() + range.offset, size_t(range.size)};
    }

    template <class T>
    BufferRange append(std::span<const T> items, uint64_t alignment = 256) {
        const BufferRange range = allocate(items.size_bytes(), alignment);
        if (range.size) std::memcpy(data_.data() + range.offset, items.data(), range.size);
        return range;
    }

    /// Appends the commands of a buffer that has no data of its own.
    void append(const CommandBuffer& other);
    void clear();

    /// Takes over commands that came from outside; checkCommandStream must have found them well
    /// formed.
    void assign(std::span<const std::byte> commands, std::span<const std::byte> data);

    std::span<const std::byte> commandBytes() const { return commands_; }
    std::span<const std::byte> data() const { return std::span(data_).first(dataSize_); }

    struct Header {
        CommandType type;
        uint16_t reserved;
        uint32_t size;  ///< of the payload, a multiple of 8
    };
    static constexpr size_t padded(size_t size) { return (size + 7) & ~size_t(7); }

private:
    std::vector<std::byte> commands_;
    std::vector<std::byte> data_;  // as long as it ever was: growing would set every byte first
    size_t dataSize_ = 0;
};

/// Calls `visit(const CommandStruct&)` for every command in order; `visit` is a generic lambda or
/// overload set.
template <class Visitor>
void visitCommands(const CommandBuffer& buffer, Visitor&& visit) {
    const std::span<const std::byte> bytes = buffer.commandBytes();
    size_t at = 0;
    const auto call = [&]<class Command>(const Command*) {
        // Payloads are 8-byte aligned in the arena.
        visit(*reinterpret_cast<const Command*>(bytes.data() + at));
    };
    while (at < bytes.size()) {
        CommandBuffer::Header header;
        std::memcpy(&header, bytes.data() + at, sizeof header);
        at += sizeof header;
        switch (header.type) {
            case CommandType::beginPass: call((const BeginPass*)nullptr); break;
            case CommandType::endPass: call((const EndPass*)nullptr); break;
            case CommandType::setPipeline: call((const SetPipeline*)nullptr); break;
            case CommandType::setViewport: call((const SetViewport*)nullptr); break;
            case CommandType::setScissor: call((const SetScissor*)nullptr); break;
            case CommandType::setVertexStream: call((const SetVertexStream*)nullptr); break;
            case CommandType::setIndexStream: call((const SetIndexStream*)nullptr); break;
            case CommandType::bindUniforms: call((const BindUniforms*)nullptr); break;
            case CommandType::bindTexelBuffer: call((const BindTexelBuffer*)nullptr); break;
            case CommandType::bindTexture: call((const BindTexture*)nullptr); break;
            case CommandType::draw: call((const Draw*)nullptr); break;
            case CommandType::drawIndexed: call((const DrawIndexed*)nullptr); break;
            case CommandType::multiDrawIndexed: call((const MultiDrawIndexed*)nullptr); break;
            case CommandType::readback: call((const Readback*)nullptr); break;
            case CommandType::declareImage: call((const DeclareImage*)nullptr); break;
            case CommandType::count: RL_CHECK(false, "a command has no type"); break;
        }
        at += header.size;
    }
}

/// The commands as text, one a line, for people and for diff.
std::string print(const CommandBuffer& buffer);

/// As print, with the number of each command, from 1, and what `resources` knows of the objects in
/// place of handles.
std::string printNumbered(const CommandBuffer& buffer, const ResourceLookup& resources);

}  // namespace rushlight
