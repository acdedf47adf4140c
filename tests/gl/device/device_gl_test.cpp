// What commands do on OpenGL.

#include "renderer/backend/gl/gl_device.h"
#include "renderer/backend/gl/gl_functions.h"
#include "tests/support/gl/test_context.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint32_t kSize = 16;

constexpr const char* kTriangleVertex = R"(
void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.5, 1.0); }
)";

class DeviceGlTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
        shaders_.write("full.vert", kTriangleVertex);
        shaders_.write("color.frag",
                       "layout(std140, binding = 2) uniform Color { vec4 color; };\n"
                       "layout(location = 0) out vec4 result;\nvoid main() { result = color; }\n");
        shaders_.write("table.frag",
                       "layout(binding = 16) uniform samplerBuffer table;\n"
                       "layout(location = 0) out vec4 result;\n"
                       "void main() { result = texelFetch(table, 1); }\n");
        shaders_.write(
            "depth.frag",
            "layout(binding = 11) uniform sampler2D depth;\n"
            "layout(location = 0) out vec4 result;\n"
            "void main() { result = vec4(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r); }\n");
        shaders_.write("instance.vert",
                       "layout(location = 0) in vec3 position;\n"
                       "layout(location = 5) in vec4 row0;\nlayout(location = 6) in vec4 row1;\n"
                       "layout(location = 8) in uvec2 indices;\nflat out uint id;\n"
                       "void main() { id = indices.y;\n"
                       "  vec4 p = vec4(position, 1.0);\n"
                       "  gl_Position = vec4(dot(row0, p), dot(row1, p), 0.5, 1.0); }\n");
        shaders_.write("id.frag",
                       "flat in uint id;\nlayout(location = 0) out vec4 result;\n"
                       "void main() { result = vec4(float(id) / 255.0); }\n");
        auto device = createGlDevice(
            {.load = &TestContext::load, .shaderDirectory = shaders_.path(), .debugOutput = true});
        ASSERT_TRUE(device) << device.error().text();
        device_ = std::move(*device);
        target_ = texture("target", Format::rgba8);
    }
    void TearDown() override {
        if (!device_) return;
        device_->finish();
        for (const std::string& message : device_->takeDebugMessages())
            ADD_FAILURE() << "GL debug message: " << message;
    }

    TextureHandle texture(std::string_view label, Format format) {
        TextureDesc desc;
        desc.label = label;
        desc.format = format;
        desc.width = desc.height = kSize;
        return device_->createTexture(desc).value();
    }
    PipelineHandle pipeline(std::string_view fragment, PipelineDesc desc = {}) {
        if (desc.vertexShader.empty()) desc.vertexShader = "full.vert";
        desc.label = fragment;
        desc.fragmentShader = fragment;
        auto created = device_->createPipeline(desc);
        EXPECT_TRUE(created) << created.error().text();
        return created.value_or(PipelineHandle{});
    }
    void begin(uint32_t index, TextureHandle color, LoadOp load, vec4 clear = vec4(0),
               const char* name = "test pass") {
        BeginPass pass;
        std::strcpy(pass.name, name);
        pass.passIndex = index;
        pass.width = pass.height = kSize;
        pass.colorCount = color ? 1 : 0;
        pass.colors[0] = {color, 0, 0, load, {}, clear};
        pass.depth = depth_;
        commands_.push(pass);
    }
    void drawColor(vec4 color, PipelineHandle with) {
        const BufferRange range = commands_.append(std::span<const vec4>(&color, 1));
        commands_.push(SetPipeline{with});
        commands_.push(BindUniforms{2, 0, range});
        commands_.push(Draw{3, 1, 0});
    }
    /// Runs what was recorded and gives back texel (x, y) of `source`.
    std::array<uint8_t, 4> run(TextureHandle source, uint32_t x = 0, uint32_t y = 0) {
        commands_.push(Readback{source, 0, 0, ++ticket_});
        device_->execute(commands_, options_, report_);
        commands_.clear();
        ReadbackImage image;
        EXPECT_TRUE(device_->takeReadback(ticket_, true, image));
        std::array<uint8_t, 4> texel{};
        std::memcpy(texel.data(), image.bytes.data() + (size_t(y) * image.width + x) * 4, 4);
        return texel;
    }

    using Texel = std::array<uint8_t, 4>;
    TestContext context_;
    TemporaryDirectory shaders_;
    std::unique_ptr<Device> device_;
    TextureHandle target_;
    DepthAttachment depth_;
    CommandBuffer commands_;
    ExecuteOptions options_;
    ExecutionReport report_;
    uint32_t ticket_ = 0;
};

TEST_F(DeviceGlTest, PassClearsItsTarget) {
    begin(0, target_, LoadOp::clear, {1, 0, 0.2f, 1});
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_, 15, 15), (Texel{255, 0, 51, 255}));
}

TEST_F(DeviceGlTest, DrawReadsUniformsOfTheDataBlock) {
    const PipelineHandle color = pipeline("color.frag");
    for (uint32_t frame = 0; frame < 5; ++frame) {  // goes round the ring
        begin(0, target_, LoadOp::discard);
        drawColor(vec4(float(frame * 51) / 255.0f, 1, 0, 1), color);
        commands_.push(EndPass{0});
        EXPECT_EQ(run(target_), (Texel{uint8_t(frame * 51), 255, 0, 255}));
    }
    EXPECT_EQ(report_.passes[0].draws, 1u);
    EXPECT_EQ(report_.passes[0].triangles, 1u);
    EXPECT_GT(report_.glCalls, 0u);
}

TEST_F(DeviceGlTest, RingGrowsForALargeDataBlock) {
    const PipelineHandle color = pipeline("color.frag");
    for (int frame = 0; frame < 3; ++frame) {
        commands_.allocate(frame == 1 ? 5u << 20 : 16u);
        begin(0, target_, LoadOp::discard);
        drawColor({0, 0, 1, 1}, color);
        commands_.push(EndPass{0});
        EXPECT_EQ(run(target_), (Texel{0, 0, 255, 255}));
    }
}

TEST_F(DeviceGlTest, ScissorLimitsAndNextPassClearsAllAgain) {
    const PipelineHandle color = pipeline("color.frag");
    begin(0, target_, LoadOp::clear);
    commands_.push(SetScissor{0, 0, 4, 4});
    drawColor(vec4(1), color);
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_, 3, 3), (Texel{255, 255, 255, 255}));
    begin(0, target_, LoadOp::clear);
    commands_.push(SetScissor{0, 0, 4, 4});
    drawColor(vec4(1), color);
    commands_.push(EndPass{0});
    begin(1, target_, LoadOp::clear, vec4(0.2f));
    commands_.push(EndPass{1});
    EXPECT_EQ(run(target_, 12, 12), (Texel{51, 51, 51, 51}));
}

TEST_F(DeviceGlTest, TexelBufferReadsARange) {
    const PipelineHandle table = pipeline("table.frag");
    const vec4 rows[2] = {vec4(0), vec4(0, 1, 0, 1)};
    commands_.allocate(16);
    const BufferRange range = commands_.append(std::span<const vec4>(rows));
    begin(0, target_, LoadOp::discard);
    commands_.push(SetPipeline{table});
    commands_.push(BindTexelBuffer{16, Format::rgba32f, {}, range});
    commands_.push(Draw{3, 1, 0});
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_), (Texel{0, 255, 0, 255}));
}

TEST_F(DeviceGlTest, ATexelBuffersRangeMayGrowAndShrink) {
    const PipelineHandle table = pipeline("table.frag");
    const vec4 rows[2] = {vec4(0), vec4(0, 1, 0, 1)};
    const BufferHandle buffer = device_->createBuffer({"rows", sizeof rows, BufferUsage::texel})
                                    .value();
    device_->write(buffer, 0, std::as_bytes(std::span(rows)));
    for (const uint64_t size : {sizeof rows / 2, sizeof rows, sizeof rows / 2}) {
        begin(0, target_, LoadOp::discard);
        commands_.push(SetPipeline{table});
        commands_.push(BindTexelBuffer{16, Format::rgba32f, {}, {buffer, 0, 0, size}});
        commands_.push(Draw{3, 1, 0});
        commands_.push(EndPass{0});
        // What lies beyond the range is zero.
        EXPECT_EQ(run(target_)[1], size == sizeof rows ? 255 : 0);
    }
}

TEST_F(DeviceGlTest, DepthIsTestedReversedAndSampledInTheSamePass) {
    PipelineDesc tested;
    tested.depthTest = CompareOp::greater;
    const PipelineHandle sample = pipeline("depth.frag", tested);
    const TextureHandle depth = texture("depth", Format::depth32f);
    for (const float clear : {0.2f, 0.8f}) {  // the triangle lies at 0.5
        depth_ = {depth, 0, LoadOp::clear, 0, clear};
        begin(0, target_, LoadOp::clear, {1, 0, 0, 1});
        commands_.push(SetPipeline{sample});
        commands_.push(BindTexture{11, depth, {}});
        commands_.push(Draw{3, 1, 0});
        commands_.push(EndPass{0});
        EXPECT_EQ(run(target_), clear < 0.5f ? (Texel{51, 51, 51, 51}) : (Texel{255, 0, 0, 255}));
    }
}

TEST_F(DeviceGlTest, MultiDrawReadsInstancesFromTheirFirst) {
    PipelineDesc desc;
    desc.vertexShader = "instance.vert";
    desc.layout = VertexLayout::position;
    const PipelineHandle id = pipeline("id.frag", desc);
    const VertexPosition corners[3] = {{{-1, -1, 0}}, {{3, -1, 0}}, {{-1, 3, 0}}};
    const uint32_t indices[3] = {0, 1, 2};
    const BufferHandle vertices = device_->createBuffer({"corners", sizeof corners}).value();
    const BufferHandle index =
        device_->createBuffer({"indices", sizeof indices, BufferUsage::index}).value();
    device_->write(vertices, 0, std::as_bytes(std::span(corners)));
    device_->write(index, 0, std::as_bytes(std::span(indices)));
    InstanceData instances[2] = {};
    instances[0] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, 0, 10, 0, 0};
    instances[1] = {{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}, 0, 20, 0, 0};  // the right half
    const DrawIndexedCommand draws[2] = {{3, 1, 0, 0, 0}, {3, 1, 0, 0, 1}};
    const BufferRange instanceRange = commands_.append(std::span<const InstanceData>(instances));
    const BufferRange drawRange = commands_.append(std::span<const DrawIndexedCommand>(draws));
    begin(0, target_, LoadOp::clear);
    commands_.push(SetPipeline{id});
    commands_.push(SetVertexStream{0, 12, {vertices, 0, 0, sizeof corners}});
    commands_.push(SetVertexStream{3, sizeof(InstanceData), instanceRange});
    commands_.push(SetIndexStream{{index, 0, 0, sizeof indices}});
    commands_.push(MultiDrawIndexed{2, 2, drawRange});
    commands_.push(EndPass{0});
    commands_.push(Readback{target_, 0, 0, 100});
    EXPECT_EQ(run(target_, 2, 8), (Texel{10, 10, 10, 10}));
    ReadbackImage image;
    ASSERT_TRUE(device_->takeReadback(100, true, image));
    EXPECT_EQ(uint8_t(image.bytes[(8 * kSize + 12) * 4]), 20);
    EXPECT_EQ(report_.passes[0].draws, 2u);
}

// OpenGL gives the names of what was deleted again.
TEST_F(DeviceGlTest, ABufferInThePlaceOfADestroyedOneIsBoundAnew) {
    PipelineDesc desc;
    desc.vertexShader = "instance.vert";
    desc.layout = VertexLayout::position;
    const PipelineHandle id = pipeline("id.frag", desc);
    const VertexPosition corners[4] = {{{-1, -1, 0}}, {{3, -1, 0}}, {{-1, 3, 0}}, {{-1, -1, 0}}};
    const BufferHandle vertices = device_->createBuffer({"corners", sizeof corners}).value();
    device_->write(vertices, 0, std::as_bytes(std::span(corners)));
    // The first indices give nothing to be seen.
    for (const std::array<uint32_t, 3>& indices :
         {std::array{0u, 3u, 0u}, std::array{0u, 1u, 2u}}) {
        const BufferHandle index =
            device_->createBuffer({"indices", sizeof indices, BufferUsage::index}).value();
        device_->write(index, 0, std::as_bytes(std::span(indices)));
        InstanceData instance = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, 0, 10, 0, 0};
        const BufferRange range = commands_.append(std::span<const InstanceData>(&instance, 1));
        begin(0, target_, LoadOp::clear);
        commands_.push(SetPipeline{id});
        commands_.push(SetVertexStream{0, 12, {vertices, 0, 0, sizeof corners}});
        commands_.push(SetVertexStream{3, sizeof(InstanceData), range});
        commands_.push(SetIndexStream{{index, 0, 0, sizeof indices}});
        commands_.push(DrawIndexed{{3, 1, 0, 0, 0}});
        commands_.push(EndPass{0});
        EXPECT_EQ(run(target_, 8, 8)[0], indices[1] == 3 ? 0 : 10);
        device_->destroy(index);
    }
}

TEST_F(DeviceGlTest, HashesFollowTheContent) {
    const PipelineHandle color = pipeline("color.frag");
    options_.hashAttachments = true;
    uint64_t hashes[3];
    for (int i = 0; i < 3; ++i) {
        begin(0, target_, LoadOp::discard);
        drawColor(vec4(i == 2 ? 1 : 0), color);
        commands_.push(EndPass{0});
        run(target_);
        ASSERT_EQ(report_.passes[0].attachmentHashes.size(), 1u);
        hashes[i] = report_.passes[0].attachmentHashes[0];
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_NE(hashes[0], hashes[2]);
}

TEST_F(DeviceGlTest, StateIsDefaultAtExitWhateverItWasAtEntry) {
    GlFunctions gl;
    ASSERT_TRUE(gl.load(&TestContext::load));
    const GLenum names[] = {GL_CURRENT_PROGRAM,
                            GL_VERTEX_ARRAY_BINDING,
                            GL_DRAW_FRAMEBUFFER_BINDING,
                            GL_READ_FRAMEBUFFER_BINDING,
                            GL_UNIFORM_BUFFER_BINDING,
                            GL_PIXEL_PACK_BUFFER_BINDING,
                            GL_PIXEL_UNPACK_BUFFER_BINDING,
                            GL_DRAW_INDIRECT_BUFFER_BINDING,
                            GL_TEXTURE_BINDING_2D,
                            GL_SAMPLER_BINDING,
                            GL_BLEND,
                            GL_CULL_FACE,
                            GL_DEPTH_TEST,
                            GL_DEPTH_FUNC,
                            GL_DEPTH_WRITEMASK,
                            GL_SCISSOR_TEST,
                            GL_DEPTH_CLAMP,
                            GL_DITHER,
                            GL_POLYGON_OFFSET_FILL,
                            GL_CLIP_DEPTH_MODE,
                            GL_CLIP_ORIGIN,
                            GL_FRAMEBUFFER_SRGB,
                            GL_TEXTURE_CUBE_MAP_SEAMLESS,
                            GL_PACK_ALIGNMENT,
                            GL_UNPACK_ALIGNMENT,
                            GL_BLEND_SRC_RGB,
                            GL_BLEND_DST_RGB,
                            GL_CULL_FACE_MODE};
    const auto snapshot = [&] {
        std::vector<GLint> values;
        for (GLenum name : names) gl.GetIntegerv(name, &values.emplace_back(-1));
        return values;
    };
    const std::vector<GLint> before = snapshot();
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 1, 1);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.Enable(GL_FRAMEBUFFER_SRGB);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 3);
    gl.DepthMask(GL_FALSE);
    PipelineDesc desc;
    desc.blend = BlendMode::additive;
    desc.depthBias = 2;
    desc.depthClamp = true;
    desc.cull = CullMode::back;
    const PipelineHandle color = pipeline("color.frag", desc);
    begin(0, target_, LoadOp::clear);
    drawColor(vec4(1), color);
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_, 9, 9), (Texel{255, 255, 255, 255}));
    EXPECT_EQ(snapshot(), before);
}

TEST_F(DeviceGlTest, ColoursMultiplyWhatIsThereAndTheGreaterAlphaStays) {
    PipelineDesc desc;
    desc.blend = BlendMode::absorbing;
    const PipelineHandle absorbing = pipeline("color.frag", desc);
    desc.blend = BlendMode::additive;
    const PipelineHandle additive = pipeline("color.frag", desc);
    begin(0, target_, LoadOp::clear, {1, 1, 1, 0});
    drawColor({0.4f, 1, 0, 0.6f}, absorbing);
    drawColor({0.5f, 0.2f, 1, 0.2f}, absorbing);
    drawColor({0.2f, 0.2f, 0.2f, 0.2f}, additive);
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_), (Texel{102, 102, 51, 204}));
    GlFunctions gl;
    ASSERT_TRUE(gl.load(&TestContext::load));
    begin(0, target_, LoadOp::clear, {1, 1, 1, 0});
    drawColor(vec4(0.2f), absorbing);
    commands_.push(EndPass{0});
    run(target_);
    GLint equation = 0;
    gl.GetIntegerv(GL_BLEND_EQUATION_ALPHA, &equation);
    EXPECT_EQ(equation, GL_FUNC_ADD) << "what the host finds";
}

TEST_F(DeviceGlTest, TheSecondOutputFiltersWhatIsThere) {
    shaders_.write("filter.frag",
                   "layout(std140, binding = 2) uniform B { vec4 color; };\n"
                   "layout(location = 0, index = 0) out vec4 added;\n"
                   "layout(location = 0, index = 1) out vec4 kept;\n"
                   "void main() { added = vec4(0.2, 0.0, 0.2, 0.4); kept = color; }\n");
    PipelineDesc desc;
    desc.blend = BlendMode::filtered;
    const PipelineHandle filtered = pipeline("filter.frag", desc);
    begin(0, target_, LoadOp::clear, {1, 0.8f, 0.4f, 0.5f});
    drawColor({0.2f, 0.5f, 0, 0.8f}, filtered);
    commands_.push(EndPass{0});
    EXPECT_EQ(run(target_), (Texel{102, 102, 51, 204}));
}

TEST_F(DeviceGlTest, TimersSeePasses) {
    const PipelineHandle color = pipeline("color.frag");
    double gpuMs = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < 4; ++frame) {
        begin(0, target_, LoadOp::clear);
        drawColor(vec4(1), color);
        commands_.push(EndPass{0});
        run(target_);
        gpuMs = report_.passes[0].gpuMs;
    }
    EXPECT_GT(gpuMs, 0.0);
    // In milliseconds: no pass takes longer than all frames together.
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - start;
    EXPECT_LT(gpuMs, all.count());
}

// A frame's times come from an earlier one, which may have had other passes.
TEST_F(DeviceGlTest, TimersGoByThePassesNames) {
    const PipelineHandle color = pipeline("color.frag");
    const auto draw = [&](std::initializer_list<const char*> passes) {
        uint32_t index = 0;
        for (const char* name : passes) {
            begin(index, target_, LoadOp::clear, vec4(0), name);
            drawColor(vec4(1), color);
            commands_.push(EndPass{index++});
        }
        run(target_);
    };
    for (int frame = 0; frame < 4; ++frame) draw({"shadow", "lighting"});
    draw({"lighting", "fog"});
    EXPECT_GT(report_.passes[0].gpuMs, 0.0);
    EXPECT_EQ(report_.passes[1].gpuMs, 0.0) << "no frame that is finished has had it";
}

void* withoutOneFunction(const char* name) {
    return std::strcmp(name, "glTextureBufferRange") == 0 ? nullptr : TestContext::load(name);
}

TEST_F(DeviceGlTest, MissingFunctionIsNamed) {
    const auto device = createGlDevice({.load = &withoutOneFunction});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, ErrorKind::noContext);
    EXPECT_NE(device.error().message.find("glTextureBufferRange"), std::string::npos);
}

}  // namespace
}  // namespace rushlight
