#pragma once
// The walk of CommandValidator through one buffer. Used by validate_commands.cpp and
// validate_draws.cpp alone.

#include "engine/core/quoted.h"
#include "renderer/rhi/commands/index_bounds.h"
#include "renderer/rhi/commands/validate_commands.h"

#include <map>
#include <optional>
#include <string>

namespace rushlight {

class CommandChecker {
public:
    CommandChecker(CommandValidator& memory, const CommandBuffer& commands,
                   const ResourceLookup& resources, ValidationRules rules);

    template <class Command>
    void step(const Command& command) {
        ++number_;
        type_ = Command::kType;
        check(command);
    }
    void finish();

private:
    /// What a slot holds; `bound` since the current pass began.
    struct BoundRange {
        bool bound = false;
        uint64_t size = 0;  ///< bytes that may be read
        uint32_t stride = 0;
        bool wholeBuffer = false;  ///< begins at the start of a buffer, not in the data block
    };
    struct BoundTexture {
        bool bound = false;
        bool empty = false;  ///< reads zeroes
        SampledAs as = SampledAs::nothing;
        bool compares = false;
        TextureHandle texture;
    };

    void check(const BeginPass& command);
    void check(const EndPass& command);
    void check(const DeclareImage& command);
    void check(const SetPipeline& command);
    void check(const SetViewport& command);
    void check(const SetScissor& command);
    void check(const SetVertexStream& command);
    void check(const SetIndexStream& command);
    void check(const BindUniforms& command);
    void check(const BindTexelBuffer& command);
    void check(const BindTexture& command);
    void check(const Draw& command);
    void check(const DrawIndexed& command);
    void check(const MultiDrawIndexed& command);
    void check(const Readback& command);

    void checkColor(const ColorAttachment& color, uint32_t slot);
    void checkDepth(const DepthAttachment& depth);
    void checkWriteDeclared(TextureHandle texture);
    void checkSampling(const BindTexture& command);
    bool inPass();
    bool hasSlot(uint32_t slot, uint32_t count);
    /// Bytes of what `range` is in; nothing, and a fault, when that does not exist or is shorter.
    std::optional<uint64_t> checkRange(const BufferRange& range);
    /// As checkRange; what a stream with an unused size can read.
    BoundRange bindStream(const BufferRange& range, uint32_t stride);
    bool declares(TextureHandle texture, bool write) const;

    // Draws (validate_draws.cpp)
    bool prepareDraw();
    void checkProgram();
    void checkStreams();
    void checkVertices(uint64_t first, uint64_t count);
    const IndexBounds* indexBounds();
    void checkInstances(uint64_t first, uint64_t count);
    void checkIndices(const DrawIndexedCommand& draw);
    std::string entryText() const;

    void fault(const std::string& what);
    std::string nameOf(TextureHandle texture) const;
    std::string nameOf(BufferHandle buffer) const;
    std::string pipelineName() const { return quoted(pipeline_->label); }

    CommandValidator& memory_;
    const CommandBuffer& commands_;
    const ResourceLookup& resources_;
    ValidationRules rules_;
    uint32_t number_ = 0;
    CommandType type_ = CommandType::count;
    uint32_t passCount_ = 0;
    const BeginPass* pass_ = nullptr;
    std::optional<PipelineDesc> pipeline_;
    const PipelineSlots* slots_ = nullptr;
    std::array<BoundRange, kVertexStreams> streams_{};
    BoundRange indices_;
    BufferRange indexRange_;
    std::map<std::pair<uint32_t, uint64_t>, IndexBounds> indexBounds_;  ///< by buffer and offset
    std::array<BoundRange, kUniformSlots> uniforms_{};
    std::array<BoundTexture, kTextureUnits> textures_{};
    uint32_t entry_ = 0, entryCount_ = 0;  ///< of a multi-draw
};

}  // namespace rushlight
