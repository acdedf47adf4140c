#include "renderer/rhi/commands/command_stream.h"

#include <array>

namespace rushlight {
namespace {

/// By CommandType.
constexpr std::array<uint32_t, size_t(CommandType::count)> kSizes = [] {
    std::array<uint32_t, size_t(CommandType::count)> sizes{};
    const auto set = [&]<class... Command>(const Command*...) {
        ((sizes[size_t(Command::kType)] = uint32_t(CommandBuffer::padded(sizeof(Command)))), ...);
    };
    set((const BeginPass*)nullptr, (const EndPass*)nullptr, (const SetPipeline*)nullptr,
        (const SetViewport*)nullptr, (const SetScissor*)nullptr, (const SetVertexStream*)nullptr,
        (const SetIndexStream*)nullptr, (const BindUniforms*)nullptr,
        (const BindTexelBuffer*)nullptr, (const BindTexture*)nullptr, (const Draw*)nullptr,
        (const DrawIndexed*)nullptr, (const MultiDrawIndexed*)nullptr, (const Readback*)nullptr,
        (const DeclareImage*)nullptr);
    return sizes;
}();

/// Empty when every enumeration, name and count of a command is one that there is.
struct FieldCheck {
    std::string fault;

    template <class Field>
    void operator()(const char* name, const Field& field) {
        if constexpr (std::is_same_v<Field, LoadOp>)
            limit(name, uint32_t(field), uint32_t(LoadOp::discard));
        else if constexpr (std::is_same_v<Field, Format>)
            limit(name, uint32_t(field), uint32_t(Format::depth16));
        else if constexpr (std::is_array_v<Field>) {
            bool ends = false;
            for (const char c : field) ends |= c == '\0';
            if (!ends) fault = std::string("its ") + name + " has no end";
        }
    }
    void limit(const char* name, uint32_t value, uint32_t highest) {
        if (value > highest)
            fault = std::string("its ") + name + " is " + std::to_string(value) + ", over " +
                    std::to_string(highest);
    }
};

template <class Command>
std::string faultOf(const Command& command) {
    FieldCheck check;
    visitFields(command, check);
    if constexpr (std::is_same_v<Command, BeginPass>) {
        check.limit("colorCount", command.colorCount, kMaxColorAttachments);
        check.limit("toFrameTarget", command.toFrameTarget, 1);
        check.limit("depth readOnly", command.depth.readOnly, 1);
    }
    if constexpr (std::is_same_v<Command, DeclareImage>) check.limit("write", command.write, 1);
    return check.fault;
}

}  // namespace

Result<void> checkCommandStream(std::span<const std::byte> bytes, const std::string& object) {
    uint32_t number = 0;
    const auto refuse = [&](const std::string& what) {
        return fail(object, "Command " + std::to_string(number) + " is wrong: " + what + ".");
    };
    for (size_t at = 0; at < bytes.size();) {
        ++number;
        CommandBuffer::Header header;
        if (bytes.size() - at < sizeof header) return refuse("it ends in its header");
        std::memcpy(&header, bytes.data() + at, sizeof header);
        at += sizeof header;
        if (header.type >= CommandType::count)
            return refuse("its type " + std::to_string(uint32_t(header.type)) + " is unknown");
        if (header.size != kSizes[size_t(header.type)] || header.reserved != 0)
            return refuse(std::string("a ") + toText(header.type) + " has " +
                          std::to_string(kSizes[size_t(header.type)]) + " bytes, not " +
                          std::to_string(header.size));
        if (bytes.size() - at < header.size) return refuse("it is cut off");
        at += header.size;
    }
    // Every command is whole now, so that the visitor can be trusted with a copy, which is aligned.
    CommandBuffer whole;
    whole.assign(bytes, {});
    number = 0;
    std::string fault;
    visitCommands(whole, [&](const auto& command) {
        if (!fault.empty()) return;
        ++number;
        fault = faultOf(command);
    });
    if (fault.empty()) return {};
    return refuse(fault);
}

}  // namespace rushlight
