// Frames to bytes and back, and what becomes of bytes that are no frame.

#include "renderer/rhi/saved/frame_file.h"
#include "renderer/replay/replay.h"
#include "renderer/replay/snapshot.h"
#include "renderer/rhi/commands/index_bounds.h"
#include "renderer/rhi/saved/frame_diff.h"
#include "renderer/rhi/saved/needed_contents.h"
#include "tests/support/gl/sealed_frame.h"
#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/small_frame.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class FrameFile : public testing::Test {
protected:
    MemoryDevice device;
    SmallFrame small{device};
    std::vector<std::byte> file = encodeFrame(takeSnapshot(device, small.commands, small.target));

    static std::string refusal(std::vector<std::byte> bytes) {
        const auto frame = decodeFrame(std::move(bytes), "a.rlf");
        return frame ? "accepted" : frame.error().text();
    }
    /// All that can be done with a frame, on a device that stops the program where a command is
    /// wrong.
    static bool isHarmless(const SavedFrame& frame) {
        const auto null = createNullDevice();
        printNumbered(frame.commands, frame);
        diffFrames(frame, frame);
        const auto replay = FrameReplay::create(*null, frame);
        return !replay || (*replay)->run({.until = 7}).has_value() ||
               (*replay)->run({}).has_value();
    }
};

TEST(Hash128, IsThePublishedFunction) {
    const auto hash = [](std::string_view text) {
        return toText(hash128(std::as_bytes(std::span(text))));
    };
    EXPECT_EQ(hash(""), "00000000000000000000000000000000");
    EXPECT_EQ(hash("hello"), "cbd8a7b341bd9b025b1e906a48ae1d19");
    EXPECT_EQ(hash("The quick brown fox jumps over the lazy dog"),
              "e34bbc7bbc071b6c7a433ca9c49a9347");
}

TEST_F(FrameFile, ComesBackAsItWas) {
    const auto frame = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(frame) << frame.error().text();
    EXPECT_EQ(encodeFrame(*frame), file);
    EXPECT_EQ(frame->target.width, 4u);
    ASSERT_EQ(frame->buffers.size(), 3u);
    EXPECT_EQ(frame->buffers[0].label, "indices");
    ASSERT_EQ(frame->textures.size(), 3u);
    EXPECT_EQ(frame->textures[0].label, "shadows");
    EXPECT_EQ(frame->textures[2].desc.mipLevels, 2u);
    ASSERT_EQ(frame->samplers.size(), 1u);
    EXPECT_EQ(frame->samplers[0].maxAnisotropy, 4);
    const auto pipeline = frame->describe(PipelineHandle{2});
    ASSERT_TRUE(pipeline);
    EXPECT_EQ(pipeline->label, "fullscreen");
    EXPECT_EQ(pipeline->fragmentSource, "void main() {}\n");
}

TEST_F(FrameFile, DoesNotDependOnHandlesOrTickets) {
    MemoryDevice other;
    other.destroy(other.createTexture({}).value());
    other.createBuffer({"before", 8}).value();
    SmallFrame again(other);
    EXPECT_EQ(encodeFrame(takeSnapshot(other, again.commands, again.target)), file);
}

TEST_F(FrameFile, KeepsWhatTheFrameReadsAndNothingElse) {
    const auto frame = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(frame);
    const std::vector<uint32_t>& shadows = frame->textures[0].contents;
    ASSERT_EQ(shadows.size(), 2u);
    EXPECT_EQ(shadows[0], 0u) << "cleared before it is sampled";
    EXPECT_NE(shadows[1], 0u) << "cached from an earlier frame";
    EXPECT_EQ(frame->textures[1].contents, std::vector<uint32_t>{0}) << "discarded";
    for (const uint32_t image : frame->textures[2].contents) EXPECT_NE(image, 0u);
    // Layer 1 of level 1 of the pictures: bytes 4 to 7 of what was written to that level.
    const auto bytes = frame->blobs.bytes(frame->textures[2].contents[3]);
    ASSERT_EQ(bytes.size(), 4u);
    EXPECT_EQ(bytes[0], std::byte(5));
}

TEST_F(FrameFile, KeepsEqualContentsOnce) {
    SavedFrame frame;
    const std::vector<std::byte> zeroes(100), ones(100, std::byte(1));
    EXPECT_EQ(frame.blobs.add(zeroes), 1u);
    EXPECT_EQ(frame.blobs.add(ones), 2u);
    EXPECT_EQ(frame.blobs.add(zeroes), 1u);
}

TEST_F(FrameFile, KeepOfAnAttachmentNeedsItsContents) {
    CommandBuffer commands;
    BeginPass pass;
    pass.colorCount = 1;
    pass.colors[0].texture = small.painted;
    pass.colors[0].load = LoadOp::keep;
    commands.push(pass);
    commands.push(EndPass{});
    EXPECT_TRUE(neededContents(commands, device).at(small.painted)[0]);
}

TEST_F(FrameFile, TruncatedAnywhereIsRefused) {
    ASSERT_LT(file.size(), 20000u);
    for (size_t size = 0; size < file.size(); ++size) {
        const std::string text = refusal({file.begin(), file.begin() + std::ptrdiff_t(size)});
        ASSERT_NE(text, "accepted") << size;
        if (size < 8) continue;
        ASSERT_NE(text.find("truncated at byte " + std::to_string(size)), text.npos) << text;
    }
    auto longer = file;
    longer.push_back({});
    EXPECT_NE(refusal(longer), "accepted");
    // Nor where the header promises the byte.
    const uint64_t size = longer.size();
    std::memcpy(longer.data() + 16, &size, sizeof size);
    EXPECT_NE(refusal(longer).find("after the last blob"), std::string::npos) << refusal(longer);
}

TEST_F(FrameFile, EveryFlippedBitIsRefused) {
    for (size_t i = 0; i < file.size() * 8; ++i) {
        auto damaged = file;
        damaged[i / 8] ^= std::byte(1 << i % 8);
        ASSERT_NE(refusal(damaged), "accepted") << "bit " << i;
    }
}

// With hashes that fit, what the bytes say is what counts.
TEST_F(FrameFile, EveryFlippedBitWithRightHashesIsRefusedOrHarmless) {
    uint32_t accepted = 0;
    for (size_t i = 0; i < file.size() * 8; ++i) {
        auto damaged = file;
        damaged[i / 8] ^= std::byte(1 << i % 8);
        sealFrame(damaged);
        const auto frame = decodeFrame(std::move(damaged), "a.rlf");
        if (!frame) continue;
        ++accepted;
        ASSERT_TRUE(isHarmless(*frame)) << "bit " << i;
    }
    EXPECT_GT(accepted, file.size()) << "contents may be anything, so many must have passed";
}

TEST_F(FrameFile, ErrorsNameFileAndReason) {
    EXPECT_EQ(refusal({}), "a.rlf: This is no RLF file: it does not begin as one.");
    auto damaged = file;
    damaged[0] = std::byte('X');
    EXPECT_EQ(refusal(damaged), "a.rlf: This is no RLF file: it does not begin as one.");
    damaged = file;
    damaged[8] = std::byte(9);
    EXPECT_NE(refusal(damaged).find("version is 9"), std::string::npos);
    damaged = file;
    damaged.back() ^= std::byte(1);
    EXPECT_NE(refusal(damaged).find("has the hash"), std::string::npos) << refusal(damaged);
    damaged = file;
    damaged[kRlfBlobTable + 30] ^= std::byte(1);
    EXPECT_EQ(refusal(damaged), "a.rlf: The description's hash is wrong: the file is damaged.");
}

TEST_F(FrameFile, UnknownCommandsAreRefused) {
    auto frame = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(frame);
    std::vector<std::byte> commands(frame->commands.commandBytes().begin(),
                                    frame->commands.commandBytes().end());
    commands[0] = std::byte(99);
    frame->commands.assign(commands, {});
    EXPECT_EQ(refusal(encodeFrame(*frame)), "a.rlf: Command 1 is wrong: its type 99 is unknown.");
}

TEST_F(FrameFile, CountsThatNoFileCanHoldAreRefusedBeforeMemoryIsTaken) {
    auto damaged = file;
    const uint32_t huge = 0xffffffff;
    std::memcpy(damaged.data() + kRlfBlobTable, &huge, 4);
    sealDescription(damaged);
    EXPECT_NE(refusal(damaged).find("no room for 4294967295 blobs"), std::string::npos)
        << refusal(damaged);
}

// The message names the count that is wrong, not the place where reading on what follows as blobs
// came to an end.
TEST_F(FrameFile, ACountThatIsOneTooManyIsNamed) {
    auto damaged = file;
    const uint64_t left = kRlfHeader + rlfValue<uint64_t>(file, 24) - kRlfBlobTable -
                          sizeof(uint32_t);
    constexpr uint64_t kBytesOfABlob = 24;
    const uint32_t tooMany = uint32_t(left / kBytesOfABlob) + 1;
    std::memcpy(damaged.data() + kRlfBlobTable, &tooMany, sizeof tooMany);
    sealDescription(damaged);
    EXPECT_NE(refusal(damaged).find("no room for " + std::to_string(tooMany) + " blobs"),
              std::string::npos)
        << refusal(damaged);
}

TEST_F(FrameFile, TargetsThatNoFrameHasAreRefused) {
    auto frame = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(frame);
    frame->textures[1].desc.width = frame->textures[1].desc.height = 16384;
    frame->textures[1].desc.format = Format::rgba32f;
    EXPECT_NE(refusal(encodeFrame(*frame)).find("no frame of this size does"), std::string::npos);
}

TEST_F(FrameFile, IndicesBeyondTheVerticesAreRefused) {
    const auto refusalWith = [&](const std::array<uint32_t, 3>& indices) {
        small.writeIndices(indices);
        return refusal(encodeFrame(takeSnapshot(device, small.commands, small.target)));
    };
    EXPECT_EQ(refusalWith({2, 0, 1}), "accepted");
    EXPECT_EQ(refusalWith({0, 3, 1}),
              "a.rlf: pass 'shadow', command 7 (MultiDrawIndexed): Draw 1 of 1 reads the vertices "
              "up to 4 of the "
              "vertex stream 0, which has 3.");
    EXPECT_NE(refusalWith({0, 1, ~0u}).find("reads the vertices up to 4294967296"),
              std::string::npos);
}

TEST(IndexBounds, AreThoseOfALookAtEach) {
    Random random(1);
    std::vector<std::byte> bytes(1 + 4 * 1000 + 3);
    for (size_t i = 0; i < 1000; ++i) {
        const uint32_t index = random.below(1u << 20);
        std::memcpy(bytes.data() + 1 + 4 * i, &index, 4);
    }
    const auto indices = std::span<const std::byte>(bytes).subspan(1);
    const IndexBounds bounds(indices);
    for (int n = 0; n < 20000; ++n) {
        const size_t first = random.below(1000), count = 1 + random.below(uint32_t(1000 - first));
        uint32_t highest = 0;
        for (size_t i = first; i < first + count; ++i) {
            uint32_t index;
            std::memcpy(&index, indices.data() + 4 * i, 4);
            highest = std::max(highest, index);
        }
        ASSERT_EQ(bounds.highest(first, count), highest) << first << " " << count;
    }
}

TEST_F(FrameFile, ReplayGivesTheCommandsBack) {
    const auto frame = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(frame);
    MemoryDevice other;
    other.createTexture({}).value();
    const auto replay = FrameReplay::create(other, *frame);
    ASSERT_TRUE(replay) << replay.error().text();
    const auto image = (*replay)->run({.hashAttachments = true});
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->width, 4u);
    EXPECT_EQ(image->height, 2u);
    ASSERT_EQ((*replay)->hashes().size(), 2u);
    EXPECT_EQ((*replay)->hashes()[0].pass, "shadow");
    EXPECT_EQ((*replay)->hashes()[1].image, "painted");
    const auto stopped = (*replay)->run({.until = 1});
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->format, Format::depth32f) << "the shadow pass has no colour";
}

TEST_F(FrameFile, DiffNamesTheFirstCommandAndTheResources) {
    const auto a = decodeFrame(file, "a.rlf");
    ASSERT_TRUE(a);
    EXPECT_TRUE(diffFrames(*a, *a).empty());
    const auto changed = [&](auto&& change) {
        MemoryDevice other;
        SmallFrame frame(other);
        change(other, frame);
        const SavedFrame b = takeSnapshot(other, frame.commands, frame.target);
        const auto lines = diffFrames(*a, b);
        return lines.empty() ? std::string() : lines[0];
    };
    EXPECT_EQ(changed([](Device&, SmallFrame&) {}), "");
    EXPECT_EQ(changed([](Device&, SmallFrame& frame) { frame.commands.push(Readback{}); }),
              "number of commands: 20 | 21");
    EXPECT_EQ(changed([](Device&, SmallFrame& frame) {
                  CommandBuffer other;
                  other.append(frame.commands.data());
                  visitCommands(frame.commands, [&](auto command) {
                      if constexpr (std::is_same_v<decltype(command), Draw>)
                          command.vertexCount = 6;
                      other.push(command);
                  });
                  frame.commands = other;
              }),
              "command 18 Draw in pass 'paint', vertexCount: 3 | 6");
    EXPECT_EQ(changed([](Device& other, SmallFrame& frame) {
                  const std::byte one[] = {std::byte(77)};
                  other.write(frame.materials, 9, one);
              }),
              "buffer 3 \"materials\": its contents differ from byte 9 on");
    EXPECT_EQ(changed([](Device&, SmallFrame& frame) {
                  frame.commands.bytes({{}, 0, 512 + 4, 4})[0] = std::byte(1);
              }),
              "data block: differs from byte 516 on; first read by command 12 BindUniforms in pass "
              "'paint'");
}

}  // namespace
}  // namespace rushlight
