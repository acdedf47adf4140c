#include "tests/support/scenes/random_scene.h"

#include "tests/support/scenes/shapes.h"

namespace rushlight {

RandomScene::RandomScene(Renderer& renderer, uint64_t seed) : random_(seed) {
    for (const Shape& shape : {makeCube(), makeCube(3), makeSphere(6, 9)}) {
        meshes_.push_back(renderer.createMesh(shape.desc()).value());
        MeshDesc extended = shape.desc("extended");
        const std::vector<vec4> colors(shape.positions.size(), vec4(0.5f, 1, 0.7f, 1));
        const std::vector<vec2> uvs(shape.positions.size(), vec2(0.25f));
        extended.colors = colors;
        extended.uv0 = extended.uv1 = uvs;
        meshes_.push_back(renderer.createMesh(extended).value());
    }
    makeMaterials(renderer, seed);
    makeInstances();
    makeLights();
    eye_ = random_.vector(-6, 6);
    overlayVertices_ = {{{0, 0}, {0, 0}, ~0u}, {{20, 0}, {1, 0}, ~0u}, {{0, 20}, {0, 1}, ~0u}};
    overlayIndices_ = {0, 1, 2, 2, 1, 0};
    overlayBatches_ = {{0, 3, {0, 0}, {64, 64}}, {3, 3, {4, 4}, {32, 32}}};
}

void RandomScene::makeMaterials(Renderer& renderer, uint64_t seed) {
    std::vector<ImageHandle> images;
    for (uint32_t i = 0; i < 5; ++i) {
        const uint32_t side = 4 << i % 2;
        std::vector<uint8_t> pixels(size_t(side) * side * 4);
        for (uint8_t& value : pixels) value = uint8_t(random_.below(256));
        images.push_back(renderer.createImage({"image", side, side, i % 2 == 0, pixels}).value());
    }
    overlayImage_ = images[0];
    for (uint32_t i = 0; i < 12; ++i) {
        MaterialDesc desc;
        desc.baseColor = vec4(random_.vector(0, 1), i % 4 == 3 ? 0.5f : 1.0f);
        desc.roughness = random_.uniform(0.1f, 1);
        if (random_.below(2)) desc.baseColorTexture.image = images[random_.below(5)];
        if (random_.below(3) == 0) desc.normalTexture.image = images[random_.below(5)];
        if (random_.below(3) == 0) desc.baseColorTexture.offset = {0.25f, 0.5f};
        if (random_.below(3) == 0) desc.emissive = random_.vector(0, 4);
        desc.alphaMode = i % 4 == 3   ? AlphaMode::blend
                         : i % 4 == 2 ? AlphaMode::mask
                                      : AlphaMode::opaque;
        desc.doubleSided = random_.below(3) == 0;
        desc.unlit = random_.below(8) == 0;
        materials_.push_back(renderer.createMaterial(desc).value());
    }
    materials_.push_back({});
    const std::vector<vec3> sky(32, vec3(0.25f, 0.5f, 1));
    if (seed % 10 == 1) environment_ = renderer.createEnvironment({"sky", 8, 4, sky}).value();
}

void RandomScene::makeInstances() {
    for (uint32_t i = 0; i < 60 + random_.below(200); ++i) {
        Instance instance;
        const vec3 axis = random_.direction();
        const mat3 turn(glm::rotate(mat4(1), random_.uniform(0, 6), axis));
        const vec3 scale(random_.below(6) ? 0.5f : -0.5f, random_.uniform(0.2f, 1), 0.5f);
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] = turn[c] * scale[c];
        instance.worldFromLocal[3] = random_.vector(-12, 12);
        instance.mesh = meshes_[random_.below(uint32_t(meshes_.size()))];
        instance.material = materials_[random_.below(uint32_t(materials_.size()))];
        instance.id = i;
        instance.flags = random_.below(4) ? uint32_t(kInstanceCastsShadow) : 0;
        if (random_.below(5) == 0) {
            instance.flags |= kInstanceMoving;
            instance.previousTransform = uint32_t(previousTransforms.size());
            previousTransforms.push_back(instance.worldFromLocal);
            previousTransforms.back()[3] += random_.vector(-0.1f, 0.1f);
        }
        instances.push_back(instance);
    }
}

void RandomScene::makeLights() {
    for (uint32_t i = 0; i < random_.below(4); ++i)
        suns.push_back({random_.direction(), random_.vector(0, 4), random_.below(3) != 0});
    for (uint32_t i = 0; i < random_.below(40); ++i) {
        PunctualLight light;
        light.position = random_.vector(-12, 12);
        light.intensity = random_.vector(0, 30);
        light.range = random_.uniform(0, 6);
        light.direction = random_.direction();
        if (random_.below(2)) light.outerConeAngle = 0.7f;
        lights.push_back(light);
    }
    settings.shadowCascades = 1 + random_.below(4);
    settings.shadowResolution = 128;
    settings.autoExposure = random_.below(2);
    settings.bloom = random_.below(4) != 0;
    settings.antiAliasing = random_.below(3) ? AntiAliasing::fxaa : AntiAliasing::off;
}

FrameInput RandomScene::frame(uint32_t index) {
    const float angle = 0.7f * float(index);
    FrameInput input;
    input.view.viewFromWorld = glm::lookAt(
        eye_, eye_ + vec3(std::sin(angle), -0.2f, std::cos(angle)), vec3(0, 1, 0));
    input.instances = instances;
    input.previousTransforms = previousTransforms;
    input.lighting.directional = suns;
    input.lighting.punctual = lights;
    input.lighting.reflectionProbes = reflectionProbes;
    input.lighting.environment = environment_;
    input.lighting.ambientSky = vec3(0.2f);
    input.lighting.background = environment_ ? Background::environment : Background::color;
    input.settings = settings;
    input.overlay = {overlayVertices_, overlayIndices_, overlayBatches_, overlayImage_};
    return input;
}

}  // namespace rushlight
