#pragma once
// A frame with one of everything that a file can hold, small enough to be damaged at every bit.

#include "renderer/rhi/device.h"
#include "shaders/interop/bindings.h"

#include <array>
#include <cstring>

namespace rushlight {

struct SmallFrame {
    Device& device;
    BufferHandle vertices, indices, materials;
    TextureHandle painted, pictures, shadows;
    SamplerHandle sampler;
    PipelineHandle surface, fullscreen;
    CommandBuffer commands;
    FrameTarget target{0, 4, 2};

    explicit SmallFrame(Device& on) : device(on) {
        vertices = buffer("vertices", 36);
        indices = buffer("indices", 12);
        writeIndices({0, 1, 2});
        materials = buffer("materials", 256);
        painted = texture({"painted", TextureKind::texture2d, Format::rgba8, 4, 2, 1, 1});
        pictures = texture({"pictures", TextureKind::texture2dArray, Format::rgba8, 2, 2, 2, 2});
        shadows = texture({"shadows", TextureKind::texture2dArray, Format::depth32f, 2, 2, 2, 1});
        sampler = device.createSampler({.maxAnisotropy = 4});
        surface = pipeline("surface", VertexLayout::position);
        fullscreen = pipeline("fullscreen", VertexLayout::none);
        record();
    }

    void begin(const char* name, uint32_t index, TextureHandle color, TextureHandle depth,
               uint32_t layer) {
        BeginPass pass;
        std::strcpy(pass.name, name);
        pass.passIndex = index;
        pass.width = 4;
        pass.height = 2;
        pass.colorCount = color ? 1 : 0;
        pass.colors[0].texture = color;
        pass.depth = {depth, uint16_t(layer), LoadOp::clear, 0, 0};
        commands.push(pass);
        for (const TextureHandle written : {color, depth})
            if (written) declare(written, true);
    }
    void writeIndices(const std::array<uint32_t, 3>& values) {
        device.write(indices, 0, std::as_bytes(std::span(values)));
    }
    void declare(TextureHandle texture, bool write) {
        DeclareImage image{texture, write, {}};
        std::strcpy(image.name, texture == shadows ? "shadows" : "painted");
        commands.push(image);
    }

private:
    BufferHandle buffer(std::string_view label, uint64_t size) {
        const BufferHandle made = device.createBuffer({label, size, BufferUsage::vertex}).value();
        std::vector<std::byte> bytes(size);
        for (size_t i = 0; i < size; ++i) bytes[i] = std::byte(i * label.size());
        device.write(made, 0, bytes);
        return made;
    }
    TextureHandle texture(const TextureDesc& desc) {
        const TextureHandle made = device.createTexture(desc).value();
        for (uint32_t level = 0; level < desc.mipLevels; ++level) {
            const TextureRegion all{level, 0, desc.layers, mipSize(desc.width, level),
                                    mipSize(desc.height, level)};
            std::vector<std::byte> bytes(imageBytes(desc, level) * desc.layers);
            for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i + level);
            device.write(made, all, bytes);
        }
        return made;
    }
    PipelineHandle pipeline(std::string_view label, VertexLayout layout) {
        PipelineDesc desc;
        desc.label = label;
        desc.vertexShader = "small.vert";
        desc.fragmentShader = "small.frag";
        desc.vertexSource = "void main() { gl_Position = vec4(0); }\n";
        desc.fragmentSource = "void main() {}\n";
        desc.layout = layout;
        return device.createPipeline(desc).value();
    }

    // A pass into one layer of the shadows, whose other layer is kept; one that samples both; a
    // readback.
    void record() {
        const InstanceData instance{};
        const DrawIndexedCommand draw{3, 1, 0, 0, 0};
        const vec4 color(1, 2, 3, 4);
        const BufferRange instances = commands.append(std::span(&instance, 1));
        const BufferRange draws = commands.append(std::span(&draw, 1));
        const BufferRange uniforms = commands.append(std::span(&color, 1));
        begin("shadow", 0, {}, shadows, 0);
        commands.push(SetPipeline{surface});
        commands.push(SetIndexStream{{indices, 0, 0, 0}});
        commands.push(SetVertexStream{RL_STREAM_POSITION, 12, {vertices, 0, 0, 0}});
        commands.push(SetVertexStream{RL_STREAM_INSTANCE, sizeof(InstanceData), instances});
        commands.push(MultiDrawIndexed{1, 1, draws});
        commands.push(EndPass{0});
        begin("paint", 1, painted, {}, 0);
        declare(shadows, false);
        commands.push(BindUniforms{RL_UNIFORMS_PASS, 0, uniforms});
        commands.push(
            BindTexelBuffer{RL_TEXTURE_MATERIALS, Format::rgba32ui, {}, {materials, 0, 0, 256}});
        commands.push(BindTexture{RL_TEXTURE_SHADOW, shadows, sampler});
        commands.push(BindTexture{RL_TEXTURE_BASE_COLOR, pictures, sampler});
        commands.push(SetPipeline{fullscreen});
        commands.push(SetScissor{0, 0, 2, 2});
        commands.push(Draw{3, 1, 0});
        commands.push(EndPass{1});
        commands.push(Readback{painted, 0, 0, 41});
    }
};

}  // namespace rushlight
