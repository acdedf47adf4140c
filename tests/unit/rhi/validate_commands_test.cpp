// One frame that is right, and for every rule one that breaks it.

#include "renderer/rhi/commands/validate_commands.h"
#include "tests/support/memory_device.h"
#include "tests/support/scenes/small_frame.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

/// The device, and programs that read what the test says.
class Resources final : public ResourceLookup {
public:
    MemoryDevice device;
    PipelineSlots read;
    PipelineHandle reader;

    std::optional<BufferDesc> describe(BufferHandle h) const override { return device.describe(h); }
    std::optional<TextureDesc> describe(TextureHandle h) const override {
        return device.describe(h);
    }
    std::optional<SamplerDesc> describe(SamplerHandle h) const override {
        return device.describe(h);
    }
    std::optional<PipelineDesc> describe(PipelineHandle h) const override {
        return device.describe(h);
    }
    const PipelineSlots* slots(PipelineHandle h) const override {
        return h == reader ? &read : nullptr;
    }
};

class Validator : public testing::Test {
protected:
    Resources resources;
    SmallFrame small{resources.device};
    CommandValidator validator;

    TextureHandle texture(Format format, uint32_t layers = 1) {
        TextureDesc desc{"extra", TextureKind::texture2d, format, 4, 2, layers, 1};
        if (layers > 1) desc.kind = TextureKind::texture2dArray;
        return resources.device.createTexture(desc).value();
    }
    size_t expectedFaults = 1;
    /// The text of the first fault, of as many as are expected; "right" when there is none.
    std::string check(const CommandBuffer& commands, ValidationRules rules = ValidationRules::all) {
        const auto& faults = validator.validate(commands, resources, rules);
        if (faults.empty()) return "right";
        EXPECT_EQ(faults.size(), expectedFaults) << faults.back().text();
        EXPECT_EQ(faults[0].kind, ErrorKind::wrongUse);
        return faults[0].text();
    }
    /// The small frame with every command of a type changed.
    template <class Command, class Change>
    std::string with(Change&& change, ValidationRules rules = ValidationRules::all) {
        CommandBuffer changed;
        changed.append(small.commands.data());
        visitCommands(small.commands, [&](auto command) {
            if constexpr (std::is_same_v<decltype(command), Command>) change(command);
            changed.push(command);
        });
        return check(changed, rules);
    }
    /// The small frame without the commands for which `drop` holds.
    template <class Command, class Drop>
    std::string without(Drop&& drop) {
        CommandBuffer changed;
        changed.append(small.commands.data());
        visitCommands(small.commands, [&](auto command) {
            if constexpr (std::is_same_v<decltype(command), Command>)
                if (drop(command)) return;
            changed.push(command);
        });
        return check(changed);
    }
    /// What the pass "paint" is asked for by a program that reads slots.
    std::string withProgram(const PipelineSlots& read) {
        resources.reader = small.fullscreen;
        resources.read = read;
        return check(small.commands);
    }
    static auto always() {
        return [](const auto&) { return true; };
    }
};

TEST_F(Validator, TheSmallFrameIsRight) { EXPECT_EQ(check(small.commands), "right"); }

TEST_F(Validator, MessagesNamePassCommandAndObject) {
    expectedFaults = 2;  // and the draw that has no pipeline then
    EXPECT_EQ(
        with<SetPipeline>([&](SetPipeline& c) {
            if (c.pipeline == small.surface) c.pipeline = {77};
        }),
        "pass 'shadow', command 3 (SetPipeline): It names the pipeline 77, which does not exist.");
}

TEST_F(Validator, UnknownHandles) {
    EXPECT_NE(with<BindTexture>([&](BindTexture& c) {
                  if (c.texture == small.pictures) c.texture = {77};
              }).find("the texture 77"),
              std::string::npos);
    EXPECT_NE(with<BindTexture>([&](BindTexture& c) {
                  if (c.texture == small.pictures) c.sampler = {77};
              }).find("the sampler 77"),
              std::string::npos);
    EXPECT_NE(with<SetIndexStream>([](SetIndexStream& c) {
                  c.range.buffer = {77};
              }).find("the buffer 77"),
              std::string::npos);
    EXPECT_NE(with<Readback>([](Readback& c) { c.texture = {77}; }).find("the texture 77"),
              std::string::npos);
}

TEST_F(Validator, RangesOutsideOfTheirBuffer) {
    EXPECT_EQ(
        with<BindUniforms>([](BindUniforms& c) { c.range.size = 10000; }),
        "pass 'paint', command 12 (BindUniforms): The range of 10000 bytes at 512 is outside of "
        "the data block with 528 bytes.");
    EXPECT_NE(with<BindTexelBuffer>([](BindTexelBuffer& c) {
                  c.range.offset = 256;
              }).find("outside of \"materials\" with 256 bytes"),
              std::string::npos);
    EXPECT_NE(with<BindUniforms>([](BindUniforms& c) {
                  c.range.offset = ~uint64_t(0) - 4;
              }).find("outside of"),
              std::string::npos)
        << "offset and size wrap around";
    EXPECT_NE(with<BindUniforms>([](BindUniforms& c) {
                  c.range.offset = 500;
              }).find("no multiple of 256"),
              std::string::npos);
    EXPECT_NE(
        with<BindUniforms>([](BindUniforms& c) { c.slot = kUniformSlots; }).find("there are 8"),
        std::string::npos);
}

TEST_F(Validator, UndeclaredReads) {
    const auto drop = [&](const DeclareImage& c) { return c.texture == small.shadows && !c.write; };
    EXPECT_EQ(
        without<DeclareImage>(drop),
        "pass 'paint', command 13 (BindTexture): The pass samples \"shadows\", which this frame "
        "writes, and does not declare it.");
}

TEST_F(Validator, ReadsOfWhatNobodyWritesNeedNoDeclaration) {
    // The pictures are sampled and never declared, as the small frame has them.
    const auto drop = [&](const DeclareImage& c) { return c.texture == small.pictures; };
    EXPECT_EQ(without<DeclareImage>(drop), "right");
}

TEST_F(Validator, UndeclaredWrites) {
    const auto drop = [&](const DeclareImage& c) { return c.texture == small.painted; };
    EXPECT_EQ(
        without<DeclareImage>(drop),
        "pass 'paint', command 18 (EndPass): The pass writes \"painted\" and does not declare it.");
}

TEST_F(Validator, FeedbackLoops) {
    EXPECT_EQ(
        with<BindTexture>([&](BindTexture& c) {
            if (c.texture == small.pictures) c.texture = small.painted;
        }),
        "pass 'paint', command 15 (BindTexture): The pass samples \"painted\" while it writes it.");
}

TEST_F(Validator, ReadOnlyDepthMayBeSampledAndNotWritten) {
    const TextureHandle depth = texture(Format::depth32f);
    const auto attach = [&](BeginPass& c) {
        if (c.passIndex == 1) c.depth = {depth, 0, LoadOp::keep, 1, 0};
    };
    const auto sampled = [&](bool readOnly) {
        CommandBuffer changed;
        changed.append(small.commands.data());
        visitCommands(small.commands, [&](auto command) {
            if constexpr (std::is_same_v<decltype(command), BeginPass>) {
                attach(command);
                if (command.passIndex == 1) command.depth.readOnly = readOnly;
            }
            if constexpr (std::is_same_v<decltype(command), BindTexture>)
                if (command.texture == small.pictures) command.texture = depth;
            if constexpr (std::is_same_v<decltype(command), EndPass>)
                if (command.passIndex == 1 && !readOnly)
                    changed.push(DeclareImage{depth, 1, "depth"});
            changed.push(command);
        });
        return check(changed);
    };
    EXPECT_EQ(sampled(true), "right");
    EXPECT_NE(sampled(false).find("samples \"extra\" while it writes it"), std::string::npos);

    PipelineDesc desc = *resources.describe(small.fullscreen);
    desc.depthWrite = true;
    const PipelineHandle writer = resources.device.createPipeline(desc).value();
    CommandBuffer changed;
    changed.append(small.commands.data());
    visitCommands(small.commands, [&](auto command) {
        if constexpr (std::is_same_v<decltype(command), BeginPass>) attach(command);
        if constexpr (std::is_same_v<decltype(command), SetPipeline>)
            if (command.pipeline == small.fullscreen) command.pipeline = writer;
        changed.push(command);
    });
    EXPECT_NE(check(changed).find("\"fullscreen\" writes depth; \"extra\" is read-only"),
              std::string::npos);
}

TEST_F(Validator, ASecondOutputIsForOneTarget) {
    PipelineDesc desc = *resources.device.describe(small.fullscreen);
    desc.label = "fullscreen";
    desc.blend = BlendMode::filtered;
    const PipelineHandle filtering = resources.device.createPipeline(desc).value();
    const auto painted = [&](bool twoTargets) {
        const TextureHandle second = texture(Format::rgba8);
        CommandBuffer changed;
        changed.append(small.commands.data());
        visitCommands(small.commands, [&](auto command) {
            if constexpr (std::is_same_v<decltype(command), BeginPass>)
                if (twoTargets && command.colorCount == 1) {
                    command.colors[1] = command.colors[0];
                    command.colors[1].texture = second;
                    command.colorCount = 2;
                }
            if constexpr (std::is_same_v<decltype(command), EndPass>)
                if (twoTargets) changed.push(DeclareImage{second, 1, "second"});
            if constexpr (std::is_same_v<decltype(command), SetPipeline>)
                if (command.pipeline == small.fullscreen) command.pipeline = filtering;
            changed.push(command);
        });
        const auto& faults = validator.validate(changed, resources, ValidationRules::all);
        return std::ranges::any_of(faults, [](const Error& fault) {
            return fault.text().find("writes two outputs for one target; the pass has 2") !=
                   std::string::npos;
        });
    };
    EXPECT_FALSE(painted(false));
    EXPECT_TRUE(painted(true));
}

TEST_F(Validator, WrongFormats) {
    const TextureHandle color = texture(Format::rgba8, 2), depth = texture(Format::depth32f);
    const auto faults = [&](auto&& change) {
        return with<BeginPass>(change, ValidationRules::memory);
    };
    EXPECT_NE(faults([&](BeginPass& c) {
                  if (c.colorCount) c.colors[0].texture = depth;
              }).find("\"extra\", has the depth format depth32f"),
              std::string::npos);
    EXPECT_NE(faults([&](BeginPass& c) {
                  if (!c.colorCount) c.depth.texture = color;
              }).find("\"extra\", has the colour format rgba8"),
              std::string::npos);
    EXPECT_NE(faults([&](BeginPass& c) {
                  if (c.colorCount) c.colors[0].layer = 3;
              }).find("has no layer 3"),
              std::string::npos);
    EXPECT_NE(with<BindTexelBuffer>([](BindTexelBuffer& c) {
                  c.format = Format::r11g11b10f;
              }).find("cannot have the format r11g11b10f"),
              std::string::npos);
    const SamplerHandle compares = resources.device.createSampler({.compareGreaterEqual = true});
    EXPECT_NE(with<BindTexture>([&](BindTexture& c) {
                  if (c.texture == small.pictures) c.sampler = compares;
              }).find("comparing sampler is put to \"pictures\""),
              std::string::npos);
    const TextureHandle integers = texture(Format::rgba32ui);
    EXPECT_NE(with<BindTexture>([&](BindTexture& c) {
                  if (c.texture == small.pictures) c.texture = integers;
              }).find("filtering sampler is put to \"extra\""),
              std::string::npos);
}

TEST_F(Validator, TooManyTargets) {
    EXPECT_NE(with<BeginPass>([](BeginPass& c) {
                  if (c.colorCount) c.colorCount = 5;
              }).find("It has 5 colour targets; at most 4"),
              std::string::npos);
}

TEST_F(Validator, NoTargetIsEncodedByTheDriver) {
    expectedFaults = 2;  // and that the pass does not declare it
    const TextureHandle encoded = texture(Format::rgba8Srgb);
    EXPECT_NE(with<BeginPass>([&](BeginPass& c) {
                  if (c.colorCount) c.colors[0].texture = encoded;
              }).find("has an sRGB format"),
              std::string::npos);
}

TEST_F(Validator, IntegerTargetsAreClearedToIntegers) {
    const TextureHandle integers = texture(Format::r32ui);
    const auto clear = [&](float value) {
        return with<BeginPass>(
            [&](BeginPass& c) {
                if (!c.colorCount) return;
                c.colors[0].texture = integers;
                c.colors[0].load = LoadOp::clear;
                c.colors[0].clear = vec4(value);
            },
            ValidationRules::memory);
    };
    EXPECT_EQ(clear(7), "right");
    EXPECT_NE(clear(0.5f).find("has the integer format r32ui"), std::string::npos);
    EXPECT_NE(clear(-1).find("has the integer format r32ui"), std::string::npos);
}

TEST_F(Validator, BindingsOfAnEarlierPassDoNotCount) {
    PipelineSlots read;
    read.uniformBytes[RL_UNIFORMS_PASS] = 16;
    read.textures[RL_TEXTURE_BASE_COLOR] = SampledAs::texture2dArray;
    read.textures[RL_TEXTURE_MATERIALS] = SampledAs::integerTexels;
    EXPECT_EQ(withProgram(read), "right");
    // The draw of the first pass wants what only the second binds.
    resources.reader = small.surface;
    EXPECT_EQ(validator.validate(small.commands, resources).size(), 3u);
}

TEST_F(Validator, MissingBindings) {
    PipelineSlots read;
    read.uniformBytes[RL_UNIFORMS_VIEW] = 16;
    EXPECT_EQ(
        withProgram(read),
        "pass 'paint', command 18 (Draw): The program of \"fullscreen\" reads the uniform block 0, "
        "which this pass does not bind.");
    read = {};
    read.uniformBytes[RL_UNIFORMS_PASS] = 32;
    EXPECT_NE(withProgram(read).find("of 32 bytes; 16 are bound"), std::string::npos);
    read = {};
    read.textures[9] = SampledAs::texture2d;
    EXPECT_NE(withProgram(read).find("texture unit 9, to which this pass binds nothing"),
              std::string::npos);
    read = {};
    read.textures[RL_TEXTURE_BASE_COLOR] = SampledAs::cube;
    EXPECT_NE(withProgram(read).find("of another kind is bound: \"pictures\""), std::string::npos);
    read = {};
    read.textures[RL_TEXTURE_MATERIALS] = SampledAs::floatTexels;
    EXPECT_NE(withProgram(read).find("of another kind is bound"), std::string::npos);
    read = {};
    read.textures[RL_TEXTURE_SHADOW] = SampledAs::texture2dArray;
    read.compares[RL_TEXTURE_SHADOW] = true;
    EXPECT_NE(withProgram(read).find("a sampler that does not compare is bound"),
              std::string::npos);
}

TEST_F(Validator, MissingStreams) {
    EXPECT_NE(without<SetVertexStream>([](const SetVertexStream& c) {
                  return c.slot == 0;
              }).find("\"surface\" reads the vertex stream 0, which this pass does not set"),
              std::string::npos);
    EXPECT_NE(without<SetIndexStream>(always()).find("sets no index stream"), std::string::npos);
    EXPECT_NE(with<SetVertexStream>([](SetVertexStream& c) {
                  if (c.slot == 3) c.stride = 32;
              }).find("reads 64 bytes of each element of the vertex stream 3"),
              std::string::npos);
}

TEST_F(Validator, DrawsNeedPassPipelineAndTarget) {
    EXPECT_NE(without<SetPipeline>([&](const SetPipeline& c) {
                  return c.pipeline == small.fullscreen;
              }).find("command 17 (Draw): No pipeline was set in this pass"),
              std::string::npos);
    expectedFaults = 2;  // one for each pass
    EXPECT_NE(with<BeginPass>([](BeginPass& c) { c.colorCount = 0, c.depth = {}; },
                              ValidationRules::memory)
                  .find("no target"),
              std::string::npos);
    expectedFaults = 1;
    CommandBuffer outside;
    outside.push(Draw{3, 1, 0});
    EXPECT_EQ(check(outside), "command 1 (Draw): It is outside of any pass.");
}

TEST_F(Validator, PassesAreBalanced) {
    CommandBuffer commands;
    commands.push(BeginPass{});
    EXPECT_NE(check(commands).find("does not end"), std::string::npos);
    commands.clear();
    commands.push(EndPass{});
    EXPECT_EQ(check(commands), "command 1 (EndPass): No pass has begun.");
    {  // of two passes, 2 is one too high
        CommandBuffer changed;
        changed.append(small.commands.data());
        visitCommands(small.commands, [&](auto command) {
            if constexpr (requires { command.passIndex; })
                if (command.passIndex == 1) command.passIndex = 2;
            changed.push(command);
        });
        EXPECT_NE(check(changed).find("Its index is 2; there are 2 passes"), std::string::npos);
    }
    EXPECT_NE(with<EndPass>([](EndPass& c) {
                  if (c.passIndex == 1) c.passIndex = 0;
              }).find("It ends pass 0, where pass 1 is open"),
              std::string::npos);
    EXPECT_NE(without<EndPass>([](const EndPass& c) {
                  return c.passIndex == 0;
              }).find("It begins inside of pass 'shadow'"),
              std::string::npos);
    commands.clear();
    BeginPass far;
    far.passIndex = 1000000;
    commands.push(far);
    commands.push(EndPass{far.passIndex});
    EXPECT_NE(check(commands).find("Its index is 1000000; there are 1 passes"), std::string::npos);
    expectedFaults = 2;  // nor does the pass end
    EXPECT_NE(without<EndPass>([](const EndPass& c) {
                  return c.passIndex == 1;
              }).find("(Readback): It is inside of pass 'paint'"),
              std::string::npos);
}

TEST_F(Validator, IndirectDrawsOutsideOfTheirBuffers) {
    const auto withDraw = [&](const DrawIndexedCommand& draw) {
        SmallFrame frame(resources.device);
        std::memcpy(frame.commands.bytes({{}, 0, 256, sizeof draw}).data(), &draw, sizeof draw);
        return check(frame.commands);
    };
    EXPECT_EQ(withDraw({3, 1, 0, 0, 0}), "right");
    EXPECT_EQ(withDraw({3, 1, 1, 0, 0}),
              "pass 'shadow', command 7 (MultiDrawIndexed): Draw 1 of 1 reads the indices up to 4; "
              "there are 3.");
    EXPECT_NE(withDraw({3, 1, ~0u, 0, 0}).find("reads the indices up to 4294967298"),
              std::string::npos);
    EXPECT_NE(withDraw({3, 2, 0, 0, 0}).find("reads the instances up to 2; there are 1"),
              std::string::npos);
    EXPECT_NE(withDraw({3, 1, 0, 0, 1}).find("reads the instances up to 2; there are 1"),
              std::string::npos);
    EXPECT_NE(withDraw({3, 1, 0, 3, 0})
                  .find("reads the vertices up to 4 of the vertex stream 0, which has 3"),
              std::string::npos);
    EXPECT_NE(withDraw({3, 1, 0, -1, 0}).find("base vertex -1"), std::string::npos);
    EXPECT_NE(with<MultiDrawIndexed>([](MultiDrawIndexed& c) {
                  c.drawCount = 2;
              }).find("2 draws do not fit into 20 bytes"),
              std::string::npos);
    EXPECT_NE(with<SetIndexStream>([](SetIndexStream& c) {
                  c.range = {{}, 0, 0, 12};
              }).find("an index buffer of its own"),
              std::string::npos);
}

TEST_F(Validator, FaultsAreLimited) {
    CommandBuffer commands;
    for (int i = 0; i < 1000; ++i) commands.push(Draw{});
    EXPECT_EQ(validator.validate(commands, resources).size(), CommandValidator::kMostFaults);
}

}  // namespace
}  // namespace rushlight
