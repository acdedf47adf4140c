#include "renderer/commands/command_buffer.h"

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
        case CommandType::count: break;
    }
    return "?";
}

namespace {

class Printer {
public:
    std::string text;

    void operator()(const BeginPass& c) {
        line("BeginPass %u \"%s\" %ux%u%s", c.passIndex, c.name, c.width, c.height,
             c.toFrameTarget ? " frame-target" : "");
        for (uint32_t i = 0; i < c.colorCount; ++i)
            line("  color%u texture=%08x mip=%u layer=%u %s", i, c.colors[i].texture.value,
                 c.colors[i].mipLevel, c.colors[i].layer, loadText(c.colors[i].load));
        if (c.depth.texture)
            line("  depth texture=%08x layer=%u %s", c.depth.texture.value, c.depth.layer,
                 loadText(c.depth.load));
    }
    void operator()(const EndPass& c) { line("EndPass %u", c.passIndex); }
    void operator()(const SetPipeline& c) { line("  SetPipeline %08x", c.pipeline.value); }
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
        line("  BindTexture %u texture=%08x sampler=%08x", c.slot, c.texture.value,
             c.sampler.value);
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
        line("Readback ticket=%u texture=%08x layer=%u mip=%u", c.ticket, c.texture.value, c.layer,
             c.mipLevel);
    }

private:
    static const char* loadText(LoadOp op) {
        return op == LoadOp::keep ? "keep" : op == LoadOp::clear ? "clear" : "discard";
    }
    static std::string rangeText(const BufferRange& r) {
        char text[80];
        std::snprintf(text, sizeof text, "buffer=%08x offset=%llu size=%llu", r.buffer.value,
                      (unsigned long long)r.offset, (unsigned long long)r.size);
        return text;
    }
    [[gnu::format(printf, 2, 3)]] void line(const char* format, ...) {
        char buffer[256];
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(buffer, sizeof buffer, format, arguments);
        va_end(arguments);
        text += buffer;
        text += '\n';
    }
};

}  // namespace

std::string print(const CommandBuffer& buffer) {
    Printer printer;
    visitCommands(buffer, printer);
    return std::move(printer.text);
}

}  // namespace rushlight
