#pragma once
// What the reader and the writer of RLF files share.

#include "renderer/rhi/commands/commands.h"

#include <array>

namespace rushlight::rlf {

inline constexpr std::array<char, 8> kMagic = {'R', 'L', 'F', '\r', '\n', '\x1a', '\n', '\0'};
inline constexpr uint32_t kVersion = 1;
inline constexpr uint64_t kHeaderBytes = 48;
inline constexpr uint32_t kTopRowFirst = 1;

// The file holds commands as they are in memory: when one of these fails, raise kVersion.
static_assert(sizeof(BeginPass) == 176 && sizeof(EndPass) == 4 && sizeof(DeclareImage) == 48);
static_assert(sizeof(SetPipeline) == 4 && sizeof(SetViewport) == 16 && sizeof(SetScissor) == 16);
static_assert(sizeof(SetVertexStream) == 32 && sizeof(SetIndexStream) == 24);
static_assert(sizeof(BindUniforms) == 32 && sizeof(BindTexelBuffer) == 32);
static_assert(sizeof(BindTexture) == 12 && sizeof(Draw) == 12 && sizeof(DrawIndexed) == 20);
static_assert(sizeof(MultiDrawIndexed) == 32 && sizeof(Readback) == 16);
static_assert(uint32_t(CommandType::count) == 15);

}  // namespace rushlight::rlf
