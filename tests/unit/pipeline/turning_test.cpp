// A camera that turns compiles nothing, whatever comes into view.
#include "renderer/pipeline/frame_pipeline.h"
#include "tests/support/memory_device.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <set>

namespace rushlight {
namespace {

class Turning : public testing::Test {
protected:
    MemoryDevice device;
    SerialJobs jobs;
    FramePipeline frames{device, jobs, {}, ""};
    std::vector<Instance> instances;
    std::vector<PunctualLight> lights;
    std::vector<AreaLight> areas;
    std::vector<Decal> decals;
    std::vector<ReflectionProbe> probes;
    DirectionalLight sun;
    FrameInput input;

    /// One of each kind of object, light, decal and probe, each in a direction of its own.
    Turning() {
        for (int i = 0; i < 16; ++i) {
            MaterialDesc desc;
            desc.doubleSided = i % 2;
            desc.unlit = i % 5 == 4;
            desc.emissive = vec3(float(i % 3));
            desc.alphaMode = AlphaMode(i % 3);
            desc.transmission = i == 7 ? 0.5f : 0;
            addObject(i, desc);
        }
        addLights();
        input.view.nearPlane = 0.1f;
        input.view.farPlane = 60;
        input.settings.lightShadows = true;
        input.settings.shadowAtlasSize = 512;
        input.settings.shadowTileSize = 64;
        input.settings.ambientOcclusion = AmbientOcclusion::low;
        input.settings.reflections = true;
    }
    static vec3 place(int direction) {
        const float angle = float(direction) * 2 * kPi / 16;
        return vec3(std::sin(angle), 0, -std::cos(angle)) * 20.0f;
    }
    void addObject(int direction, const MaterialDesc& material) {
        const Shape shape = makeCube(direction % 4 == 1 ? 5 : 6);
        Instance instance;
        instance.mesh = frames.stores.geometry.create(shape.desc()).value();
        instance.material = frames.stores.materials.create(material).value();
        instance.worldFromLocal[3] = place(direction);
        if (direction % 7 == 3) instance.worldFromLocal[0] *= -1.0f;
        instances.push_back(instance);
    }
    void addLights() {
        for (int i = 0; i < 4; ++i) {
            PunctualLight light;
            light.position = place(4 * i) * 0.9f;
            light.range = 3;
            light.castsShadow = i == 2;
            lights.push_back(light);
        }
        AreaLight area;
        area.position = place(9);
        area.range = 3;
        area.castsShadow = true;
        areas.push_back(area);
        const uint8_t white[4] = {255, 255, 255, 255};
        Decal decal;
        decal.material = frames.stores.decals
                             .create({.label = "white", .baseColor = {"white", 1, 1, true, white}})
                             .value();
        decal.worldFromDecal[3] = place(11);
        decals.push_back(decal);
        const std::vector<vec3> sky(32, vec3(0.5f));
        ReflectionProbe probe;
        probe.environment = frames.stores.environments.create({"sky", 8, 4, sky}).value();
        probe.position = probe.center = place(5);
        probes.push_back(probe);
    }
    void render(float degrees) {
        const float angle = glm::radians(degrees);
        input.view.viewFromWorld = glm::lookAt(vec3(0), vec3(std::sin(angle), 0, -std::cos(angle)),
                                               vec3(0, 1, 0));
        input.instances = instances;
        input.lighting.directional = {&sun, 1};
        input.lighting.punctual = lights;
        input.lighting.area = areas;
        input.lighting.reflectionProbes = probes;
        input.lighting.ambientSky = vec3(0.1f);
        input.decals = decals;
        const auto rendered = frames.render(input, {0, 160, 90}, nullptr, {});
        EXPECT_TRUE(rendered) << rendered.error().text();
    }
};

TEST_F(Turning, CompilesNothingAfterTheFirstFrame) {
    render(0);
    const uint32_t compiled = device.pipelines;
    EXPECT_GT(compiled, 20u);
    EXPECT_EQ(frames.report().pipelinesCompiled, compiled);
    std::set<uint32_t> visible;
    for (int degrees = 5; degrees < 360; degrees += 5) {
        render(float(degrees));
        visible.insert(frames.report().visible);
        ASSERT_EQ(device.pipelines, compiled) << "at " << degrees << " degrees";
        ASSERT_EQ(frames.report().pipelinesCompiled, 0u);
    }
    EXPECT_GT(visible.size(), 1u) << "nothing comes into view";
}

TEST_F(Turning, NothingIsCompiledForWhatIsNotThere) {
    lights.clear(), areas.clear(), decals.clear(), probes.clear();
    instances.resize(1);
    render(0);
    EXPECT_LT(device.pipelines, 24u);
}

}  // namespace
}  // namespace rushlight
