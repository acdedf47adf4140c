#include "engine/core/quoted.h"
#include "renderer/rhi/commands/command_buffer.h"

#include <cstdarg>
#include <cstdio>

namespace rushlight {

const char* toText(CommandType type) {
    switch (type) {
        case CommandType::beginPass: return "BeginPass";
        case CommandType::endPass: return "EndPass";
        case CommandType::setPipeline: return "SetPipeline";
        case CommandType::setViewport: return "SetViewport";
        case CommandType::setScissor: return "SetScissor";
        case CommandType::setVertexStream: return "SetVertexStream";
        case CommandType::setIndexStream: return "SetIndexStream";
        case CommandType::bindUniforms: return "BindUniforms";
        case CommandType::bindTexelBuffer: return "BindTexelBuffer";
        case CommandType::bindTexture: return "BindTexture";
        case CommandType::draw: return "Draw";
        case CommandType::drawIndexed: return "DrawIndexed";
        case CommandType::multiDrawIndexed: return "MultiDrawIndexed";
        case CommandType::readback: return "Readback";
        case CommandType::declareImage: return "DeclareImage";
        case CommandType::count: break;
    }
    return "?";
}

namespace {

class Printer {
public:
    explicit Printer(const ResourceLookup* resources) : resources_(resources) {}
    std::string text;

    template <class Command>
    void number(const Command& command) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "%5u  ", ++number_);
        text += digits;
        (*this)(command);
    }

    void operator()(const BeginPass& c) {
        line("BeginPass %u \"%s\" %ux%u%s", c.passIndex, c.name, c.width, c.height,
             c.toFrameTarget ? " frame-target" : "");
        for (uint32_t i = 0; i < c.colorCount; ++i)
            detail("  color%u texture=%s mip=%u layer=%u %s", i, name(c.colors[i].texture).c_str(),
                   c.colors[i].mipLevel, c.colors[i].layer, loadText(c.colors[i].load));
        if (c.depth.texture)
            detail("  depth texture=%s layer=%u %s%s", name(c.depth.texture).c_str(), c.depth.layer,
                   loadText(c.depth.load), c.depth.readOnly ? " read-only" : "");
    }
    void operator()(const EndPass& c) { line("EndPass %u", c.passIndex); }
    void operator()(const DeclareImage& c) {
        line("  DeclareImage %s \"%s\" texture=%s", c.write ? "write" : "read", c.name,
             name(c.texture).c_str());
    }
    void operator()(const SetPipeline& c) { line("  SetPipeline %s", name(c.pipeline).c_str()); }
    void operator()(const SetViewport& c) {
        line("  SetViewport %d %d %d %d", c.x, c.y, c.width, c.height);
    }
    void operator()(const SetScissor& c) {
        line("  SetScissor %d %d %d %d", c.x, c.y, c.width, c.height);
    }
    void operator()(const SetVertexStream& c) {
        line("  SetVertexStream %u stride=%u %s", c.slot, c.stride, rangeText(c.range).c_str());
    }
    void operator()(const SetIndexStream& c) {
        line("  SetIndexStream %s", rangeText(c.range).c_str());
    }
    void operator()(const BindUniforms& c) {
        line("  BindUniforms %u %s", c.slot, rangeText(c.range).c_str());
    }
    void operator()(const BindTexelBuffer& c) {
        line("  BindTexelBuffer %u %s %s", c.slot, toText(c.format), rangeText(c.range).c_str());
    }
    void operator()(const BindTexture& c) {
        line("  BindTexture %u texture=%s sampler=%s", c.slot, name(c.texture).c_str(),
             value(c.sampler.value).c_str());
    }
    void operator()(const Draw& c) {
        line("  Draw vertices=%u instances=%u first=%u", c.vertexCount, c.instanceCount,
             c.firstVertex);
    }
    void operator()(const DrawIndexed& c) {
        line("  DrawIndexed indices=%u instances=%u firstIndex=%u baseVertex=%d baseInstance=%u",
             c.command.indexCount, c.command.instanceCount, c.command.firstIndex,
             c.command.baseVertex, c.command.baseInstance);
    }
    void operator()(const MultiDrawIndexed& c) {
        line("  MultiDrawIndexed draws=%u triangles=%u %s", c.drawCount, c.triangleCount,
             rangeText(c.commands).c_str());
    }
    void operator()(const Readback& c) {
        line("Readback ticket=%u texture=%s layer=%u mip=%u", c.ticket, name(c.texture).c_str(),
             c.layer, c.mipLevel);
    }

private:
    static const char* loadText(LoadOp op) {
        return op == LoadOp::keep ? "keep" : op == LoadOp::clear ? "clear" : "discard";
    }
    std::string value(uint32_t handle) const {
        char digits[16];
        std::snprintf(digits, sizeof digits, resources_ ? "%u" : "%08x", handle);
        return digits;
    }
    template <class AnyHandle>
    std::string name(AnyHandle handle) const {
        std::string out = value(handle.value);
        if (!resources_ || !handle) return out;
        const auto found = resources_->describe(handle);
        return found ? out + " " + quoted(found->label) : out + " (unknown)";
    }
    std::string rangeText(const BufferRange& r) const {
        const std::string buffer = resources_ && !r.buffer ? "data" : name(r.buffer);
        return "buffer=" + buffer + " offset=" + std::to_string(r.offset) +
               " size=" + std::to_string(r.size);
    }
    [[gnu::format(printf, 2, 3)]] void line(const char* format, ...) {
        va_list arguments;
        va_start(arguments, format);
        add(format, arguments);
        va_end(arguments);
    }
    /// A further line of the same command.
    [[gnu::format(printf, 2, 3)]] void detail(const char* format, ...) {
        if (number_) text += "       ";
        va_list arguments;
        va_start(arguments, format);
        add(format, arguments);
        va_end(arguments);
    }
    void add(const char* format, va_list arguments) {
        char buffer[512];
        std::vsnprintf(buffer, sizeof buffer, format, arguments);
        text += buffer;
        text += '\n';
    }

    const ResourceLookup* resources_;
    uint32_t number_ = 0;
};

}  // namespace

std::string print(const CommandBuffer& buffer) {
    Printer printer(nullptr);
    visitCommands(buffer, printer);
    return std::move(printer.text);
}

std::string printNumbered(const CommandBuffer& buffer, const ResourceLookup& resources) {
    Printer printer(&resources);
    visitCommands(buffer, [&](const auto& command) { printer.number(command); });
    return std::move(printer.text);
}

}  // namespace rushlight
