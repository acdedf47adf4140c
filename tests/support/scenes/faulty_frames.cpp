#include "tests/support/scenes/faulty_frames.h"

#include <array>
#include <limits>

namespace rushlight {

Stage::~Stage() {
    for (MeshHandle mesh : meshes) renderer.destroy(mesh);
    for (MaterialHandle material : materials) renderer.destroy(material);
    if (input.world) renderer.destroy(input.world);
}

MaterialHandle Stage::paint(const MaterialDesc& desc) {
    materials.push_back(*renderer.createMaterial(desc));
    return materials.back();
}

MaterialHandle Stage::paint(const vec3& color, float metallic, float roughness) {
    MaterialDesc desc;
    desc.baseColor = vec4(color, 1);
    desc.metallic = metallic;
    desc.roughness = roughness;
    return paint(desc);
}

void Stage::repaint(const std::function<void(MaterialDesc&)>& change) {
    for (Instance& instance : instances) {
        MaterialDesc desc = *renderer.describeMaterial(instance.material);
        change(desc);
        instance.material = paint(desc);
    }
}

Instance& Stage::box(const vec3& center, const vec3& half, MaterialHandle material) {
    if (!cube_) meshes.push_back(cube_ = *renderer.createMesh(makeCube().desc("box")));
    Instance instance;
    instance.mesh = cube_;
    instance.material = material;
    instance.id = uint32_t(instances.size());
    for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= half[c];
    instance.worldFromLocal[3] = center;
    return instances.emplace_back(instance);
}

Instance& Stage::card(const vec3& center, float half, MaterialHandle material, bool reversed) {
    MeshHandle& mesh = reversed ? reversedCard_ : card_;
    if (!mesh) {
        Shape shape;
        shape.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        shape.indices = {0, 1, 2, 0, 2, 3};
        if (reversed) shape.indices = {0, 2, 1, 0, 3, 2};
        MeshDesc desc = shape.desc("card");
        const std::array<vec3, 4> normals{vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1),
                                          vec3(0, 0, 1)};
        desc.normals = normals;
        meshes.push_back(mesh = *renderer.createMesh(desc));
    }
    box(center, vec3(half), material).mesh = mesh;
    return instances.back();
}

void Stage::look() { input.view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0)); }

void Stage::scale(float factor) {
    for (Instance& instance : instances) instance.worldFromLocal *= factor;
}

const FrameInput& Stage::frame() {
    if (!input.world) input.instances = instances;
    input.lighting.directional = suns;
    input.lighting.punctual = lamps;
    input.lighting.area = panels;
    return input;
}

namespace {

DirectionalLight sun(const vec3& direction, float lux) {
    DirectionalLight light;
    light.direction = glm::normalize(direction);
    light.illuminance = vec3(lux);
    return light;
}

PunctualLight lamp(const vec3& position, float candela, float range) {
    PunctualLight light;
    light.position = position;
    light.intensity = vec3(candela);
    light.range = range;
    light.castsShadow = true;
    return light;
}

}  // namespace

void buildYard(Stage& s) {
    s.box({0, -0.2f, 0}, {6, 0.2f, 6}, s.paint(vec3(0.5f, 0.5f, 0.45f)));
    const MaterialHandle red = s.paint(vec3(0.7f, 0.2f, 0.1f)),
                         blue = s.paint(vec3(0.1f, 0.3f, 0.7f));
    for (int i = 0; i < 5; ++i)
        s.box({float(i) * 1.6f - 3.2f, 0.5f, float(i % 2) - 0.5f},
              {0.4f, 0.5f + 0.1f * float(i), 0.4f}, i % 2 ? red : blue);
    s.suns = {sun({-0.4f, -1, -0.6f}, 3)};
    s.input.lighting.ambientSky = vec3(0.15f);
    s.input.lighting.ambientGround = vec3(0.05f);
    s.look();
}

void buildCellar(Stage& s) {
    const MaterialHandle wall = s.paint(vec3(0.6f, 0.55f, 0.5f));
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-1.0f, 1.0f}) {
            vec3 center(0, 1.5f, 0), half(4.2f, 1.7f, 4.2f);
            center[axis] += side * (axis == 1 ? 1.6f : 4.1f);
            half[axis] = 0.1f;
            s.box(center, half, wall);
        }
    const MaterialHandle wood = s.paint(vec3(0.4f, 0.25f, 0.1f));
    for (float x : {-1.5f, 0.0f, 1.5f}) s.box({x, 0.4f, -1}, {0.4f, 0.4f, 0.4f}, wood);
    s.lamps = {lamp({-1.5f, 2.4f, 1}, 6, 12), lamp({2, 2.2f, -2}, 4, 12)};
    s.input.settings.lightShadows = true;
    s.eye = {0.3f, 1.7f, 3.4f};
    s.look();
}

void buildShop(Stage& s) {
    s.box({0, 2, -2}, {5, 2.5f, 0.1f}, s.paint(vec3(0.8f)));
    s.box({0, -0.1f, 0}, {5, 0.1f, 3}, s.paint(vec3(0.3f, 0.3f, 0.35f)));
    const MaterialHandle brass = s.paint(vec3(0.8f, 0.6f, 0.3f), 0.2f, 0.5f);
    for (float x : {-2.0f, -0.7f, 0.7f, 2.0f}) s.box({x, 0.5f, 0}, {0.3f, 0.5f, 0.3f}, brass);
    s.lamps = {lamp({0, 4, 3}, 60, 15)};
    s.lamps[0].direction = glm::normalize(vec3(0, -1, -1));
    s.lamps[0].innerConeAngle = 0.5f;
    s.lamps[0].outerConeAngle = 0.9f;
    AreaLight panel;
    panel.position = {0, 3.5f, 1};
    panel.halfX = {-1, 0, 0};
    panel.halfY = {0, 0, -0.4f};
    panel.luminance = vec3(8);
    s.panels = {panel};
    s.input.settings.lightShadows = true;
    s.look();
}

void buildField(Stage& s) {
    s.box({0, -0.1f, 0}, {40, 0.1f, 40}, s.paint(vec3(0.25f, 0.4f, 0.15f)));
    const MaterialHandle stone = s.paint(vec3(0.5f));
    for (int z = 0; z < 15; ++z)
        for (int x = 0; x < 10; ++x)
            s.box({float(x) * 3 - 13, 0.6f, -float(z) * 3}, {0.5f, 0.6f, 0.5f}, stone);
    s.suns = {sun({0.5f, -1, -0.3f}, 100000)};
    s.input.lighting.ambientSky = vec3(6000);
    s.input.lighting.ambientGround = vec3(2000);
    s.input.settings.useExposureValue = true;
    s.input.settings.exposureValue = 15;
    s.eye = {3, 4, 12};
    s.target = {1, 0, 0};
    s.look();
}

void buildCards(Stage& s) {
    const std::array<vec3, 3> colors{vec3(0.9f, 0.4f, 0.2f), vec3(0.2f, 0.8f, 0.4f),
                                     vec3(0.3f, 0.4f, 0.9f)};
    for (int i = 0; i < 6; ++i)
        s.card({float(i % 3) * 2 - 2, float(i / 3) * 1.8f - 0.5f, -float(i % 2)}, 0.8f,
               s.paint(colors[size_t(i) % 3]));
    s.suns = {sun({0.2f, -0.4f, -1}, 3)};
    s.eye = {0, 0.5f, 6};
    s.look();
}

namespace {

/// As DirectX's: z goes into the picture.
mat4 leftHandedLookAt(const vec3& eye, const vec3& target) {
    const vec3 z = glm::normalize(target - eye), x = glm::normalize(glm::cross(vec3(0, 1, 0), z));
    const vec3 y = glm::cross(z, x);
    mat4 m(1);
    for (int i = 0; i < 3; ++i) m[i] = vec4(x[i], y[i], z[i], 0);
    m[3] = vec4(-glm::dot(x, eye), -glm::dot(y, eye), -glm::dot(z, eye), 1);
    return m;
}

ImageHandle plainImage(Stage& s, uint8_t value) {
    const std::vector<uint8_t> pixels(4 * 4 * 4, value);
    return *s.renderer.createImage({"plain", 4, 4, true, pixels});
}

void noAmbient(Stage& s) { s.input.lighting.ambientSky = s.input.lighting.ambientGround = vec3(0); }

void keepInWorld(Stage& s, std::vector<InstanceHandle>& handles) {
    s.input.world = s.renderer.createWorld();
    handles.resize(s.instances.size());
    (void)s.renderer.addInstances(s.input.world, s.instances, handles);
    s.input.instances = {};
}

std::vector<FaultyFrame> faultsOfContents() {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    return {
        {"no instances were collected", Cause::emptyScene, buildYard,
         [](Stage& s) { s.instances.clear(); }},
        {"the world was emptied", Cause::emptyScene, buildField,
         [](Stage& s) {
             std::vector<InstanceHandle> handles;
             keepInWorld(s, handles);
             (void)s.renderer.removeInstances(s.input.world, handles);
         }},
        {"transforms divided by zero", Cause::transformsNotFinite, buildYard,
         [](Stage& s) { s.scale(kNan); }},
        {"previous transforms forgotten", Cause::transformsNotFinite, buildCellar,
         [](Stage& s) {
             for (Instance& i : s.instances) i.flags |= kInstanceMoving, i.previousTransform = 7;
         }},
        {"meshes destroyed too early", Cause::staleHandles, buildShop,
         [](Stage& s) {
             for (MeshHandle mesh : s.meshes) s.renderer.destroy(mesh);
         }},
        {"materials destroyed too early", Cause::staleHandles, buildField,
         [](Stage& s) {
             for (MaterialHandle material : s.materials) s.renderer.destroy(material);
         }},
        {"mesh handles never set", Cause::staleHandles, buildCards,
         [](Stage& s) {
             for (Instance& i : s.instances) i.mesh = {};
         }},
        {"six suns", Cause::refused, buildYard, [](Stage& s) { s.suns.resize(6, s.suns[0]); }},
        {"a lamp at NaN", Cause::refused, buildCellar,
         [](Stage& s) { s.lamps[1].position.x = kNan; }},
        {"the window is minimised", Cause::targetSize, buildYard, [](Stage& s) { s.size.y = 0; }},
        {"another picture is shown", Cause::shownImage, buildShop,
         [](Stage& s) { s.input.settings.debugView = DebugView::emissive; }},
    };
}

std::vector<FaultyFrame> faultsOfViews() {
    return {
        {"field of view in degrees", Cause::fieldOfView, buildYard,
         [](Stage& s) { s.input.view.verticalFov = 45; }},
        {"field of view in radians twice", Cause::fieldOfView, buildYard,
         [](Stage& s) { s.input.view.verticalFov = glm::radians(0.785f); }},
        {"near and far exchanged", Cause::nearFarOrder, buildShop,
         [](Stage& s) { s.input.view.nearPlane = 100, s.input.view.farPlane = 0.1f; }},
        {"near plane at zero", Cause::nearFarOrder, buildCellar,
         [](Stage& s) { s.input.view.nearPlane = 0; }},
        {"view never set", Cause::viewNotInvertible, buildYard,
         [](Stage& s) { s.input.view.viewFromWorld = mat4(0); }},
        {"eye is target", Cause::viewNotFinite, buildCellar,
         [](Stage& s) { s.target = s.eye, s.look(); }},
        {"row-major view", Cause::viewTransposed, buildYard,
         [](Stage& s) { s.input.view.viewFromWorld = glm::transpose(s.input.view.viewFromWorld); }},
        {"row-major view of the field", Cause::viewTransposed, buildField,
         [](Stage& s) { s.input.view.viewFromWorld = glm::transpose(s.input.view.viewFromWorld); }},
        {"camera's transform for its inverse", Cause::viewInverted, buildYard,
         [](Stage& s) { s.input.view.viewFromWorld = glm::inverse(s.input.view.viewFromWorld); }},
        {"camera's transform for its inverse, cards", Cause::viewInverted, buildCards,
         [](Stage& s) { s.input.view.viewFromWorld = glm::inverse(s.input.view.viewFromWorld); }},
        {"looks the other way", Cause::behindCamera, buildYard,
         [](Stage& s) { s.target = 2.0f * s.eye - s.target, s.look(); }},
        {"left-handed view", Cause::behindCamera, buildShop,
         [](Stage& s) { s.input.view.viewFromWorld = leftHandedLookAt(s.eye, s.target); }},
        {"left-handed view of the cards", Cause::behindCamera, buildCards,
         [](Stage& s) { s.input.view.viewFromWorld = leftHandedLookAt(s.eye, s.target); }},
        {"looks into the sky", Cause::outsideView, buildYard,
         [](Stage& s) { s.target = s.eye + vec3(0, 5, -3), s.look(); }},
        {"camera in centimetres", Cause::outsideView, buildShop,
         [](Stage& s) { s.eye = vec3(900, 200, 0), s.target = vec3(900, 200, -50), s.look(); }},
        {"far plane too near", Cause::beyondFar, buildCards,
         [](Stage& s) { s.input.view.farPlane = 2; }},
        {"far plane in kilometres", Cause::beyondFar, buildField,
         [](Stage& s) { s.input.view.nearPlane = 0.001f, s.input.view.farPlane = 0.5f; }},
        {"near plane in millimetres", Cause::beforeNear, buildCellar,
         [](Stage& s) { s.input.view.nearPlane = 100; }},
        {"near plane beyond the cards", Cause::beforeNear, buildCards,
         [](Stage& s) { s.input.view.nearPlane = 20; }},
        {"transforms in micrometres", Cause::tooSmall, buildCards,
         [](Stage& s) { s.scale(1e-4f); }},
        {"scale of zero", Cause::tooSmall, buildShop, [](Stage& s) { s.scale(0); }},
    };
}

std::vector<FaultyFrame> faultsOfSurfaces() {
    return {
        {"triangles wound clockwise", Cause::backFaces, buildCards,
         [](Stage& s) {
             for (size_t i = s.instances.size(); i-- > 0;)
                 s.card(s.instances[i].worldFromLocal[3], 0.8f, s.instances[i].material, true);
             s.instances.erase(s.instances.begin(), s.instances.begin() + 6);
         }},
        {"mirrored view", Cause::backFaces, buildCards,
         [](Stage& s) {
             s.input.view.viewFromWorld = glm::scale(mat4(1), vec3(-1, 1, 1)) *
                                          s.input.view.viewFromWorld;
         }},
        {"blended with alpha zero", Cause::alpha, buildYard,
         [](Stage& s) {
             s.repaint([](MaterialDesc& m) { m.alphaMode = AlphaMode::blend, m.baseColor.a = 0; });
         }},
        {"all below the cutoff", Cause::alpha, buildCards,
         [](Stage& s) {
             s.repaint(
                 [](MaterialDesc& m) { m.alphaMode = AlphaMode::mask, m.baseColor.a = 0.4f; });
         }},
        {"camera within a statue", Cause::cameraInside, buildField,
         [](Stage& s) {
             s.instances.resize(2);
             s.box({3, 4, 12}, {1, 2, 1}, s.instances[1].material);
             s.instances.erase(s.instances.begin(), s.instances.begin() + 2);
         }},
        {"camera within a crate", Cause::cameraInside, buildYard,
         [](Stage& s) {
             noAmbient(s);
             MaterialDesc crate;
             crate.doubleSided = true;
             crate.metallic = 0;
             s.box(s.eye, vec3(0.6f), s.paint(crate));
         }},
        {"black base colours", Cause::blackMaterials, buildYard,
         [](Stage& s) {
             s.repaint([](MaterialDesc& m) { m.baseColor = vec4(0, 0, 0, 1), m.roughness = 1; }),
                 noAmbient(s);
         }},
        {"black textures", Cause::blackMaterials, buildShop,
         [](Stage& s) {
             const ImageHandle image = plainImage(s, 0);
             s.repaint([&](MaterialDesc& m) {
                 m.baseColorTexture.image = image, m.metallic = 0, m.roughness = 1;
             });
         }},
        {"unlit and black", Cause::blackMaterials, buildCards,
         [](Stage& s) {
             s.repaint([](MaterialDesc& m) { m.unlit = true, m.baseColor = vec4(0, 0, 0, 1); });
         }},
        {"metals under a sun alone", Cause::mirrorsNothing, buildCards,
         [](Stage& s) { s.repaint([](MaterialDesc& m) { m.metallic = 1, m.roughness = 0.02f; }); }},
    };
}

std::vector<FaultyFrame> faultsOfLight() {
    return {
        {"no light at all", Cause::noLights, buildYard,
         [](Stage& s) { s.suns.clear(), noAmbient(s); }},
        {"lights switched off", Cause::noLights, buildShop,
         [](Stage& s) { s.lamps[0].intensity = s.panels[0].luminance = vec3(0); }},
        {"lamps in megacandela", Cause::lightsTooWeak, buildCellar,
         [](Stage& s) {
             for (PunctualLight& light : s.lamps) light.intensity *= 1e-5f;
         }},
        {"a sun of 3 under an exposure in lux", Cause::lightsTooWeak, buildField,
         [](Stage& s) { s.suns[0].illuminance = vec3(3), noAmbient(s); }},
        {"exposure value 30", Cause::exposure, buildYard,
         [](Stage& s) {
             s.input.settings.useExposureValue = true, s.input.settings.exposureValue = 30;
         }},
        {"exposure in microseconds", Cause::exposure, buildCellar,
         [](Stage& s) { s.input.settings.exposureScale = 1e-6f; }},
        {"exposure never set", Cause::exposure, buildShop,
         [](Stage& s) { s.input.settings.exposureScale = 0; }},
        {"a sun in lux, no exposure", Cause::exposure, buildField,
         [](Stage& s) { s.input.settings.useExposureValue = false; }},
        {"lamps reach a centimetre", Cause::lightsOutOfRange, buildCellar,
         [](Stage& s) {
             for (PunctualLight& light : s.lamps) light.range = 0.01f;
         }},
        {"lamps in centimetres", Cause::lightsOutOfRange, buildCellar,
         [](Stage& s) {
             for (PunctualLight& light : s.lamps) light.position *= 100.0f;
         }},
        {"direction towards the sun", Cause::lightDirection, buildYard,
         [](Stage& s) { noAmbient(s), s.suns[0].direction = -s.suns[0].direction; }},
        {"spot turned round", Cause::lightDirection, buildShop,
         [](Stage& s) { s.panels.clear(), s.lamps[0].direction = -s.lamps[0].direction; }},
        {"a sky dome that casts", Cause::shadowed, buildYard,
         [](Stage& s) {
             noAmbient(s);
             s.box({0, 0, 0}, vec3(30), s.paint(vec3(0)));
         }},
        {"a sun and a closed room", Cause::shadowed, buildCellar,
         [](Stage& s) {
             s.lamps.clear(), s.suns = {sun({-0.2f, -1, -0.5f}, 3)};
         }},
        {"thick fog by night", Cause::fog, buildCellar,
         [](Stage& s) { s.input.lighting.fog.density = 60; }},
        {"thick fog by day", Cause::fog, buildYard,
         [](Stage& s) { s.input.lighting.fog.density = 40; }},
    };
}

// Written after the ranking, which was not changed for them.
std::vector<FaultyFrame> laterFaults() {
    return {
        {"one world forgotten for another", Cause::emptyScene, buildShop,
         [](Stage& s) { s.instances.clear(), s.input.world = s.renderer.createWorld(); }},
        {"up is along the view", Cause::viewNotFinite, buildField,
         [](Stage& s) {
             s.input.view.viewFromWorld = glm::lookAt(s.eye, s.eye - vec3(0, 3, 0), vec3(0, 1, 0));
         }},
        {"field of view of zero", Cause::fieldOfView, buildShop,
         [](Stage& s) { s.input.view.verticalFov = 0; }},
        {"row-major view of the shop", Cause::viewTransposed, buildShop,
         [](Stage& s) { s.input.view.viewFromWorld = glm::transpose(s.input.view.viewFromWorld); }},
        {"camera's transform for its inverse, shop", Cause::viewInverted, buildShop,
         [](Stage& s) { s.input.view.viewFromWorld = glm::inverse(s.input.view.viewFromWorld); }},
        {"camera looks out of the field", Cause::behindCamera, buildField,
         [](Stage& s) { s.eye = vec3(0, 2, 45), s.target = vec3(0, 2, 90), s.look(); }},
        {"far plane before the field", Cause::beyondFar, buildField,
         [](Stage& s) { s.eye = vec3(0, 5, 400), s.look(), s.input.view.farPlane = 100; }},
        {"yard in kilometres", Cause::tooSmall, buildYard, [](Stage& s) { s.scale(1e-5f); }},
        {"glass without alpha", Cause::alpha, buildCards,
         [](Stage& s) {
             s.repaint([](MaterialDesc& m) { m.alphaMode = AlphaMode::blend, m.baseColor.a = 0; });
         }},
        {"ambient light forgotten by night", Cause::noLights, buildCards,
         [](Stage& s) { s.suns.clear(); }},
        {"a factor where a value was meant", Cause::exposure, buildYard,
         [](Stage& s) { s.input.settings.exposureScale = 1 / 65536.0f / 16; }},
        {"exposed for the stars by day", Cause::exposure, buildYard,
         [](Stage& s) {
             s.input.settings.useExposureValue = true, s.input.settings.exposureValue = -9;
         }},
        {"spots reach a centimetre", Cause::lightsOutOfRange, buildShop,
         [](Stage& s) { s.panels.clear(), s.lamps[0].range = 0.05f; }},
        {"cards lit from behind", Cause::lightDirection, buildCards,
         [](Stage& s) { s.suns[0].direction = -s.suns[0].direction; }},
        {"soup over the field", Cause::fog, buildField,
         [](Stage& s) { s.input.lighting.fog.density = 5; }},
        {"roughness for depth", Cause::shownImage, buildCards,
         [](Stage& s) { s.input.settings.debugView = DebugView::metallic; }},
        {"five suns", Cause::refused, buildField, [](Stage& s) { s.suns.resize(5, s.suns[0]); }},
        {"a texture of ink", Cause::blackMaterials, buildCards,
         [](Stage& s) {
             const ImageHandle image = plainImage(s, 0);
             s.repaint([&](MaterialDesc& m) { m.baseColorTexture.image = image, m.roughness = 1; });
         }},
        {"default materials by lamplight", Cause::mirrorsNothing, buildCards,
         [](Stage& s) { s.repaint([](MaterialDesc& m) { m.metallic = 1, m.roughness = 0.1f; }); }},
    };
}

}  // namespace

std::vector<FaultyFrame> faultyFrames() {
    std::vector<FaultyFrame> all;
    for (auto faults :
         {faultsOfContents(), faultsOfViews(), faultsOfSurfaces(), faultsOfLight(), laterFaults()})
        all.insert(all.end(), faults.begin(), faults.end());
    return all;
}

std::vector<HealthyFrame> healthyFrames() {
    const auto asIs = [](Stage&) {};
    return {
        {"yard", buildYard, asIs},
        {"cellar", buildCellar, asIs},
        {"shop", buildShop, asIs},
        {"field", buildField, asIs},
        {"cards", buildCards, asIs},
        {"moonlight", buildYard,
         [](Stage& s) {
             s.suns[0].illuminance = vec3(0.03f), s.input.lighting.ambientSky = vec3(0.001f);
         }},
        {"one candle", buildCellar,
         [](Stage& s) { s.lamps.resize(1), s.lamps[0].intensity = vec3(0.15f, 0.1f, 0.05f); }},
        {"a sign glows in the dark", buildCards,
         [](Stage& s) {
             s.suns.clear();
             MaterialDesc glow;
             glow.baseColor = vec4(0, 0, 0, 1);
             glow.emissive = vec3(0.5f, 0.1f, 0.2f);
             s.instances[2].material = s.paint(glow);
         }},
        {"silhouettes", buildYard,
         [](Stage& s) {
             s.suns[0].illuminance = vec3(0.2f), s.input.lighting.backgroundColor = vec3(0.8f);
         }},
        {"haze", buildField, [](Stage& s) { s.input.lighting.fog.density = 0.01f; }},
        {"white things in bright light", buildYard,
         [](Stage& s) {
             s.repaint([](MaterialDesc& m) { m.baseColor = vec4(0.95f, 0.95f, 0.95f, 1); });
         }},
        {"transparent background", buildCards,
         [](Stage& s) { s.input.lighting.background = Background::transparent; }},
        {"black and white", buildShop,
         [](Stage& s) { s.instances[2].material = s.instances[3].material = s.paint(vec3(0)); }},
        {"a far lamp", buildShop,
         [](Stage& s) { s.panels.clear(), s.lamps[0].intensity = vec3(1.5f); }},
    };
}

}  // namespace rushlight
