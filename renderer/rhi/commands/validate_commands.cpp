#include "renderer/rhi/commands/validate_commands.h"

#include "renderer/rhi/commands/command_checker.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint64_t kBindAlignment = 256;  // of uniform and texel buffer ranges, the most that
                                          // OpenGL 4.5 asks for

struct WriteCollector {
    std::vector<TextureHandle>& written;
    uint32_t passes = 0;

    void operator()(const BeginPass& c) {
        ++passes;
        if (c.toFrameTarget) return;
        for (uint32_t i = 0; i < std::min(c.colorCount, kMaxColorAttachments); ++i)
            add(c.colors[i].texture);
        if (!c.depth.readOnly) add(c.depth.texture);
    }
    template <class Other>
    void operator()(const Other&) {}
    void add(TextureHandle texture) {
        if (texture && std::ranges::find(written, texture) == written.end())
            written.push_back(texture);
    }
};

SampledAs sampledAs(TextureKind kind) {
    switch (kind) {
        case TextureKind::texture2d: return SampledAs::texture2d;
        case TextureKind::texture2dArray: return SampledAs::texture2dArray;
        case TextureKind::cube: return SampledAs::cube;
        case TextureKind::cubeArray: return SampledAs::cubeArray;
    }
    return SampledAs::other;
}

std::string passText(const BeginPass& pass) { return "pass '" + std::string(pass.name) + "'"; }

}  // namespace

const std::vector<Error>& CommandValidator::validate(const CommandBuffer& commands,
                                                     const ResourceLookup& resources,
                                                     ValidationRules rules) {
    faults_.clear();
    CommandChecker checker(*this, commands, resources, rules);
    visitCommands(commands, [&](const auto& command) { checker.step(command); });
    checker.finish();
    return faults_;
}

CommandChecker::CommandChecker(CommandValidator& memory, const CommandBuffer& commands,
                               const ResourceLookup& resources, ValidationRules rules)
    : memory_(memory), commands_(commands), resources_(resources), rules_(rules) {
    memory.writtenByFrame_.clear();
    WriteCollector collector{memory.writtenByFrame_};
    visitCommands(commands, collector);
    passCount_ = collector.passes;
}

void CommandChecker::finish() {
    if (pass_) fault(passText(*pass_) + " does not end.");
}

void CommandChecker::fault(const std::string& what) {
    if (memory_.faults_.size() >= CommandValidator::kMostFaults) return;
    std::string object = pass_ ? passText(*pass_) + ", command " : "command ";
    object += std::to_string(number_) + " (" + toText(type_) + ")";
    memory_.faults_.push_back({std::move(object), what, ErrorKind::wrongUse});
}

// The name that the pass gives it, else the label.
std::string CommandChecker::nameOf(TextureHandle texture) const {
    for (const DeclareImage& image : memory_.declared_)
        if (pass_ && image.texture == texture) return quoted(image.name);
    const auto desc = resources_.describe(texture);
    return desc ? quoted(desc->label) : std::to_string(texture.value);
}

std::string CommandChecker::nameOf(BufferHandle buffer) const {
    if (!buffer) return "the data block";
    const auto desc = resources_.describe(buffer);
    return desc ? quoted(desc->label) : std::to_string(buffer.value);
}

bool CommandChecker::declares(TextureHandle texture, bool write) const {
    return std::ranges::any_of(memory_.declared_, [&](const DeclareImage& image) {
        return image.texture == texture && (image.write != 0) == write;
    });
}

// ---- passes
// ------------------------------------------------------------------------------------------------------

void CommandChecker::check(const BeginPass& c) {
    if (pass_) fault("It begins inside of " + passText(*pass_) + ".");
    pass_ = &c;
    pipeline_.reset();
    slots_ = nullptr;
    streams_ = {};
    indices_ = {};
    uniforms_ = {};
    textures_ = {};
    memory_.declared_.clear();
    if (c.passIndex >= passCount_)
        fault("Its index is " + std::to_string(c.passIndex) + "; there are " +
              std::to_string(passCount_) + " passes.");
    if (c.colorCount > kMaxColorAttachments) {
        fault("It has " + std::to_string(c.colorCount) + " colour targets; at most " +
              std::to_string(kMaxColorAttachments) + " are possible.");
        return;
    }
    if (c.toFrameTarget) return;
    for (uint32_t i = 0; i < c.colorCount; ++i)
        if (c.colors[i].texture) checkColor(c.colors[i], i);
    if (c.depth.texture) checkDepth(c.depth);
}

void CommandChecker::checkColor(const ColorAttachment& color, uint32_t slot) {
    const auto refuse = [&](const std::string& what) {
        fault("The colour target " + std::to_string(slot) + ", " + nameOf(color.texture) + ", " +
              what + ".");
    };
    const auto desc = resources_.describe(color.texture);
    if (!desc) return refuse("is a texture that does not exist");
    if (isDepth(desc->format)) refuse(std::string("has the depth format ") + toText(desc->format));
    // Mesa encodes them with instructions that differ between makers of CPUs: shaders encode.
    if (desc->format == Format::rgba8Srgb && rules_ == ValidationRules::all)
        refuse("has an sRGB format, which is encoded differently from machine to machine");
    if (color.mipLevel >= desc->mipLevels || color.layer >= desc->layers)
        refuse("has no layer " + std::to_string(color.layer) + " of mip level " +
               std::to_string(color.mipLevel));
    if (color.load != LoadOp::clear || !isInteger(desc->format)) return;
    for (int i = 0; i < 4; ++i)
        if (const float value = color.clear[i];
            !(value >= 0 && value <= 4294967040.0f) || value != std::floor(value))
            return refuse(std::string("has the integer format ") + toText(desc->format) +
                          " and is cleared to " + std::to_string(value));
}

void CommandChecker::checkDepth(const DepthAttachment& depth) {
    const auto desc = resources_.describe(depth.texture);
    if (!desc) return fault("The depth target is a texture that does not exist.");
    if (!isDepth(desc->format))
        fault("The depth target, " + nameOf(depth.texture) + ", has the colour format " +
              toText(desc->format) + ".");
    if (depth.layer >= desc->layers)
        fault("The depth target, " + nameOf(depth.texture) + ", has no layer " +
              std::to_string(depth.layer) + ".");
    if (rules_ == ValidationRules::all && depth.readOnly && depth.load != LoadOp::keep)
        fault("The depth target, " + nameOf(depth.texture) + ", is read-only, and not kept.");
}

void CommandChecker::check(const EndPass& c) {
    if (!pass_) return fault("No pass has begun.");
    if (c.passIndex != pass_->passIndex)
        fault("It ends pass " + std::to_string(c.passIndex) + ", where pass " +
              std::to_string(pass_->passIndex) + " is open.");
    if (rules_ == ValidationRules::all && !pass_->toFrameTarget) {
        for (uint32_t i = 0; i < pass_->colorCount && i < kMaxColorAttachments; ++i)
            checkWriteDeclared(pass_->colors[i].texture);
        if (!pass_->depth.readOnly) checkWriteDeclared(pass_->depth.texture);
    }
    pass_ = nullptr;
    pipeline_.reset();
}

void CommandChecker::checkWriteDeclared(TextureHandle texture) {
    if (texture && !declares(texture, true))
        fault("The pass writes " + nameOf(texture) + " and does not declare it.");
}

void CommandChecker::check(const DeclareImage& c) {
    if (!inPass()) return;
    if (!resources_.describe(c.texture))
        fault("The image '" + std::string(c.name) + "' is a texture that does not exist.");
    memory_.declared_.push_back(c);
}

bool CommandChecker::inPass() {
    if (!pass_) fault("It is outside of any pass.");
    return pass_ != nullptr;
}

// ---- bindings
// ----------------------------------------------------------------------------------------------------

bool CommandChecker::hasSlot(uint32_t slot, uint32_t count) {
    if (slot >= count)
        fault("Its slot is " + std::to_string(slot) + "; there are " + std::to_string(count) + ".");
    return slot < count;
}

std::optional<uint64_t> CommandChecker::checkRange(const BufferRange& range) {
    uint64_t size = commands_.data().size();
    if (range.buffer) {
        const auto desc = resources_.describe(range.buffer);
        if (!desc) {
            fault("It names the buffer " + std::to_string(range.buffer.value) +
                  ", which does not exist.");
            return {};
        }
        size = desc->size;
    }
    if (range.offset <= size && range.size <= size - range.offset) return size;
    fault("The range of " + std::to_string(range.size) + " bytes at " +
          std::to_string(range.offset) + " is outside of " + nameOf(range.buffer) + " with " +
          std::to_string(size) + " bytes.");
    return {};
}

CommandChecker::BoundRange CommandChecker::bindStream(const BufferRange& range, uint32_t stride) {
    const auto size = checkRange(range);
    if (!size) return {true, ~uint64_t(0) >> 1, stride, true};  // one fault is enough
    if (range.offset % 4 != 0)
        fault("Its offset is " + std::to_string(range.offset) + ", no multiple of 4.");
    return {true, range.size ? range.size : *size - range.offset, stride,
            range.buffer && range.offset == 0};
}

void CommandChecker::check(const SetPipeline& c) {
    if (!inPass()) return;
    pipeline_ = resources_.describe(c.pipeline);
    slots_ = resources_.slots(c.pipeline);
    if (!pipeline_)
        fault("It names the pipeline " + std::to_string(c.pipeline.value) +
              ", which does not exist.");
}

void CommandChecker::check(const SetViewport& c) {
    if (inPass() && (c.width < 0 || c.height < 0)) fault("Its size is negative.");
}

void CommandChecker::check(const SetScissor& c) {
    if (inPass() && (c.width < 0 || c.height < 0)) fault("Its size is negative.");
}

void CommandChecker::check(const SetVertexStream& c) {
    constexpr uint32_t kMostStride = 2048;  // what OpenGL 4.5 promises
    if (!inPass() || !hasSlot(c.slot, kVertexStreams)) return;
    if (c.stride == 0 || c.stride > kMostStride || c.stride % 4 != 0)
        fault("Its stride is " + std::to_string(c.stride) +
              "; it must be a multiple of 4 up to 2048.");
    streams_[c.slot] = bindStream(c.range, std::max(c.stride, 1u));
}

void CommandChecker::check(const SetIndexStream& c) {
    if (!inPass()) return;
    indices_ = bindStream(c.range, 4);
    indexRange_ = c.range;
}

void CommandChecker::check(const BindUniforms& c) {
    if (!inPass() || !hasSlot(c.slot, kUniformSlots)) return;
    uniforms_[c.slot] = {true, c.range.size, 0, false};
    if (!checkRange(c.range)) return;
    if (c.range.size == 0) fault("A range of 0 bytes cannot be bound.");
    if (c.range.offset % kBindAlignment != 0)
        fault("Its offset is " + std::to_string(c.range.offset) + ", no multiple of 256.");
}

void CommandChecker::check(const BindTexelBuffer& c) {
    if (!inPass() || !hasSlot(c.slot, kTextureUnits)) return;
    textures_[c.slot] = {true,
                         c.range.size == 0,
                         isInteger(c.format) ? SampledAs::integerTexels : SampledAs::floatTexels,
                         false,
                         {}};
    if (!checkRange(c.range)) return;
    if (!isTexelBufferFormat(c.format))
        fault(std::string("A texel buffer cannot have the format ") + toText(c.format) + ".");
    if (c.range.offset % kBindAlignment != 0)
        fault("Its offset is " + std::to_string(c.range.offset) + ", no multiple of 256.");
}

void CommandChecker::check(const BindTexture& c) {
    if (!inPass() || !hasSlot(c.slot, kTextureUnits)) return;
    BoundTexture& unit = textures_[c.slot];
    unit = {true, !c.texture, SampledAs::nothing, false, c.texture};
    if (!c.texture) return;
    const auto desc = resources_.describe(c.texture);
    if (!desc) {
        unit.empty = true;
        return fault("It names the texture " + std::to_string(c.texture.value) +
                     ", which does not exist.");
    }
    unit.as = sampledAs(desc->kind);
    if (c.sampler) {
        const auto sampler = resources_.describe(c.sampler);
        if (!sampler)
            return fault("It names the sampler " + std::to_string(c.sampler.value) +
                         ", which does not exist.");
        unit.compares = sampler->compareGreaterEqual;
        if (unit.compares && !isDepth(desc->format))
            fault("A comparing sampler is put to " + nameOf(c.texture) +
                  ", which has the colour format " + toText(desc->format) + ".");
        const bool filters = sampler->magnify == TextureFilter::linear ||
                             sampler->minify == TextureFilter::linear;
        if (filters && isInteger(desc->format))
            fault("A filtering sampler is put to " + nameOf(c.texture) +
                  ", which has the integer format " + toText(desc->format) + ".");
    }
    checkSampling(c);
}

void CommandChecker::checkSampling(const BindTexture& c) {
    if (rules_ != ValidationRules::all) return;
    const BeginPass& pass = *pass_;
    bool target = !pass.depth.readOnly && pass.depth.texture == c.texture;
    for (uint32_t i = 0; i < std::min(pass.colorCount, kMaxColorAttachments); ++i)
        target |= pass.colors[i].texture == c.texture;
    target &= !pass.toFrameTarget;
    if (target) return fault("The pass samples " + nameOf(c.texture) + " while it writes it.");
    if (std::ranges::find(memory_.writtenByFrame_, c.texture) != memory_.writtenByFrame_.end() &&
        !declares(c.texture, false))
        fault("The pass samples " + nameOf(c.texture) +
              ", which this frame writes, and does not declare it.");
}

void CommandChecker::check(const Readback& c) {
    if (pass_) fault("It is inside of " + passText(*pass_) + ".");
    if (!c.texture) return;
    const auto desc = resources_.describe(c.texture);
    if (!desc)
        return fault("It names the texture " + std::to_string(c.texture.value) +
                     ", which does not exist.");
    if (c.mipLevel >= desc->mipLevels || c.layer >= desc->layers)
        fault(nameOf(c.texture) + " has no layer " + std::to_string(c.layer) + " of mip level " +
              std::to_string(c.mipLevel) + ".");
}

}  // namespace rushlight
