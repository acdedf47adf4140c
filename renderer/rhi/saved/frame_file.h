#pragma once
// RLF: a SavedFrame in a file. Little endian, nothing between the parts, so that equal frames are
// equal files.
//
//     header, 48 bytes
//      0  char[8]  'R' 'L' 'F' 0x0d 0x0a 0x1a 0x0a 0x00: what is sent as text is seen to be broken,
//      as with PNG 8  u32      version, raised when a command or what follows changes
//     12  u32      0
//     16  u64      bytes of the file
//     24  u64      bytes of the description
//     32  hash     of the description
//     description
//         u32 width, height, flags (1: FrameTarget::topRowFirst); u32 commands, data: numbers of
//         blobs u32 count, blobs:      hash, u64 bytes each content once u32 count, buffers: text
//         label; u64 size; u8 usage; u32 contents u32 count, textures:   text label; u8 kind,
//         format; u32 width, height, layers, mipLevels;
//                                u32 contents[mipLevels][layers]
//         u32 count, samplers:   u8 wrapU, wrapV, magnify, minify, mipmap, useMipmaps,
//         compareGreaterEqual;
//                                f32 maxAnisotropy
//         u32 count, pipelines:  text label, vertexShader, fragmentShader; u32 vertexSource,
//         fragmentSource;
//                                u8 layout, movingInstances, cull, depthClamp, depthTest,
//                                depthWrite, blend, lines; f32 depthBias, depthBiasSlope
//     blobs, in the order of their table
//
//     text   u32 bytes, the bytes      contents, sources, commands, data   numbers of blobs, from
//     1; 0: none hash   two u64 of hash128
//
// Commands are as CommandBuffer holds them, with numbers in place of handles (SavedFrame).

#include "engine/core/result.h"
#include "renderer/rhi/saved/saved_frame.h"

namespace rushlight {

/// The bytes of a file. The same frame gives the same bytes.
std::vector<std::byte> encodeFrame(const SavedFrame& frame);

/// The frame in `file`; `name` is for messages. Everything is checked before it is used, hashes
/// included: what comes back can be listed, compared and executed. A file that is no frame, cut
/// short or damaged is an Error that says where.
Result<SavedFrame> decodeFrame(std::vector<std::byte> file, const std::string& name);

}  // namespace rushlight
