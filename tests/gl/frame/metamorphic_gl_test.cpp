// Changes of the input that must not change one byte of the picture.

#include "tests/support/scenes/metamorphic.h"
#include "tests/support/thread_jobs.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <thread>

namespace rushlight {
namespace {

constexpr uint64_t kSeeds[] = {1, 2, 3, 4};

template <class T>
void shuffle(std::vector<T>& things, Random random) {
    for (size_t i = things.size(); i > 1; --i)
        std::swap(things[i - 1], things[random.below(uint32_t(i))]);
}

TEST_F(Metamorphic, TheScenesShowWhatTheyAreToShow) {
    uint32_t shadowed = 0, fogs = 0, panes = 0, lit = 0;
    for (const uint64_t seed : kSeeds) {
        VariedScene scene(renderer(), seed);
        const Pictures shown = picture(scene.frame(0));
        EXPECT_FALSE(shown == picture(scene.frame(1))) << "seed " << seed << " shows nothing";
        shadowed += renderer().report().shadowLights;
        lit += renderer().report().lightsVisible;
        fogs += scene.fog.density > 0;
        panes += scene.hasGlass;
    }
    EXPECT_GT(shadowed, 2u);
    EXPECT_GT(lit, 10u);
    EXPECT_GT(fogs, 0u);
    EXPECT_GT(panes, 1u);
}

// The order of objects decides nothing: draws are sorted by what they are. But for panes: in shadow
// maps they are multiplied in no order, and a product of half floats rounds.
TEST_F(Metamorphic, TheOrderOfInstances) {
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        shuffle(scene.instances, Random(seed));
        const Pictures shuffled = picture(scene.frame(0));
        std::ranges::reverse(scene.instances);
        const Pictures reversed = picture(scene.frame(0));
        for (const Pictures& after : {shuffled, reversed})
            if (scene.hasGlass)
                expectNear(before, after, 0.001, 1e-5);
            else
                expectSame(before, after);
    }
}

TEST_F(Metamorphic, EqualMeshesAsOneOrAsTwo) {
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene one(renderer(), seed), two(renderer(), seed, {.twinMeshes = true});
        const Pictures before = picture(one.frame(0));
        const uint32_t draws = renderer().report().draws;
        expectSame(before, picture(two.frame(0)));
        EXPECT_GE(renderer().report().draws, draws);
    }
}

TEST_F(Metamorphic, InstancesOfTheFrameOrOfAWorld) {
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        for (Instance& instance : scene.instances) instance.flags &= ~uint32_t(kInstanceMoving);
        const Pictures before = picture(scene.frame(0));
        const WorldHandle world = renderer().createWorld();
        std::vector<InstanceHandle> handles(scene.instances.size());
        // Elsewhere at first, and with some that leave again.
        std::vector<Instance> displaced = scene.instances;
        for (Instance& instance : displaced) instance.worldFromLocal[3] += vec3(3, 1, -2);
        ASSERT_TRUE(renderer().addInstances(world, displaced, handles));
        std::vector<InstanceHandle> leaving(40);
        ASSERT_TRUE(renderer().addInstances(world, std::span(displaced).first(40), leaving));
        FrameInput input = scene.frame(0);
        input.instances = {};
        input.world = world;
        EXPECT_FALSE(picture(input) == before);
        ASSERT_TRUE(renderer().updateInstances(world, handles, scene.instances));
        ASSERT_TRUE(renderer().removeInstances(world, leaving));
        picture(input);  // in this one they have moved
        expectSame(before, picture(input));
        // One half here, one there.
        const size_t half = handles.size() / 2;
        ASSERT_TRUE(renderer().removeInstances(world, std::span(handles).first(half)));
        input.instances = std::span(scene.instances).first(half);
        expectSame(before, picture(input));
        renderer().destroy(world);
    }
}

// Two worlds that were made alike, of one extent, differ in a place. Nothing that was kept of one
// is shown of the other.
TEST_F(Metamorphic, TwoWorldsInTurn) {
    for (const uint64_t seed : {2, 4}) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        for (Instance& instance : scene.instances) instance.flags &= ~uint32_t(kInstanceMoving);
        // A sun for them, straight from above, and something in the middle to cast.
        scene.suns = {{vec3(0.1f, -1, 0.05f), vec3(3), true}};
        Instance& caster = scene.instances.back();
        std::array<WorldHandle, 2> worlds;
        std::vector<InstanceHandle> handles(scene.instances.size());
        for (int i = 0; i < 2; ++i) {
            caster.worldFromLocal = mat4x3(2.0f);
            caster.worldFromLocal[3] = vec3(i ? 4 : -4, -3, 2);
            worlds[size_t(i)] = renderer().createWorld();
            ASSERT_TRUE(renderer().addInstances(worlds[size_t(i)], scene.instances, handles));
        }
        const auto show = [&](int world, bool caching) {
            scene.settings.shadowCaching = caching;
            FrameInput input = scene.frame(0);
            input.instances = {};
            input.world = worlds[size_t(world)];
            input.view.viewFromWorld = glm::lookAt(vec3(0, 9, 12), vec3(0, -6, 0), vec3(0, 1, 0));
            return picture(input);
        };
        const std::array<Pictures, 2> alone = {show(0, false), show(1, false)};
        EXPECT_FALSE(alone[0] == alone[1]);
        for (const int world : {0, 1, 0, 1}) expectSame(alone[size_t(world)], show(world, true));
        for (const WorldHandle world : worlds) renderer().destroy(world);
    }
}

TEST_F(Metamorphic, CullingOnOrOff) {
    uint32_t culled = 0, small = 0;
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        // From behind the eye: what is not seen casts shadows on what is.
        for (DirectionalLight& sun : scene.suns) sun.direction = {0.2f, -0.5f, 1};
        const Pictures before = picture(scene.frame(0));
        culled += renderer().report().culledFrustum + renderer().report().culledOcclusion;
        scene.settings.occlusionCulling = false;
        expectSame(before, picture(scene.frame(0)));
        scene.settings.frustumCulling = false;
        expectSame(before, picture(scene.frame(0)));
        EXPECT_EQ(renderer().report().culledFrustum + renderer().report().culledOcclusion, 0u);
        // Nothing is smaller than a fiftieth of a pixel.
        scene.settings.smallObjectPixels = 0.02f;
        expectSame(before, picture(scene.frame(0)));
        small += renderer().report().culledSmall;
    }
    EXPECT_GT(culled, 100u);
    EXPECT_EQ(small, 0u);
}

TEST_F(Metamorphic, LevelsOfDetailForbiddenOrNotThere) {
    int shown = 0;
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed), plain(renderer(), seed, {.lods = false});
        scene.settings.lodPixelError = 4;
        const Pictures simplified = picture(scene.frame(0));
        const Pictures never = picture(plain.frame(0));
        scene.settings.lodPixelError = scene.settings.shadowLodTexelError = 0;
        expectSame(never, picture(scene.frame(0)));
        shown += !(simplified == never);
    }
    EXPECT_GT(shown, 2) << "no level of detail is shown";
}

TEST_F(Metamorphic, ThreadsAndFramesInFlight) {
    for (const uint64_t seed : {1, 3}) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        for (const uint32_t threads : {2u, 4u}) {
            ThreadJobs jobs(threads);
            RendererDesc other = desc();
            other.jobs = &jobs;
            other.framesInFlight = threads - 1;
            const auto parallel = make(other);
            VariedScene same(*parallel, seed);
            expectSame(before, picture(*parallel, same.frame(0)));
        }
    }
}

TEST_F(Metamorphic, OnOneThreadOrWithARenderThread) {
    for (const uint64_t seed : {3, 4}) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        RendererDesc other = desc();
        other.renderThread = true;
        const auto served = make(other);
        Pictures after;
        std::thread game([&] {
            VariedScene same(*served, seed);
            after = picture(*served, same.frame(0));
            served->stopServing();
        });
        EXPECT_TRUE(served->serve());
        game.join();
        expectSame(before, after);
    }
}

TEST_F(Metamorphic, WhateverWasDrawnBefore) {
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        scene.settings.shadowAtlasSize = 2048;
        scene.settings.shadowTileSize = 512;
        const Pictures before = picture(scene.frame(0));
        for (const uint32_t frame : {3u, 1u}) picture(scene.frame(frame));
        // From farther away, where levels of detail and shadow maps are coarser.
        FrameInput away = scene.frame(0);
        away.view.viewFromWorld[3].z -= 30;
        EXPECT_FALSE(picture(away) == before);
        expectSame(before, picture(scene.frame(0)));
        scene.settings.shadowCaching = false;
        expectSame(before, picture(scene.frame(0)));
    }
}

// Behind the eye, of no size, or covering nothing. What casts no shadow and is not seen may only be
// culled.
TEST_F(Metamorphic, ThingsThatCannotBeSeen) {
    const Shape cube = makeCube();
    const MeshHandle box = renderer().createMesh(cube.desc("unseen")).value();
    MaterialDesc clear;
    clear.baseColor = {1, 0.5f, 0.2f, 0};
    clear.alphaMode = AlphaMode::blend;
    const MaterialHandle nothing = renderer().createMaterial(clear).value();
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        const mat4 worldFromView = glm::inverse(scene.frame(0).view.viewFromWorld);
        const auto add = [&](const vec3& inView, float size, MaterialHandle material) {
            Instance instance;
            instance.mesh = box;
            instance.material = material;
            instance.flags = 0;
            for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= size;
            instance.worldFromLocal[3] = vec3(worldFromView * vec4(inView, 1));
            scene.instances.push_back(instance);
            expectSame(before, picture(scene.frame(0)));
        };
        add({0.5f, 0.5f, 2}, 0.5f, {});
        add({0.2f, 0.1f, -3}, 0.7f, nothing);
        add({-0.2f, 0, -2}, 0, {});
    }
}

// Black, out of reach, or shining elsewhere. Their shaders may be others, but what they add is
// nothing.
TEST_F(Metamorphic, LightsThatGiveNothing) {
    for (const uint64_t seed : {1, 3, 4}) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        PunctualLight black;
        black.intensity = vec3(0);
        black.range = 8;
        scene.lights.push_back(black);
        expectSame(before, picture(scene.frame(0)));
        PunctualLight far;
        far.position = {0, 200, 0};
        far.intensity = vec3(1000);
        far.range = 20;
        scene.lights.insert(scene.lights.begin(), far);
        expectSame(before, picture(scene.frame(0)));
        if (scene.suns.size() == kMaxDirectionalLights) continue;
        scene.suns.push_back({vec3(0, -1, 0), vec3(0), false});
        expectSame(before, picture(scene.frame(0)));
    }
}

// ---- a driver that has less
// --------------------------------------------------------------------------------------

/// What it lacks, and how often that was used all the same.
struct Poorer {
    bool anisotropy = true, binaries = true;
    GLint alignment = 0;  ///< of buffer ranges; 0: the driver's
    uint32_t wrongUses = 0;
} poorer;

template <class F>
F real(const char* name) {
    return reinterpret_cast<F>(TestContext::load(name));
}

const GLubyte* APIENTRY getStringi(GLenum name, GLuint index) {
    const GLubyte* text = real<PFNGLGETSTRINGIPROC>("glGetStringi")(name, index);
    const bool hidden = !poorer.anisotropy && name == GL_EXTENSIONS &&
                        std::strstr(reinterpret_cast<const char*>(text), "anisotropic");
    return hidden ? reinterpret_cast<const GLubyte*>("GL_hidden") : text;
}
void APIENTRY getIntegerv(GLenum name, GLint* value) {
    real<PFNGLGETINTEGERVPROC>("glGetIntegerv")(name, value);
    if (name == GL_NUM_PROGRAM_BINARY_FORMATS && !poorer.binaries) *value = 0;
    if ((name == GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT ||
         name == GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT) &&
        poorer.alignment)
        *value = poorer.alignment;
}
void APIENTRY samplerParameterf(GLuint sampler, GLenum name, GLfloat value) {
    poorer.wrongUses += !poorer.anisotropy;
    real<PFNGLSAMPLERPARAMETERFPROC>("glSamplerParameterf")(sampler, name, value);
}
void APIENTRY programBinary(GLuint program, GLenum format, const void* binary, GLsizei size) {
    poorer.wrongUses += !poorer.binaries;
    real<PFNGLPROGRAMBINARYPROC>("glProgramBinary")(program, format, binary, size);
}
void countOffset(GLintptr offset) {
    poorer.wrongUses += poorer.alignment && offset % poorer.alignment;
}
void APIENTRY bindRange(GLenum target, GLuint index, GLuint buffer, GLintptr offset,
                        GLsizeiptr size) {
    countOffset(offset);
    real<PFNGLBINDBUFFERRANGEPROC>("glBindBufferRange")(target, index, buffer, offset, size);
}
void APIENTRY textureRange(GLuint texture, GLenum format, GLuint buffer, GLintptr offset,
                           GLsizeiptr size) {
    countOffset(offset);
    real<PFNGLTEXTUREBUFFERRANGEPROC>("glTextureBufferRange")(texture, format, buffer, offset,
                                                              size);
}

void* loadPoorer(const char* name) {
    const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
    if (is("glGetStringi")) return reinterpret_cast<void*>(&getStringi);
    if (is("glGetIntegerv")) return reinterpret_cast<void*>(&getIntegerv);
    if (is("glSamplerParameterf")) return reinterpret_cast<void*>(&samplerParameterf);
    if (is("glProgramBinary")) return reinterpret_cast<void*>(&programBinary);
    if (is("glBindBufferRange")) return reinterpret_cast<void*>(&bindRange);
    if (is("glTextureBufferRange")) return reinterpret_cast<void*>(&textureRange);
    return TestContext::load(name);
}

// 256 is the coarsest alignment that OpenGL allows a driver.
TEST_F(Metamorphic, WithoutWhatADriverMayLack) {
    const Poorer drivers[] = {{.anisotropy = false}, {.binaries = false}, {.alignment = 256}};
    VariedScene scene(renderer(), 2);
    const Pictures before = picture(scene.frame(0));
    for (const Poorer& driver : drivers) {
        poorer = driver;
        RendererDesc other = desc();
        other.loadGl = loadPoorer;
        const auto reduced = make(other);
        // One that asks for more than this driver can, on nothing.
        const std::vector<uint8_t> white(4, 255);
        MaterialDesc grazing;
        grazing.baseColorTexture.image = reduced->createImage({"white", 1, 1, true, white}).value();
        grazing.baseColorTexture.sampler.maxAnisotropy = 8;
        ASSERT_TRUE(reduced->createMaterial(grazing));
        VariedScene same(*reduced, 2);
        expectSame(before, picture(*reduced, same.frame(0)));
        EXPECT_EQ(poorer.wrongUses, 0u);
        poorer = {};
    }
}

}  // namespace
}  // namespace rushlight
