#include "renderer/backend/null/null_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace rushlight {
namespace {

TextureDesc targetDesc() {
    TextureDesc desc;
    desc.label = "target";
    desc.width = 8;
    desc.height = 4;
    return desc;
}

TEST(CommandBuffer, UploadsAreAlignedAndKeepTheirBytes) {
    CommandBuffer buffer;
    const uint32_t words[3] = {1, 2, 3};
    const BufferRange first = buffer.append(std::span<const uint32_t>(words));
    const BufferRange second = buffer.append(std::span<const uint32_t>(words, 2));
    const BufferRange tight = buffer.allocate(4, 4);
    EXPECT_EQ(first.offset, 0u);
    EXPECT_EQ(first.size, 12u);
    EXPECT_EQ(second.offset, 256u);
    EXPECT_EQ(tight.offset, 264u);
    EXPECT_EQ(buffer.data().size(), 268u);
    EXPECT_EQ(std::memcmp(buffer.bytes(first).data(), words, 12), 0);
    EXPECT_EQ(std::memcmp(buffer.bytes(second).data(), words, 8), 0);
}

// Else a saved frame would hold something of the frames before.
TEST(CommandBuffer, WhatLiesBetweenUploadsIsZero) {
    CommandBuffer commands;
    std::ranges::fill(commands.bytes(commands.allocate(1000)), std::byte(0xab));
    commands.clear();
    const BufferRange first = commands.allocate(3), second = commands.allocate(5);
    for (uint64_t i = first.offset + first.size; i < second.offset; ++i)
        ASSERT_EQ(commands.data()[i], std::byte{}) << i;
}

TEST(CommandBuffer, CommandsComeBackInOrderAcrossAppends) {
    CommandBuffer frame, part;
    part.push(Draw{3, 2, 1});
    BeginPass pass;
    std::strcpy(pass.name, "first");
    frame.push(pass);
    frame.append(part);
    frame.push(EndPass{});
    EXPECT_EQ(print(frame),
              "BeginPass 0 \"first\" 0x0\n  Draw vertices=3 instances=2 first=1\nEndPass 0\n");
    frame.clear();
    EXPECT_TRUE(frame.commandBytes().empty());
}

TEST(NullDevice, CountsDrawsTrianglesAndUploads) {
    const auto device = createNullDevice();
    const PipelineHandle pipeline =
        device->createPipeline({.vertexShader = "a.vert", .fragmentShader = "a.frag"}).value();
    const TextureHandle target = device->createTexture(targetDesc()).value();
    CommandBuffer commands;
    const BufferRange indirect = commands.allocate(3 * sizeof(DrawIndexedCommand));
    BeginPass pass;
    pass.passIndex = 1;
    pass.colorCount = 1;
    pass.colors[0].texture = target;
    commands.push(pass);
    commands.push(SetPipeline{pipeline});
    commands.push(Draw{6, 10, 0});
    commands.push(DrawIndexed{{12, 2, 0, 0, 0}});
    commands.push(MultiDrawIndexed{3, 100, indirect});
    commands.push(EndPass{1});
    ExecutionReport report;
    for (int frame = 0; frame < 2; ++frame) device->execute(commands, {}, report);
    ASSERT_EQ(report.passes.size(), 2u);
    EXPECT_EQ(report.passes[1].draws, 5u);
    EXPECT_EQ(report.passes[1].triangles, 20u + 8u + 100u);
    EXPECT_EQ(report.glCalls, 6u);
    EXPECT_EQ(report.uploadedBytes, 60u);
}

TEST(NullDevice, ReadbacksAreZeroedAndTakenOnce) {
    const auto device = createNullDevice();
    const TextureHandle target = device->createTexture(targetDesc()).value();
    CommandBuffer commands;
    commands.push(Readback{target, 0, 0, 7});
    ExecutionReport report;
    device->execute(commands, {}, report);
    ReadbackImage image;
    EXPECT_FALSE(device->takeReadback(6, true, image));
    ASSERT_TRUE(device->takeReadback(7, false, image));
    EXPECT_EQ(image.width, 8u);
    EXPECT_EQ(image.height, 4u);
    ASSERT_EQ(image.bytes.size(), 128u);
    EXPECT_TRUE(std::ranges::all_of(image.bytes, [](std::byte b) { return b == std::byte(0); }));
    EXPECT_FALSE(device->takeReadback(7, false, image));
}

TEST(NullDevice, BadDescriptionsAreErrorsThatNameTheLabel) {
    const auto device = createNullDevice();
    TextureDesc desc = targetDesc();
    desc.width = 20000;
    const auto large = device->createTexture(desc);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().text(),
              "target: A texture of 20000x4 texels is over the limit of 16384 texels a side.");
    desc.width = 0;
    EXPECT_FALSE(device->createTexture(desc));
    desc = targetDesc();
    desc.mipLevels = 5;
    EXPECT_FALSE(device->createTexture(desc));
    EXPECT_FALSE(device->createBuffer({.label = "empty"}));
    EXPECT_FALSE(device->createPipeline({.label = "no shaders"}));
}

TEST(NullDevice, EqualSamplersShareAHandle) {
    const auto device = createNullDevice();
    const SamplerHandle first = device->createSampler({});
    EXPECT_EQ(first, device->createSampler({}));
    EXPECT_NE(first, device->createSampler({.useMipmaps = false}));
}

TEST(NullDeviceDeathTest, StaleHandlesAreRefused) {
    const auto device = createNullDevice();
    const TextureHandle target = device->createTexture(targetDesc()).value();
    device->destroy(target);
    CommandBuffer commands;
    commands.push(BindTexture{0, target, {}});
    ExecutionReport report;
    EXPECT_DEATH(device->execute(commands, {}, report), "a texture that does not exist");
}

}  // namespace
}  // namespace rushlight
