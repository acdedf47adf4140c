// What CommandValidator asks of draws.

#include "renderer/rhi/commands/command_checker.h"
#include "shaders/interop/bindings.h"

#include <algorithm>

namespace rushlight {
namespace {

/// By stream slot.
std::array<uint32_t, kVertexStreams> bytesRead(const PipelineDesc& desc) {
    std::array<uint32_t, kVertexStreams> bytes{};
    const uint32_t instance = desc.movingInstances ? sizeof(MovingInstanceData)
                                                   : sizeof(InstanceData);
    switch (desc.layout) {
        case VertexLayout::none: break;
        case VertexLayout::overlay: bytes[RL_STREAM_POSITION] = sizeof(OverlayVertex); break;
        case VertexLayout::extended: bytes[RL_STREAM_EXTRA] = sizeof(VertexExtra); [[fallthrough]];
        case VertexLayout::standard:
            bytes[RL_STREAM_SURFACE] = sizeof(VertexSurface);
            [[fallthrough]];
        case VertexLayout::position:
            bytes[RL_STREAM_POSITION] = sizeof(VertexPosition);
            bytes[RL_STREAM_INSTANCE] = instance;
    }
    return bytes;
}

/// How many whole elements a stream holds.
uint64_t elements(uint64_t size, uint32_t stride, uint32_t bytes) {
    return size < bytes ? 0 : (size - bytes) / stride + 1;
}

}  // namespace

bool CommandChecker::prepareDraw() {
    entryCount_ = 0;
    if (!inPass()) return false;
    if (!pipeline_) {
        fault("No pipeline was set in this pass.");
        return false;
    }
    bool target = pass_->toFrameTarget || pass_->depth.texture;
    for (uint32_t i = 0; i < std::min(pass_->colorCount, kMaxColorAttachments); ++i)
        target |= bool(pass_->colors[i].texture);
    if (!target && pass_->colorCount == 0) fault("The pass has no target to draw into.");
    if (rules_ == ValidationRules::all && pipeline_->depthWrite && pass_->depth.readOnly)
        fault("The pipeline " + pipelineName() + " writes depth; " + nameOf(pass_->depth.texture) +
              " is read-only in this pass.");
    if (pipeline_->blend == BlendMode::filtered && pass_->colorCount > 1)
        fault("The pipeline " + pipelineName() +
              " writes two outputs for one target; the pass has " +
              std::to_string(pass_->colorCount) + " targets.");
    checkStreams();
    checkProgram();
    return true;
}

void CommandChecker::checkStreams() {
    const auto needed = bytesRead(*pipeline_);
    for (uint32_t slot = 0; slot < kVertexStreams; ++slot) {
        if (needed[slot] == 0) continue;
        const BoundRange& stream = streams_[slot];
        if (!stream.bound)
            fault("The pipeline " + pipelineName() + " reads the vertex stream " +
                  std::to_string(slot) + ", which this pass does not set.");
        else if (stream.stride < needed[slot])
            fault("The pipeline " + pipelineName() + " reads " + std::to_string(needed[slot]) +
                  " bytes of each element of the vertex stream " + std::to_string(slot) +
                  ", whose stride is " + std::to_string(stream.stride) + ".");
    }
}

void CommandChecker::checkProgram() {
    if (!slots_) return;
    const auto reads = [&](const char* what, uint32_t slot, const std::string& but) {
        fault("The program of " + pipelineName() + " reads the " + what + " " +
              std::to_string(slot) + ", " + but + ".");
    };
    for (uint32_t slot = 0; slot < kUniformSlots; ++slot) {
        const uint32_t bytes = slots_->uniformBytes[slot];
        if (bytes == 0) continue;
        if (!uniforms_[slot].bound)
            reads("uniform block", slot, "which this pass does not bind");
        else if (uniforms_[slot].size < bytes)
            reads("uniform block", slot,
                  "of " + std::to_string(bytes) + " bytes; " +
                      std::to_string(uniforms_[slot].size) + " are bound");
    }
    for (uint32_t slot = 0; slot < kTextureUnits; ++slot) {
        const SampledAs wanted = slots_->textures[slot];
        if (wanted == SampledAs::nothing) continue;
        const BoundTexture& unit = textures_[slot];
        if (!unit.bound)
            reads("texture unit", slot, "to which this pass binds nothing");
        else if (!unit.empty && unit.as != wanted)
            reads("texture unit", slot,
                  "to which a texture of another kind is bound" +
                      (unit.texture ? ": " + nameOf(unit.texture) : std::string()));
        else if (!unit.empty && unit.compares != slots_->compares[slot])
            reads("texture unit", slot,
                  unit.compares ? "to which a comparing sampler is bound"
                                : "to which a sampler that does not compare is bound");
    }
}

std::string CommandChecker::entryText() const {
    if (entryCount_ == 0) return "The draw";
    return "Draw " + std::to_string(entry_) + " of " + std::to_string(entryCount_);
}

void CommandChecker::checkVertices(uint64_t first, uint64_t count) {
    const auto needed = bytesRead(*pipeline_);
    for (uint32_t slot = 0; slot < kVertexStreams; ++slot) {
        if (needed[slot] == 0 || slot == RL_STREAM_INSTANCE || !streams_[slot].bound) continue;
        const uint64_t there = elements(streams_[slot].size, streams_[slot].stride, needed[slot]);
        if (first + count > there)
            fault(entryText() + " reads the vertices up to " + std::to_string(first + count) +
                  " of the vertex stream " + std::to_string(slot) + ", which has " +
                  std::to_string(there) + ".");
    }
}

void CommandChecker::checkInstances(uint64_t first, uint64_t count) {
    const uint32_t bytes = bytesRead(*pipeline_)[RL_STREAM_INSTANCE];
    const BoundRange& stream = streams_[RL_STREAM_INSTANCE];
    if (bytes == 0 || count == 0 || !stream.bound) return;
    const uint64_t there = elements(stream.size, stream.stride, bytes);
    if (first + count > there)
        fault(entryText() + " reads the instances up to " + std::to_string(first + count) +
              "; there are " + std::to_string(there) + ".");
}

/// Of the bound indices; null where their bytes are not at hand.
const IndexBounds* CommandChecker::indexBounds() {
    const auto bytes = resources_.contents(indexRange_.buffer);
    if (!bytes || indexRange_.offset > bytes->size()) return nullptr;
    const auto [found,
                isNew] = indexBounds_.try_emplace({indexRange_.buffer.value, indexRange_.offset});
    if (isNew) found->second = IndexBounds(bytes->subspan(indexRange_.offset));
    return &found->second;
}

void CommandChecker::checkIndices(const DrawIndexedCommand& draw) {
    const uint64_t end = uint64_t(draw.firstIndex) + draw.indexCount;
    const bool there = end <= indices_.size / 4;
    if (!there)
        fault(entryText() + " reads the indices up to " + std::to_string(end) + "; there are " +
              std::to_string(indices_.size / 4) + ".");
    if (draw.baseVertex < 0) {
        fault(entryText() + " has the base vertex " + std::to_string(draw.baseVertex) + ".");
    } else if (draw.indexCount > 0) {
        const IndexBounds* bounds = there ? indexBounds() : nullptr;
        const uint64_t highest = bounds ? bounds->highest(draw.firstIndex, draw.indexCount) : 0;
        checkVertices(uint64_t(draw.baseVertex), highest + 1);
    }
    checkInstances(draw.baseInstance, draw.instanceCount);
}

void CommandChecker::check(const Draw& c) {
    if (!prepareDraw()) return;
    if (c.vertexCount > 0) checkVertices(c.firstVertex, c.vertexCount);
    checkInstances(0, c.instanceCount);
}

void CommandChecker::check(const DrawIndexed& c) {
    if (!prepareDraw()) return;
    if (!indices_.bound) return fault("This pass sets no index stream.");
    checkIndices(c.command);
}

void CommandChecker::check(const MultiDrawIndexed& c) {
    if (!prepareDraw()) return;
    if (!checkRange(c.commands) || c.drawCount == 0) return;
    if (c.commands.offset % 4 != 0)
        fault("Its commands begin at " + std::to_string(c.commands.offset) + ", no multiple of 4.");
    if (c.commands.size / sizeof(DrawIndexedCommand) < c.drawCount)
        return fault(std::to_string(c.drawCount) + " draws do not fit into " +
                     std::to_string(c.commands.size) + " bytes.");
    if (!indices_.bound) return fault("This pass sets no index stream.");
    if (!indices_.wholeBuffer)
        fault("Indirect draws index from the start of an index buffer of its own.");
    const auto bytes = c.commands.buffer ? resources_.contents(c.commands.buffer)
                                         : std::optional(commands_.data());
    if (!bytes) return;  // only the GPU can look into those
    entryCount_ = c.drawCount;
    const std::byte* entries = bytes->data() + c.commands.offset;
    for (entry_ = 1; entry_ <= c.drawCount; ++entry_) {
        DrawIndexedCommand draw;
        std::memcpy(&draw, entries + size_t(entry_ - 1) * sizeof draw, sizeof draw);
        checkIndices(draw);
        if (memory_.faults_.size() >= CommandValidator::kMostFaults) return;
    }
}

}  // namespace rushlight
