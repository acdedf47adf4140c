#include "tests/support/scenes/varied_scene.h"

#include <utility>

namespace rushlight {

VariedScene::VariedScene(Renderer& renderer, uint64_t seed, const SceneVariation& variation)
    : RandomScene(renderer, seed * 10), random_(seed + 1000) {
    makeMaterials(renderer, variation);
    // The objects of the seed keep their places; meshes and materials are those whose descriptions
    // are known here.
    const Shape shapes[] = {makeCube(), makeSphere(6, 9), makeSphere(14, 21)};
    std::vector<std::array<MeshHandle, 2>> meshes;
    for (const Shape& shape : shapes) {
        MeshDesc desc = shape.desc("thing");
        desc.lods = variation.lods;
        const MeshHandle first = renderer.createMesh(desc).value();
        meshes.push_back({first, variation.twinMeshes ? renderer.createMesh(desc).value() : first});
    }
    instances.resize(std::min<size_t>(instances.size(), 120));
    for (size_t i = 0; i < instances.size(); ++i) {
        instances[i].mesh = meshes[random_.below(3)][i % 2];
        instances[i].material = materials_[random_.below(uint32_t(materials_.size()))];
    }
    addBuilding(renderer, variation);
    addLamps();
    settings.cut = true;
    settings.autoExposure = false;
    settings.smallObjectPixels = 0;
    settings.shadowCascades = 1 + uint32_t(seed % 3);
    settings.shadowFilter = ShadowFilter(seed % 2);  // hard, or filtered; soft shadows have a
                                                     // pattern of the screen
    settings.lightShadows = seed % 3 != 2;
    settings.shadowAtlasSize = 1024;
    settings.shadowTileSize = 128;
    settings.ambientOcclusion = seed % 2 ? AmbientOcclusion::low : AmbientOcclusion::off;
    if (seed % 3 == 0) {
        fog.density = 0.02f;
        fog.heightFalloff = 0.1f;
        fog.litDistance = 30;
    }
}

void VariedScene::makeMaterials(Renderer& renderer, const SceneVariation& variation) {
    std::vector<uint8_t> pixels(16 * 16 * 4);
    for (uint8_t& value : pixels) value = uint8_t(random_.below(256));
    const ImageHandle image = renderer.createImage({"noise", 16, 16, true, pixels}).value();
    for (uint32_t i = 0; i < 8; ++i) {
        MaterialDesc desc;
        desc.baseColor = vec4(random_.vector(0, 1), i % 4 == 3 ? 0.5f : 1.0f);
        desc.roughness = random_.uniform(0.2f, 1);
        desc.metallic = random_.below(2) ? 1.0f : 0.0f;
        if (i % 2) desc.baseColorTexture.image = image;
        if (i == 2) desc.metallicRoughnessTexture.image = image;
        const vec3 glow = random_.vector(0, 3);
        if (i == 4 && variation.glows) desc.emissive = glow;
        desc.unlit = i == 5 && variation.glows;
        desc.alphaMode = i % 4 == 3   ? AlphaMode::blend
                         : i % 4 == 1 ? AlphaMode::mask
                                      : AlphaMode::opaque;
        desc.doubleSided = i == 1 || i == 6;
        materials_.push_back(renderer.createMaterial(desc).value());
    }
}

Instance& VariedScene::add(MeshHandle mesh, MaterialHandle material, const vec3& center,
                           const vec3& size) {
    Instance instance;
    instance.mesh = mesh;
    instance.material = material;
    for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= size[c];
    instance.worldFromLocal[3] = center;
    instance.id = 1000 + uint32_t(instances.size());
    return instances.emplace_back(instance);
}

void VariedScene::addBuilding(Renderer& renderer, const SceneVariation& variation) {
    const Shape cube = makeCube();
    const MeshHandle box = renderer.createMesh(cube.desc("wall")).value();
    MaterialDesc wall;
    wall.metallic = 0;
    wall.roughness = 0.7f;
    const MaterialHandle plaster = renderer.createMaterial(wall).value();
    add(box, plaster, {0, -8, 0}, {14, 0.5f, 14});
    for (int i = 0; i < 6; ++i)
        add(box, plaster, random_.vector(-9, 9),
            {random_.uniform(0.2f, 3), random_.uniform(1, 5), random_.uniform(0.2f, 3)});
    hasGlass = variation.glass && random_.below(3) == 0;
    if (!hasGlass) return;
    MaterialDesc pane;
    pane.baseColor = {1, 0.5f, 0.2f, 1};
    pane.metallic = 0;
    pane.transmission = 0.75f;
    const MaterialHandle glass = renderer.createMaterial(pane).value();
    for (int i = 0; i < 3; ++i) add(box, glass, random_.vector(-6, 6), {2, 1.5f, 0.05f});
}

void VariedScene::addLamps() {
    lights.resize(std::min<size_t>(lights.size(), 20));
    for (size_t i = 0; i < lights.size(); ++i) {
        lights[i].range = random_.uniform(4, 12);
        lights[i].castsShadow = i % 4 == 0;
    }
    for (uint32_t i = 0; i < random_.below(3); ++i) {
        AreaLight area;
        area.shape = AreaShape(random_.below(4));
        area.position = random_.vector(-8, 8);
        area.luminance = random_.vector(0, 20);
        area.range = 10;
        area.radius = 0.3f;
        area.castsShadow = i == 0;
        areas.push_back(area);
    }
}

void VariedScene::move(const mat4& transform) {
    sceneFromMoved_ = sceneFromMoved_ * glm::inverse(transform);
    const auto point = [&](const vec3& p) { return vec3(transform * vec4(p, 1)); };
    const auto direction = [&](const vec3& d) { return vec3(transform * vec4(d, 0)); };
    const auto moveAll = [&](mat4x3& m) { m = mat4x3(transform * toMat4(m)); };
    for (Instance& instance : instances) moveAll(instance.worldFromLocal);
    for (mat4x3& previous : previousTransforms) moveAll(previous);
    for (DirectionalLight& sun : suns) sun.direction = direction(sun.direction);
    for (PunctualLight& light : lights) {
        light.position = point(light.position);
        light.direction = direction(light.direction);
    }
    const bool mirrors = glm::determinant(glm::mat3(transform)) < 0;
    for (AreaLight& area : areas) {
        area.position = point(area.position);
        area.halfX = direction(area.halfX);
        area.halfY = direction(area.halfY);
        const bool isFlat = area.shape == AreaShape::rectangle || area.shape == AreaShape::disk;
        if (mirrors && isFlat) std::swap(area.halfX, area.halfY);  // the front stays the front
    }
}

FrameInput VariedScene::frame(uint32_t index) {
    FrameInput input = RandomScene::frame(index);
    input.view.viewFromWorld = input.view.viewFromWorld * sceneFromMoved_;
    input.lighting.area = areas;
    input.lighting.fog = fog;
    input.lighting.ambientGround = vec3(0.1f, 0.08f, 0.06f);
    input.lighting.backgroundColor = vec3(0.1f, 0.2f, 0.4f);
    return input;
}

}  // namespace rushlight
