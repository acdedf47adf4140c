#include "renderer/replay/replay.h"

#include "renderer/rhi/commands/command_stream.h"
#include "renderer/rhi/commands/validate_commands.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kTicket = 1;

/// As the executor sees it: a pass with colours but no texture draws into the frame target too.
bool drawsToFrameTarget(const BeginPass& pass) {
    return pass.toFrameTarget ||
           (pass.colorCount > 0 && !pass.colors[0].texture && !pass.depth.texture);
}

template <class AnyHandle>
AnyHandle mapped(const std::vector<AnyHandle>& objects, AnyHandle number) {
    return number.value <= objects.size() ? objects[number.value - 1] : AnyHandle{};
}

}  // namespace

// A field that its command does not use was not checked: it becomes none.
void FrameReplay::mapObject(BufferHandle& handle) const { handle = mapped(buffers_, handle); }
void FrameReplay::mapObject(TextureHandle& handle) const { handle = mapped(textures_, handle); }
void FrameReplay::mapObject(SamplerHandle& handle) const { handle = mapped(samplers_, handle); }
void FrameReplay::mapObject(PipelineHandle& handle) const { handle = mapped(pipelines_, handle); }

Result<std::unique_ptr<FrameReplay>> FrameReplay::create(Device& device, const SavedFrame& frame) {
    std::unique_ptr<FrameReplay> replay(new FrameReplay(device, frame));
    Result<void> step = replay->createObjects();
    if (step) step = replay->createFrameTarget();
    if (!step) return tl::unexpected(step.error());
    replay->translate(~0u);
    // Once more, with what the device knows about the programs.
    CommandValidator validator;
    const auto& faults = validator.validate(replay->commands_, device, ValidationRules::memory);
    if (!faults.empty()) return fail(faults[0].object, faults[0].message);
    return replay;
}

FrameReplay::~FrameReplay() {
    device_.finish();
    for (const BufferHandle buffer : buffers_) device_.destroy(buffer);
    for (const TextureHandle texture : textures_) device_.destroy(texture);
    if (frameTarget_) device_.destroy(frameTarget_);
}

Result<void> FrameReplay::createObjects() {
    for (const SavedBuffer& saved : frame_.buffers) {
        const auto made = device_.createBuffer({saved.label, saved.size, saved.usage});
        if (!made) return tl::unexpected(made.error());
        buffers_.push_back(*made);
    }
    for (uint32_t i = 0; i < frame_.textures.size(); ++i) {
        const auto made = device_.createTexture(*frame_.describe(TextureHandle{i + 1}));
        if (!made) return tl::unexpected(made.error());
        textures_.push_back(*made);
    }
    for (const SamplerDesc& saved : frame_.samplers)
        samplers_.push_back(device_.createSampler(saved));
    for (uint32_t i = 0; i < frame_.pipelines.size(); ++i) {
        const auto made = device_.createPipeline(*frame_.describe(PipelineHandle{i + 1}));
        if (!made) return tl::unexpected(made.error());
        pipelines_.push_back(*made);
    }
    return {};
}

Result<void> FrameReplay::createFrameTarget() {
    bool used = false, readsBack = false;
    visitCommands(frame_.commands, [&]<class Command>(const Command& command) {
        if constexpr (std::is_same_v<Command, BeginPass>) used |= drawsToFrameTarget(command);
        if constexpr (std::is_same_v<Command, Readback>) {
            readsBack = true;
            used |= !command.texture;
        }
    });
    if (!used && !readsBack) return fail("frame", "It gives no picture: it draws none to the end.");
    if (!used) return {};
    TextureDesc desc;
    desc.label = "frame target";
    desc.width = frame_.target.width;
    desc.height = frame_.target.height;
    const auto made = device_.createTexture(desc);
    if (!made) return tl::unexpected(made.error());
    frameTarget_ = *made;
    return {};
}

void FrameReplay::writeContents() {
    for (size_t i = 0; i < buffers_.size(); ++i)
        device_.write(buffers_[i], 0, frame_.blobs.bytes(frame_.buffers[i].contents));
    const auto writeImage = [&](TextureHandle texture, const TextureDesc& desc, uint32_t level,
                                uint32_t layer, std::span<const std::byte> bytes) {
        device_.write(texture,
                      {level, layer, 1, mipSize(desc.width, level), mipSize(desc.height, level)},
                      bytes);
    };
    for (size_t i = 0; i < textures_.size(); ++i) {
        const SavedTexture& saved = frame_.textures[i];
        for (uint32_t image = 0; image < saved.contents.size(); ++image)
            if (saved.contents[image])
                writeImage(textures_[i], saved.desc, image / saved.desc.layers,
                           image % saved.desc.layers, frame_.blobs.bytes(saved.contents[image]));
    }
    if (!frameTarget_) return;
    const TextureDesc desc = *device_.describe(frameTarget_);
    writeImage(frameTarget_, desc, 0, 0, std::vector<std::byte>(imageBytes(desc, 0)));
}

void FrameReplay::translate(uint32_t until) {
    uint32_t readbacks = 0, seen = 0, number = 0;
    visitCommands(frame_.commands, [&]<class Command>(const Command&) {
        readbacks += std::is_same_v<Command, Readback>;
        ++number;
    });
    const bool stops = until < number;
    lastPass_ = {};
    passOpen_ = false;
    number = 0;
    commands_.clear();
    visitCommands(frame_.commands, [&]<class Command>(const Command& original) {
        if (++number > until) return;
        Command command = original;
        visitFields(command, [&]<class Field>(const char*, Field& field) {
            if constexpr (isHandle<Field>)
                if (field) mapObject(field);
        });
        if constexpr (std::is_same_v<Command, BeginPass>) {
            if (drawsToFrameTarget(original)) drawToOwnTarget(command);
            lastPass_ = command;
        }
        if constexpr (std::is_same_v<Command, Readback>) {
            // Of several, the last is the picture.
            if (++seen < readbacks || stops) return;
            command.ticket = kTicket;
            topRowFirst_ = !command.texture && frame_.target.topRowFirst;
            if (!command.texture) command.texture = frameTarget_;
        }
        passOpen_ = std::is_same_v<Command, BeginPass> ||
                    (passOpen_ && !std::is_same_v<Command, EndPass>);
        commands_.push(command);
    });
    commands_.append(frame_.commands.data());
    if (passOpen_) commands_.push(EndPass{lastPass_.passIndex});
    if (stops) {
        readLastPass();
    } else if (readbacks == 0) {
        topRowFirst_ = frame_.target.topRowFirst;
        commands_.push(Readback{frameTarget_, 0, 0, kTicket});
    }
}

void FrameReplay::drawToOwnTarget(BeginPass& pass) const {
    pass.toFrameTarget = 0;
    pass.colorCount = 1;
    pass.colors[0] = {};
    pass.colors[0].texture = frameTarget_;
    pass.colors[0].load = LoadOp::keep;
    pass.depth = {};
}

void FrameReplay::readLastPass() {
    const BeginPass& pass = lastPass_;
    topRowFirst_ = frameTarget_ && pass.colors[0].texture == frameTarget_ &&
                   frame_.target.topRowFirst;
    for (uint32_t i = 0; i < pass.colorCount; ++i)
        if (const ColorAttachment& color = pass.colors[i]; color.texture) {
            commands_.push(Readback{color.texture, color.layer, color.mipLevel, kTicket});
            return;
        }
    if (pass.depth.texture)
        commands_.push(Readback{pass.depth.texture, pass.depth.layer, 0, kTicket});
}

Result<ReadbackImage> FrameReplay::run(const ReplayOptions& options) {
    translate(options.until);
    writeContents();
    ExecuteOptions execute;
    execute.target = frame_.target;
    execute.hashAttachments = options.hashAttachments;
    execute.timers = false;
    ExecutionReport report;
    device_.execute(commands_, execute, report);
    if (auto failure = device_.takeFailure(); !failure) return tl::unexpected(failure.error());
    hashes_.clear();
    if (options.hashAttachments) collectHashes(report);
    ReadbackImage image;
    if (device_.takeReadback(kTicket, true, image)) return image;
    return fail(
        "frame",
        "Its first " + std::to_string(options.until) + " commands begin no pass with a target.",
        ErrorKind::wrongUse);
}

void FrameReplay::collectHashes(const ExecutionReport& report) {
    const BeginPass* pass = nullptr;
    std::vector<const DeclareImage*> written;
    const auto add = [&](TextureHandle texture, uint64_t hash) {
        std::string name = texture == frameTarget_ ? "frame-target" : "?";
        for (const DeclareImage* image : written)
            if (image->texture == texture) name = image->name;
        hashes_.push_back({pass->name, name, hash});
    };
    visitCommands(commands_, [&]<class Command>(const Command& command) {
        if constexpr (std::is_same_v<Command, BeginPass>) {
            pass = &command;
            written.clear();
        } else if constexpr (std::is_same_v<Command, DeclareImage>) {
            if (command.write) written.push_back(&command);
        } else if constexpr (std::is_same_v<Command, EndPass>) {
            const auto& found = report.passes[command.passIndex].attachmentHashes;
            size_t next = 0;
            for (uint32_t i = 0; i < pass->colorCount; ++i)
                if (pass->colors[i].texture && next < found.size())
                    add(pass->colors[i].texture, found[next++]);
            if (pass->depth.texture && !pass->depth.readOnly && next < found.size())
                add(pass->depth.texture, found[next]);
        }
    });
}

}  // namespace rushlight
