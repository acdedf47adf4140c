// A frame that is saved, read and played on a device of its own gives the bytes of the frame that
// was drawn.

#include "renderer/backend/gl/gl_device.h"
#include "renderer/replay/replay.h"
#include "renderer/replay/texel_picture.h"
#include "renderer/rhi/commands/validate_commands.h"
#include "renderer/rhi/saved/frame_diff.h"
#include "renderer/rhi/saved/frame_file.h"
#include "renderer/testing/scene_frames.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace rushlight {
namespace {

constexpr const char* kContent = RUSHLIGHT_SOURCE "/content/";

class ReplayGl : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context.valid());
        RendererDesc desc;
        desc.loadGl = TestContext::load;
        desc.validateCommands = true;
        auto made = Renderer::create(desc);
        ASSERT_TRUE(made) << made.error().text();
        renderer = std::move(*made);
    }

    static SavedFrame decoded(std::vector<std::byte> file) {
        auto frame = decodeFrame(std::move(file), "test.rlf");
        EXPECT_TRUE(frame) << (frame ? "" : frame.error().text());
        return frame ? std::move(*frame) : SavedFrame{};
    }

    /// Draws and saves a frame of `scene`; what replay gives must be what the renderer gave.
    void saveAndReplay(RandomScene& scene, uint32_t index, CaptureKind kind) {
        saveAndReplay(scene.frame(index), kind);
    }
    void saveAndReplay(const FrameInput& input, CaptureKind kind) {
        std::vector<std::byte> file;
        FrameOptions options;
        options.savedFrame = &file;
        options.hashPasses = true;
        const auto ticket = renderer->renderOffscreen(input, 96, 64, kind, options);
        ASSERT_TRUE(ticket) << ticket.error().text();
        CapturedImage image;
        ASSERT_TRUE(renderer->takeCapture(*ticket, true, image));
        expectReplay(std::move(file), image);
    }

    void expectReplay(std::vector<std::byte> file, const CapturedImage& image) {
        const SavedFrame frame = decoded(std::move(file));
        auto device = createGlDevice({.load = TestContext::load, .debugOutput = true});
        ASSERT_TRUE(device) << device.error().text();
        const auto replay = FrameReplay::create(**device, frame);
        ASSERT_TRUE(replay) << replay.error().text();
        // Twice: the contents are put back before each.
        for (int run = 0; run < 2; ++run) {
            const auto again = (*replay)->run({.hashAttachments = true});
            ASSERT_TRUE(again) << again.error().text();
            const TexelPicture picture = exactPicture(*again, (*replay)->topRowFirst());
            EXPECT_TRUE(picture.rgba8 == image.rgba8);
            EXPECT_TRUE(picture.rgba32f == image.rgba32f);
            expectHashes(**replay);
        }
        for (const std::string& message : (*device)->takeDebugMessages())
            ADD_FAILURE() << "GL debug message: " << message;
        ++replayed;
    }

    /// Every attachment of every pass, under the names that the frame reports.
    void expectHashes(const FrameReplay& replay) {
        std::vector<std::string> wanted, found;
        for (const PassReport& pass : renderer->report().passes)
            for (size_t i = 0; i < pass.hashes.size() && i < pass.writes.size(); ++i)
                wanted.push_back(std::string(pass.name) + " " + pass.writes[i] + " " +
                                 std::to_string(pass.hashes[i]));
        for (const AttachmentHash& line : replay.hashes())
            found.push_back(line.pass + " " + line.image + " " + std::to_string(line.hash));
        EXPECT_EQ(found, wanted);
    }

    TestContext context;
    std::unique_ptr<Renderer> renderer;
    uint32_t replayed = 0;
};

// Seeds with and without shadows, clustered lights, an environment and automatic exposure; later
// frames of a scene keep shadow maps and the exposure of earlier ones.
TEST_F(ReplayGl, RandomScenesGiveTheSameBytes) {
    uint32_t cached = 0;
    for (uint64_t seed : {1, 2, 3, 4, 6, 7}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomScene scene(*renderer, seed);
        for (uint32_t frame : {0, 1, 1}) {
            saveAndReplay(scene, frame, frame ? CaptureKind::display : CaptureKind::hdr);
            cached += renderer->report().shadowViewsCached;
        }
    }
    EXPECT_GE(replayed, 18u);
    EXPECT_GT(cached, 0u) << "no frame used a shadow map of an earlier one";
}

// Drawn, kept, and drawn in part: the panes' maps hold what an earlier frame left.
TEST_F(ReplayGl, ColouredShadowsGiveTheSameBytes) {
    const MeshHandle cube = renderer->createMesh(makeCube().desc()).value();
    MaterialDesc glass;
    glass.metallic = 0;
    glass.transmission = 0.9f;
    const auto box = [&](vec3 center, vec3 half, vec3 color, bool seeThrough) {
        glass.baseColor = vec4(color, 1);
        glass.transmission = seeThrough ? 0.9f : 0.0f;
        Instance instance;
        instance.mesh = cube;
        instance.material = renderer->createMaterial(glass).value();
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= half[c];
        instance.worldFromLocal[3] = center;
        return instance;
    };
    std::vector<Instance> instances{
        box({0, -0.1f, 0}, {4, 0.1f, 4}, vec3(0.8f), false),
        box({0.5f, 1, 0}, {0.5f, 0.02f, 0.5f}, {0.9f, 0.2f, 0.1f}, true),
        box({0, 1.5f, 0}, {0.5f, 0.02f, 0.5f}, {0.1f, 0.8f, 0.3f}, true)};
    DirectionalLight sun;
    sun.direction = glm::normalize(vec3(0.2f, -1, 0.1f));
    PunctualLight lamp;
    lamp.position = {-1, 2.5f, 1};
    lamp.intensity = vec3(5);
    lamp.castsShadow = true;
    FrameInput input;
    input.instances = instances;
    input.lighting.directional = {&sun, 1};
    input.lighting.punctual = {&lamp, 1};
    input.settings.lightShadows = true;
    input.settings.shadowAtlasSize = 512;
    input.settings.shadowTileSize = 128;
    input.settings.shadowResolution = 256;
    input.view.viewFromWorld = glm::lookAt(vec3(2, 3, 5), vec3(0, 0.5f, 0), vec3(0, 1, 0));
    for (int frame = 0; frame < 3; ++frame) {
        if (frame == 2) instances[1].worldFromLocal[3].x -= 0.2f;
        saveAndReplay(input, CaptureKind::hdr);
    }
    EXPECT_EQ(replayed, 3u);
    EXPECT_GT(renderer->report().shadowViewsCached, 0u);
    EXPECT_GT(renderer->report().shadowViewsDrawn, 0u);
}

TEST_F(ReplayGl, ScenesGiveTheSameBytes) {
    for (const char* name : {"testcard/testcard.gltf", "square/square.gltf"}) {
        SCOPED_TRACE(name);
        const auto frames = SceneFrames::open(*renderer, std::string(kContent) + name,
                                              std::string(kContent) + "square/dusk.hdr");
        ASSERT_TRUE(frames) << frames.error().text();
        SceneView view;
        view.settings.autoExposure = true;
        ASSERT_TRUE((*frames)->render(view));
        std::vector<std::byte> file;
        FrameOptions options;
        options.savedFrame = &file;
        options.hashPasses = true;
        const auto image = (*frames)->render(view, options);
        ASSERT_TRUE(image) << image.error().text();
        EXPECT_GT(renderer->report().shadowViewsCached, 0u);
        expectReplay(std::move(file), *image);
    }
    EXPECT_EQ(replayed, 2u);
}

TEST_F(ReplayGl, SavingTwiceGivesTheSameFileAndChangesNoPicture) {
    RandomScene scene(*renderer, 3);
    std::vector<std::byte> files[2];
    CapturedImage images[3];
    for (size_t i = 0; i < 3; ++i) {
        scene.settings.autoExposure = false;
        FrameOptions options;
        if (i < 2) options.savedFrame = &files[i];
        scene.settings.shadowCaching = false;
        const auto ticket = renderer->renderOffscreen(scene.frame(2), 96, 64, CaptureKind::display,
                                                      options);
        ASSERT_TRUE(ticket);
        ASSERT_TRUE(renderer->takeCapture(*ticket, true, images[i]));
    }
    EXPECT_TRUE(files[0] == files[1]);
    EXPECT_TRUE(images[0].rgba8 == images[2].rgba8) << "saving changed the frame";
    EXPECT_TRUE(diffFrames(decoded(files[0]), decoded(files[1])).empty());
}

TEST_F(ReplayGl, AFrameIntoTheHostsFramebufferIsReplayedIntoAnImage) {
    RandomScene scene(*renderer, 3);
    CapturedImage image;
    const auto ticket = renderer->renderOffscreen(scene.frame(1), 96, 64, CaptureKind::display);
    ASSERT_TRUE(ticket);
    ASSERT_TRUE(renderer->takeCapture(*ticket, true, image));
    for (const bool topRowFirst : {false, true}) {
        SCOPED_TRACE(topRowFirst);
        // The same commands on a device that draws nothing: what counts is what is in the file.
        std::vector<std::byte> file;
        FrameOptions options;
        options.savedFrame = &file;
        scene.settings.shadowCaching = false;
        ASSERT_TRUE(renderer->render(scene.frame(1), {0, 96, 64, topRowFirst}, options));
        const SavedFrame frame = decoded(std::move(file));
        auto device = createGlDevice({.load = TestContext::load});
        ASSERT_TRUE(device);
        const auto replay = FrameReplay::create(**device, frame);
        ASSERT_TRUE(replay) << replay.error().text();
        const auto again = (*replay)->run({});
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ((*replay)->topRowFirst(), topRowFirst);
        const TexelPicture picture = exactPicture(*again, topRowFirst);
        size_t different = 0;
        for (size_t i = 0; i < image.rgba8.size(); ++i)
            different += std::abs(int(picture.rgba8[i]) - int(image.rgba8[i])) > 2;
        EXPECT_LT(different, image.rgba8.size() / 100);
    }
}

TEST_F(ReplayGl, UntilShowsTheTargetOfThePassInWhichItStops) {
    RandomScene scene(*renderer, 3);
    std::vector<std::byte> file;
    FrameOptions options;
    options.savedFrame = &file;
    ASSERT_TRUE(renderer->renderOffscreen(scene.frame(0), 96, 64, CaptureKind::display, options));
    const SavedFrame frame = decoded(std::move(file));
    auto device = createGlDevice({.load = TestContext::load});
    ASSERT_TRUE(device);
    const auto replay = FrameReplay::create(**device, frame);
    ASSERT_TRUE(replay);
    uint32_t number = 0;
    std::vector<std::pair<uint32_t, Format>> stops;
    visitCommands(frame.commands, [&]<class Command>(const Command& command) {
        ++number;
        if constexpr (std::is_same_v<Command, BeginPass>) {
            const TextureHandle shown = command.colorCount ? command.colors[0].texture
                                                           : command.depth.texture;
            stops.emplace_back(number, frame.describe(shown)->format);
        }
    });
    ASSERT_GT(stops.size(), 4u);
    for (const auto& [until, format] : stops) {
        const auto image = (*replay)->run({.until = until});
        ASSERT_TRUE(image) << image.error().text();
        EXPECT_EQ(image->format, format) << until;
        EXPECT_EQ(visiblePicture(*image, false).rgba8.size(),
                  size_t(image->width) * image->height * 4);
    }
}

TEST_F(ReplayGl, UntilLeavesOutWhatComesAfter) {
    RandomScene scene(*renderer, 3);
    std::vector<std::byte> file;
    FrameOptions options;
    options.savedFrame = &file;
    uint32_t index = 0;
    do {
        const FrameInput input = scene.frame(index++);
        ASSERT_TRUE(renderer->renderOffscreen(input, 96, 64, CaptureKind::display, options));
    } while (renderer->report().visible < 20 && index < 9);
    const SavedFrame frame = decoded(std::move(file));
    auto device = createGlDevice({.load = TestContext::load});
    ASSERT_TRUE(device);
    const auto replay = FrameReplay::create(**device, frame);
    ASSERT_TRUE(replay);
    // From the pass's beginning, where its target is clear, to its end.
    uint32_t number = 0, begin = 0, end = 0;
    visitCommands(frame.commands, [&]<class Command>(const Command& command) {
        ++number;
        if constexpr (std::is_same_v<Command, BeginPass>)
            if (std::string_view(command.name) == "gbuffer") begin = number;
        if constexpr (std::is_same_v<Command, EndPass>)
            if (begin && !end) end = number;
    });
    const auto covered = [&](uint32_t until) {
        const auto image = (*replay)->run({.until = until});
        EXPECT_TRUE(image);
        return image ? image->bytes.size() - size_t(std::ranges::count(image->bytes, std::byte(0)))
                     : 0;
    };
    EXPECT_EQ(covered(begin), 0u);
    size_t before = 0, steps = 0;
    for (uint32_t until = begin; until <= end; ++until) {
        const size_t now = covered(until);
        EXPECT_GE(now, before);
        steps += now > before;
        before = now;
    }
    EXPECT_GE(steps, 3u) << "draws appear one after the other";
}

TEST_F(ReplayGl, ProgramsTellWhatTheyRead) {
    TemporaryDirectory shaders;
    shaders.write("a.vert",
                  "layout(std140, binding = 0) uniform View { mat4 view; vec4 unused[3]; };\n"
                  "void main() { gl_Position = view[0]; }\n");
    shaders.write("a.frag",
                  "layout(binding = 5) uniform sampler2DArrayShadow shadow;\n"
                  "layout(binding = 6) uniform samplerCube cube;\n"
                  "layout(binding = 7) uniform sampler2D unusedTexture;\n"
                  "layout(binding = 16) uniform usamplerBuffer table;\n"
                  "layout(location = 0) out vec4 result;\n"
                  "void main() { result = texture(cube, vec3(1)) * texture(shadow, vec4(0)) +\n"
                  "                       vec4(texelFetch(table, 0)); }\n");
    auto device = createGlDevice({.load = TestContext::load, .shaderDirectory = shaders.path()});
    ASSERT_TRUE(device);
    PipelineDesc desc;
    desc.label = "a";
    desc.vertexShader = "a.vert";
    desc.fragmentShader = "a.frag";
    const auto pipeline = (*device)->createPipeline(desc);
    ASSERT_TRUE(pipeline) << pipeline.error().text();
    const PipelineSlots* slots = (*device)->slots(*pipeline);
    ASSERT_TRUE(slots);
    EXPECT_EQ(slots->uniformBytes[0], 64u + 48u);
    EXPECT_EQ(slots->uniformBytes[1], 0u);
    EXPECT_EQ(slots->textures[5], SampledAs::texture2dArray);
    EXPECT_TRUE(slots->compares[5]);
    EXPECT_EQ(slots->textures[6], SampledAs::cube);
    EXPECT_FALSE(slots->compares[6]);
    EXPECT_EQ(slots->textures[7], SampledAs::nothing);
    EXPECT_EQ(slots->textures[16], SampledAs::integerTexels);

    // The sources that it describes make the same pipeline with no shader files.
    const auto described = (*device)->describe(*pipeline);
    ASSERT_TRUE(described);
    EXPECT_EQ(described->label, "a");
    auto bare = createGlDevice({.load = TestContext::load});
    ASSERT_TRUE(bare);
    const auto copy = (*bare)->createPipeline(*described);
    ASSERT_TRUE(copy) << copy.error().text();
    EXPECT_EQ((*bare)->slots(*copy)->textures, slots->textures);
    EXPECT_EQ(*(*bare)->reloadShaders(), 0u);
}

TEST_F(ReplayGl, DevicesReadWhatWasWritten) {
    auto device = createGlDevice({.load = TestContext::load});
    ASSERT_TRUE(device);
    Device& d = **device;
    const BufferHandle buffer = *d.createBuffer({"buffer", 16, BufferUsage::texel});
    std::array<std::byte, 16> bytes, back{};
    for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i + 1);
    d.write(buffer, 0, bytes);
    d.read(buffer, 4, std::span(back).first(8));
    EXPECT_EQ(back[0], std::byte(5));
    EXPECT_EQ(back[7], std::byte(12));
    EXPECT_EQ(d.describe(buffer)->usage, BufferUsage::texel);

    for (const TextureKind kind :
         {TextureKind::texture2dArray, TextureKind::cube, TextureKind::cubeArray}) {
        const uint32_t layers = kind == TextureKind::cube        ? 6
                                : kind == TextureKind::cubeArray ? 12
                                                                 : 3;
        const TextureHandle texture = *d.createTexture({"t", kind, Format::r8, 3, 3, layers, 2});
        std::vector<std::byte> all(size_t(9) * layers);
        for (size_t i = 0; i < all.size(); ++i) all[i] = std::byte(i);
        d.write(texture, {0, 0, layers, 3, 3}, all);
        std::array<std::byte, 9> layer{};
        d.read(texture, 0, 2, layer);
        EXPECT_EQ(layer[8], std::byte(26));
        EXPECT_EQ(d.describe(texture)->layers, layers);
        d.destroy(texture);
        EXPECT_FALSE(d.describe(texture));
    }
}

}  // namespace
}  // namespace rushlight
