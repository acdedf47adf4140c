// What OpenGL refuses, seeded: each call of a kind once, from the making of a renderer to the
// picture of a frame with something of everything. Each must end as an Error that names what could
// not be had; tried again, the renderer works.

#include "renderer/backend/gl/gl_functions.h"
#include "renderer/lighting/irradiance_volume.h"
#include "renderer/renderer.h"
#include "tests/support/gl/faulty_gl.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <thread>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 64, kHeight = 36;

/// A host that tries each thing again once that failed.
class PatientHost {
public:
    PatientHost(const std::string& cache, bool everything)
        : cache_(cache), everything_(everything) {}

    std::vector<Error> errors;
    CapturedImage image;
    std::unique_ptr<Renderer> renderer;

    /// No: something failed twice.
    bool run() { return makeRenderer() && makeResources() && draw() && draw(); }

private:
    /// `f` returns a Result.
    template <class F>
    auto twice(F&& f) {
        auto result = f();
        if (!result) {
            errors.push_back(result.error());
            result = f();
        }
        return result;
    }

    bool makeRenderer() {
        RendererDesc desc;
        desc.loadGl = FaultyGl::load;
        desc.cacheDirectory = cache_;
        desc.debugOutput = true;
        desc.validateCommands = true;
        auto made = twice([&] { return Renderer::create(desc); });
        if (made) renderer = std::move(*made);
        return renderer != nullptr;
    }

    template <class T, class F>
    bool make(T& handle, F&& f) {
        const auto made = twice(f);
        if (made) handle = *made;
        return made.has_value();
    }

    bool makeResources() {
        const Shape cube = makeCube(), ball = makeSphere(6, 9);
        MeshDesc painted = ball.desc("painted");
        const std::vector<vec4> colors(ball.positions.size(), vec4(1, 0.5f, 0.5f, 1));
        painted.colors = colors;
        const std::vector<uint8_t> small(4 * 4 * 4, 200), large(8 * 8 * 4, 90);
        ImageHandle images[2];
        bool all = make(box_, [&] { return renderer->createMesh(cube.desc("box")); }) &&
                   make(ball_, [&] { return renderer->createMesh(painted); }) &&
                   make(images[0],
                        [&] {
                            return renderer->createImage({"small", 4, 4, true, small});
                        }) &&
                   make(images[1], [&] {
                       return renderer->createImage({"large", 8, 8, false, large});
                   });
        MaterialDesc desc;
        desc.label = "stone";
        desc.metallic = 0;
        desc.baseColorTexture.image = images[0];
        desc.metallicRoughnessTexture.image = images[1];
        all = all && make(stone_, [&] { return renderer->createMaterial(desc); });
        MaterialDesc pane;
        pane.label = "pane";
        pane.transmission = everything_ ? 0.5f : 0.0f;
        pane.alphaMode = everything_ ? AlphaMode::opaque : AlphaMode::blend;
        pane.baseColor = {0.5f, 1, 0.5f, 0.5f};
        all = all && make(pane_, [&] { return renderer->createMaterial(pane); });
        return all && (!everything_ || makeLightResources());
    }

    bool makeLightResources() {
        const std::vector<vec3> sky(8 * 4, vec3(0.3f, 0.4f, 0.6f));
        const float vertical[] = {0, 90}, horizontal[] = {0}, candela[] = {2, 1};
        IrradianceVolume volume = makeIrradianceVolume({vec3(-4, -2, -4), vec3(4), glm::uvec3(2)});
        return make(sky_,
                    [&] {
                        return renderer->createEnvironment({"sky", 8, 4, sky});
                    }) &&
               make(web_,
                    [&] {
                        return renderer->createLightProfile({"web", vertical, horizontal, candela});
                    }) &&
               make(paint_, [&] { return renderer->createDecalMaterial({.label = "paint"}); }) &&
               make(volume_, [&] { return renderer->createIrradianceVolume(volume); });
    }

    void fill(FrameInput& input) {
        instances_.clear();
        const auto add = [&](MeshHandle mesh, MaterialHandle material, const vec3& center,
                             const vec3& size) {
            Instance& instance = instances_.emplace_back();
            instance.mesh = mesh;
            instance.material = material;
            for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= size[c];
            instance.worldFromLocal[3] = center;
        };
        add(box_, stone_, {0, -1.5f, 0}, {6, 0.5f, 6});
        add(ball_, {}, {-1, 0, 0}, vec3(0.8f));
        add(box_, pane_, {1, 0.2f, 1}, {0.7f, 0.7f, 0.05f});
        input.instances = instances_;
        input.view.viewFromWorld = glm::lookAt(vec3(3, 2.5f, 5), vec3(0), vec3(0, 1, 0));
        input.lighting.directional = {&sun_, 1};
        input.lighting.ambientSky = vec3(0.2f);
        input.settings.shadowResolution = 64;
        input.settings.autoExposure = everything_;
        if (!everything_) return;
        lamp_.position = {1, 3, 2};
        lamp_.intensity = vec3(20);
        lamp_.range = 10;
        lamp_.castsShadow = true;
        lamp_.profile = web_;
        area_.position = {0, 3, -2};
        area_.luminance = vec3(4);
        area_.range = 9;
        decal_.material = paint_;
        decal_.worldFromDecal = mat4x3(vec3(2, 0, 0), vec3(0, 0, -2), vec3(0, 2, 0),
                                       vec3(0, -1, 0));
        probe_.environment = sky_;
        probe_.halfSize = vec3(5);
        input.lighting.punctual = {&lamp_, 1};
        input.lighting.area = {&area_, 1};
        input.decals = {&decal_, 1};
        input.lighting.environment = sky_;
        input.lighting.irradianceVolume = volume_;
        input.lighting.reflectionProbes = {&probe_, 1};
        input.lighting.fog.density = 0.05f;
        input.settings.lightShadows = true;
        input.settings.shadowAtlasSize = 256;
        input.settings.shadowTileSize = 64;
        input.settings.ambientOcclusion = AmbientOcclusion::low;
        input.settings.reflections = true;
    }

    bool draw() {
        FrameInput input;
        fill(input);
        // Once more too where the picture did not come back.
        for (int i = 0; i < 3; ++i) {
            const auto ticket = twice([&] {
                return renderer->renderOffscreen(input, kWidth, kHeight, CaptureKind::display);
            });
            if (!ticket) return false;
            if (renderer->takeCapture(*ticket, true, image)) return true;
            missing_ = true;
        }
        return false;
    }

public:
    bool missing() const { return missing_; }

private:
    std::string cache_;
    bool everything_;
    bool missing_ = false;
    MeshHandle box_, ball_;
    MaterialHandle stone_, pane_;
    EnvironmentHandle sky_;
    LightProfileHandle web_;
    DecalMaterialHandle paint_;
    IrradianceVolumeHandle volume_;
    std::vector<Instance> instances_;
    DirectionalLight sun_{glm::normalize(vec3(-1, -2, -0.5f)), vec3(3), true};
    PunctualLight lamp_;
    AreaLight area_;
    Decal decal_;
    ReflectionProbe probe_;
};

bool isSentence(const std::string& text) {
    return text.size() > 20 && text.ends_with('.') && text.find(' ') != text.npos;
}

class GlFaultsGl : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid()) << "no surfaceless EGL context with OpenGL 4.5";
    }
    void TearDown() override {
        FaultyGl::set(GlFault::none, 0);
        FaultyGl::draws = true;
    }

    /// How many calls of a kind there are without a fault, and the picture.
    uint32_t count(GlFault fault, bool everything, CapturedImage& image) {
        FaultyGl::set(fault, ~0u);
        PatientHost host(cache_.path(), everything);
        EXPECT_TRUE(host.run());
        EXPECT_TRUE(host.errors.empty());
        image = host.image;
        return FaultyGl::calls;
    }

    /// Lets each call fail in turn.
    void sweep(GlFault fault, bool everything, const std::function<void(const Error&)>& check) {
        CapturedImage expected;
        const uint32_t calls = count(fault, everything, expected);
        ASSERT_GT(calls, 1u);
        for (uint32_t call = 1; call <= calls; ++call) {
            SCOPED_TRACE(testing::Message() << "call " << call << " of " << calls);
            FaultyGl::set(fault, call);
            PatientHost host(cache_.path(), everything);
            ASSERT_TRUE(host.run()) << (host.errors.empty() ? "" : host.errors.back().text());
            ASSERT_TRUE(host.errors.size() == 1 || host.missing()) << "nobody noticed";
            for (const Error& error : host.errors) check(error);
            EXPECT_TRUE(host.image.rgba8 == expected.rgba8);
            EXPECT_EQ(host.renderer->takeDebugMessages(), std::vector<std::string>{});
            if (HasFailure()) return;
        }
    }

    TestContext context_;
    TemporaryDirectory cache_;
};

TEST_F(GlFaultsGl, MemoryThatIsRefusedIsAnErrorWithAName) {
    FaultyGl::draws = false;  // the picture is black; the messages of OpenGL are what tells
    std::vector<std::string> names;
    sweep(GlFault::storage, true, [&](const Error& error) {
        EXPECT_TRUE(isSentence(error.message)) << error.text();
        EXPECT_NE(error.message.find("out of memory"), std::string::npos) << error.text();
        EXPECT_FALSE(error.object.empty()) << error.text();
        names.push_back(error.object);
    });
    for (const char* name :
         {"upload ring", "positions", "indices", "materials", "textures 4x4 srgb", "shadow-map",
          "shadow-atlas", "environment-specular", "brdf-table", "probe-distances", "decal-color",
          "light-patterns", "reflection-probes", "radiance", "readback"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name << " was never refused";
}

TEST_F(GlFaultsGl, AFrameThatIsDrawnAgainIsTheSamePicture) {
    sweep(GlFault::storage, false, [](const Error&) {});
    sweep(GlFault::framebuffer, false, [](const Error& error) {
        EXPECT_TRUE(error.object.starts_with("pass '")) << error.text();
        EXPECT_TRUE(isSentence(error.message)) << error.text();
    });
}

TEST_F(GlFaultsGl, AFramebufferThatIsNotCompleteNamesThePassAndItsTargets) {
    FaultyGl::draws = false;
    sweep(GlFault::framebuffer, true, [](const Error& error) {
        EXPECT_TRUE(error.object.starts_with("pass '")) << error.text();
        EXPECT_NE(error.message.find("framebuffer is not complete"), std::string::npos)
            << error.text();
    });
}

TEST_F(GlFaultsGl, MemoryThatCannotBeMappedIsNoCrash) {
    FaultyGl::draws = false;
    sweep(GlFault::mapping, false,
          [](const Error& error) { EXPECT_TRUE(isSentence(error.message)) << error.text(); });
}

// There the frame that fails is executed after render() has returned.
TEST_F(GlFaultsGl, AFrameThatFailsOnTheServingThreadIsTheNextOnesError) {
    RendererDesc desc;
    desc.loadGl = FaultyGl::load;
    desc.cacheDirectory = cache_.path();
    desc.renderThread = true;
    const auto renderer = std::move(Renderer::create(desc).value());
    std::thread game([&] {
        // Whatever fails before: without it serve() would not end.
        const struct AtExit {
            Renderer& renderer;
            ~AtExit() { renderer.stopServing(); }
        } atExit{*renderer};
        const auto draw = [&] {
            const auto ticket = renderer->renderOffscreen({}, kWidth, kHeight,
                                                          CaptureKind::display);
            renderer->finish();
            return ticket;
        };
        CapturedImage image;
        EXPECT_TRUE(renderer->takeCapture(draw().value(), true, image));
        FaultyGl::set(GlFault::framebuffer, 1);
        // Another size has framebuffers of its own.
        const auto failed = renderer->renderOffscreen({}, kWidth * 2, kHeight,
                                                      CaptureKind::display);
        ASSERT_TRUE(failed) << failed.error().text();
        EXPECT_FALSE(renderer->takeCapture(*failed, true, image));
        const auto told = draw();
        ASSERT_FALSE(told);
        EXPECT_NE(told.error().message.find("framebuffer"), std::string::npos)
            << told.error().text();
        const auto again = draw();
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_TRUE(renderer->takeCapture(*again, true, image));
        EXPECT_EQ(image.width, kWidth);
    });
    EXPECT_TRUE(renderer->serve());
    game.join();
}

// Shaders do not come from the cache here.
TEST_F(GlFaultsGl, AProgramThatIsNotMadeNamesItsShaders) {
    FaultyGl::draws = false;
    for (const GlFault fault : {GlFault::compilation, GlFault::linking}) {
        const TemporaryDirectory empty;
        CapturedImage image;
        const uint32_t calls = count(fault, false, image);
        for (uint32_t call = 1; call <= std::min(calls, 12u); ++call) {
            FaultyGl::set(fault, call);
            PatientHost host("", false);
            ASSERT_TRUE(host.run());
            ASSERT_EQ(host.errors.size(), 1u) << call;
            EXPECT_NE(host.errors[0].object.find("passes/"), std::string::npos)
                << host.errors[0].text();
            EXPECT_NE(host.errors[0].message.find(fault == GlFault::linking ? "link" : "compile"),
                      std::string::npos);
        }
    }
}

// Whenever it is found out: every later frame is an Error that says so, and nothing crashes.
TEST_F(GlFaultsGl, AContextThatIsLostAtAnyTime) {
    FaultyGl::draws = false;
    CapturedImage image;
    const uint32_t calls = count(GlFault::reset, true, image);
    ASSERT_GT(calls, 10u);
    for (uint32_t call = 1; call <= calls; call += 3) {
        SCOPED_TRACE(call);
        FaultyGl::set(GlFault::reset, call);
        PatientHost host(cache_.path(), true);
        EXPECT_FALSE(host.run());
        ASSERT_FALSE(host.errors.empty());
        EXPECT_EQ(host.errors.back().kind, ErrorKind::noContext);
        EXPECT_NE(host.errors.back().message.find("reset"), std::string::npos);
        if (!host.renderer) continue;
        const auto later = host.renderer->render({}, {0, 16, 16});
        ASSERT_FALSE(later);
        EXPECT_EQ(later.error().kind, ErrorKind::noContext);
    }
}

// ---- functions that the driver does not have
// ---------------------------------------------------------------------

const char* missing = nullptr;

void* loadAllBut(const char* name) {
    return missing && std::string_view(name) == missing ? nullptr : TestContext::load(name);
}

TEST_F(GlFaultsGl, EveryFunctionThatIsMissingIsNamed) {
    RendererDesc desc;
    desc.loadGl = loadAllBut;
#define RL_NAME(name, type) "gl" #name,
    for (const char* name : {RL_GL_FUNCTIONS(RL_NAME)}) {
        missing = name;
        const auto made = Renderer::create(desc);
        ASSERT_FALSE(made) << name;
        EXPECT_EQ(made.error().kind, ErrorKind::noContext);
        EXPECT_NE(made.error().message.find(name), std::string::npos) << made.error().text();
    }
#undef RL_NAME
    missing = nullptr;
    EXPECT_TRUE(Renderer::create(desc));
}

}  // namespace
}  // namespace rushlight
