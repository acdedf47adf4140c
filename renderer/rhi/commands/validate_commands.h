#pragma once
// Checks a frame's commands before anybody executes them.

#include "engine/core/result.h"
#include "renderer/rhi/commands/command_buffer.h"

#include <array>
#include <vector>

namespace rushlight {

enum class ValidationRules : uint8_t {
    /// What can go beyond an object or name one that is not there: what a device must never be
    /// given.
    memory,
    /// Also what a pass promises: it samples nothing of this frame that it did not declare, and
    /// writes its targets only.
    all,
};

/// The rules:
///   - passes begin and end in turn, their indices are below their number; draws and bindings are
///   in a pass, copies are
///     outside; a draw has a pipeline and, if it is to be seen, a target;
///   - every handle, range, slot, layer and mip level is there;
///   - colour targets have colour formats, the depth target a depth format, integer targets are
///   cleared to integers,
///     texel buffers have formats that can be, comparing samplers go with depth, filtering ones not
///     with integers;
///   - what a draw reads was bound in its own pass: streams of the pipeline's layout, its program's
///   uniform blocks,
///     textures and texel buffers, where ResourceLookup::slots knows them; as large as needed, and
///     of the kind;
///   - indirect draws stay inside of the index buffer and the instances, and no index names a
///   vertex that is not there;
///     both where ResourceLookup::contents knows the bytes, draws in the data block always;
///   - all: a texture that a pass of this buffer writes is sampled only where declared
///   (DeclareImage), never while it
///     is a target; a read-only depth target is not written, and what is written is declared.
class CommandValidator {
public:
    static constexpr size_t kMostFaults = 16;

    /// What is wrong: `object` names pass and command (numbered from 1), the message the objects by
    /// their labels. ErrorKind::wrongUse. The result lives until the next call; where all is well
    /// nothing is allocated once warm.
    const std::vector<Error>& validate(const CommandBuffer& commands,
                                       const ResourceLookup& resources,
                                       ValidationRules rules = ValidationRules::all);

private:
    friend class CommandChecker;
    std::vector<Error> faults_;
    std::vector<TextureHandle> writtenByFrame_;
    std::vector<DeclareImage> declared_;  ///< by the current pass
};

}  // namespace rushlight
