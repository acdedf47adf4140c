#pragma once
// The fields of every command, once, by name: what compares and translates commands walks these.

#include "renderer/rhi/commands/commands.h"

namespace rushlight {

// `visit(name, field)` for each field that has a meaning; `field` is const where the command is. A
// BufferRange is visited as its three fields.

template <class Command, class F>
void visitRange(Command& range, F&& visit) {
    visit("buffer", range.buffer);
    visit("offset", range.offset);
    visit("size", range.size);
}

/// A command or a const command, of type `Kind`.
template <class Command, class Kind>
concept IsCommand = std::is_same_v<std::remove_const_t<Command>, Kind>;

template <class C, class F>
void visitFields(C& c, F&& visit) {
    if constexpr (IsCommand<C, BeginPass>) {
        visit("name", c.name);
        visit("passIndex", c.passIndex);
        visit("colorCount", c.colorCount);
        visit("toFrameTarget", c.toFrameTarget);
        visit("width", c.width);
        visit("height", c.height);
        for (auto& color : c.colors) {
            visit("color texture", color.texture);
            visit("color mipLevel", color.mipLevel);
            visit("color layer", color.layer);
            visit("color load", color.load);
            for (int i = 0; i < 4; ++i) visit("color clear", color.clear[i]);
        }
        visit("depth texture", c.depth.texture);
        visit("depth layer", c.depth.layer);
        visit("depth load", c.depth.load);
        visit("depth readOnly", c.depth.readOnly);
        visit("depth clear", c.depth.clear);
    } else if constexpr (IsCommand<C, EndPass>) {
        visit("passIndex", c.passIndex);
    } else if constexpr (IsCommand<C, DeclareImage>) {
        visit("texture", c.texture);
        visit("write", c.write);
        visit("name", c.name);
    } else if constexpr (IsCommand<C, SetPipeline>) {
        visit("pipeline", c.pipeline);
    } else if constexpr (IsCommand<C, SetViewport> || IsCommand<C, SetScissor>) {
        visit("x", c.x);
        visit("y", c.y);
        visit("width", c.width);
        visit("height", c.height);
    } else if constexpr (IsCommand<C, SetVertexStream>) {
        visit("slot", c.slot);
        visit("stride", c.stride);
        visitRange(c.range, visit);
    } else if constexpr (IsCommand<C, SetIndexStream>) {
        visitRange(c.range, visit);
    } else if constexpr (IsCommand<C, BindUniforms>) {
        visit("slot", c.slot);
        visitRange(c.range, visit);
    } else if constexpr (IsCommand<C, BindTexelBuffer>) {
        visit("slot", c.slot);
        visit("format", c.format);
        visitRange(c.range, visit);
    } else if constexpr (IsCommand<C, BindTexture>) {
        visit("slot", c.slot);
        visit("texture", c.texture);
        visit("sampler", c.sampler);
    } else if constexpr (IsCommand<C, Draw>) {
        visit("vertexCount", c.vertexCount);
        visit("instanceCount", c.instanceCount);
        visit("firstVertex", c.firstVertex);
    } else if constexpr (IsCommand<C, DrawIndexed>) {
        visit("indexCount", c.command.indexCount);
        visit("instanceCount", c.command.instanceCount);
        visit("firstIndex", c.command.firstIndex);
        visit("baseVertex", c.command.baseVertex);
        visit("baseInstance", c.command.baseInstance);
    } else if constexpr (IsCommand<C, MultiDrawIndexed>) {
        visit("drawCount", c.drawCount);
        visit("triangleCount", c.triangleCount);
        visitRange(c.commands, visit);
    } else {
        static_assert(IsCommand<C, Readback>);
        visit("texture", c.texture);
        visit("layer", c.layer);
        visit("mipLevel", c.mipLevel);
        visit("ticket", c.ticket);
    }
}

template <class T>
inline constexpr bool isHandle = false;
template <class Tag>
inline constexpr bool isHandle<Handle<Tag>> = true;

}  // namespace rushlight
