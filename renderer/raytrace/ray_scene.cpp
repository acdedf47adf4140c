#include "renderer/raytrace/ray_scene.h"

#include "renderer/geometry/mesh_topology.h"
#include "renderer/raytrace/ray_image.h"
#include "renderer/raytrace/ray_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

namespace rushlight {
namespace {

struct Placed {
    RayMesh* mesh = nullptr;
    const MaterialDesc* material = nullptr;
    mat4x3 worldFromLocal{1.0f};
    mat3 normalFromLocal{1.0f};
    uint32_t index = 0;  // in the host's span
    bool castsShadow = true;
    bool glass = false;   // light goes through
    bool closed = false;  // of glass alone: its backs count no second time
};

/// What the filter sees besides the hit.
struct Query {
    RTCIntersectContext context;  // first: Embree hands a pointer to it back
    const std::vector<Placed>* placed;
    const std::unordered_map<uint32_t, RayImage>* images;
    bool castersOnly;
};

vec2 uvOf(const RayMesh& mesh, const TextureSlot& slot, uint32_t triangle, const vec2& b) {
    const std::vector<vec2>& uvs = slot.uvSet == 1 ? mesh.uv1 : mesh.uv0;
    return uvs.empty() ? vec2(0) : mesh.interpolate(uvs, triangle, b);
}

vec4 colorOf(const RayMesh& mesh, uint32_t triangle, const vec2& b) {
    if (mesh.colors.empty()) return vec4(1);
    const auto at = [&](uint32_t corner) {
        const auto& c = mesh.colors[mesh.indices[size_t(triangle) * 3 + corner]];
        return vec4(c[0], c[1], c[2], c[3]) * (1.0f / 255);
    };
    return at(0) * (1 - b.x - b.y) + at(1) * b.x + at(2) * b.y;
}

float alphaOf(const Query& query, const Placed& placed, uint32_t triangle, const vec2& b) {
    const MaterialDesc& m = *placed.material;
    float alpha = m.baseColor.w * colorOf(*placed.mesh, triangle, b).w;
    const auto image = query.images->find(m.baseColorTexture.image.value);
    if (image != query.images->end())
        alpha *= image->second.sampleAlpha(m.baseColorTexture,
                                           uvOf(*placed.mesh, m.baseColorTexture, triangle, b));
    return alpha;
}

void filterHit(const RTCFilterFunctionNArguments* args) {
    RL_CHECK(args->N == 1, "rays are traced one by one");
    if (args->valid[0] != -1) return;
    const Query& query = *reinterpret_cast<const Query*>(args->context);
    const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
    const Placed& placed = (*query.placed)[hit->instID[0]];
    const MaterialDesc& m = *placed.material;
    if ((query.castersOnly && !placed.castsShadow) ||
        (m.alphaMode == AlphaMode::mask &&
         alphaOf(query, placed, hit->primID, {hit->u, hit->v}) < m.alphaCutoff))
        args->valid[0] = 0;
}

bool isFinite(const Ray& ray) {
    const vec3 sum = ray.origin + ray.direction;
    return std::isfinite(sum.x + sum.y + sum.z) && !std::isnan(ray.nearest) &&
           !std::isnan(ray.farthest) && ray.farthest > ray.nearest && ray.direction != vec3(0);
}

void fill(const Ray& from, RTCRay& to) {
    to.org_x = from.origin.x, to.org_y = from.origin.y, to.org_z = from.origin.z;
    to.dir_x = from.direction.x, to.dir_y = from.direction.y, to.dir_z = from.direction.z;
    to.tnear = std::max(from.nearest, 0.0f);
    to.tfar = from.farthest;
    to.time = 0;
    to.mask = ~0u;
    to.id = 0;
    to.flags = 0;
}

/// Nothing when the transform is not finite or has no inverse.
bool place(const Instance& instance, Placed& out) {
    const mat4x3& m = instance.worldFromLocal;
    const mat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const float determinant = glm::dot(m[0], cofactor[0]);
    const vec3 sum = m[0] + m[1] + m[2] + m[3];
    if (!std::isfinite(sum.x + sum.y + sum.z) || !std::isnormal(determinant)) return false;
    out.worldFromLocal = m;
    out.normalFromLocal = determinant < 0 ? -cofactor : cofactor;
    out.castsShadow = instance.flags & kInstanceCastsShadow;
    return true;
}

}  // namespace

struct RayScene::State {
    explicit State(JobSystem& j) : jobs(j) {}

    Result<void> checkDevice(const char* what) const {
        const RTCError error = rtcGetDeviceError(device.get());
        if (error == RTC_ERROR_NONE) return {};
        return fail("ray scene",
                    std::string("Embree failed while ") + what + " (error " +
                        std::to_string(int(error)) +
                        (error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory)." : ")."));
    }
    void chooseInstances(std::span<const Instance> instances);
    void buildMeshes();
    void buildTop(EmbreeOwner<RTCScene>& scene, bool ofGlass);
    bool trace(RTCScene scene, const Ray& ray, bool castersOnly, RayHit& hit) const;
    vec3 colorBetween(const RayScene& scene, Ray ray, bool castersOnly) const;
    const Placed& placedOf(uint32_t instance) const;
    Query query(bool castersOnly) const {
        Query q;
        rtcInitIntersectContext(&q.context);
        q.placed = &placed;
        q.images = &images;
        q.castersOnly = castersOnly;
        return q;
    }

    JobSystem& jobs;
    EmbreeOwner<RTCDevice> device;
    std::unordered_map<uint32_t, std::unique_ptr<RayMesh>> meshes;
    std::unordered_map<uint32_t, RayImage> images;
    std::unordered_map<uint32_t, MaterialDesc> materials;
    MaterialDesc defaultMaterial;
    std::vector<Placed> placed;
    EmbreeOwner<RTCScene> top, glass;  // glass: null where there is none
    Aabb bounds;
    uint64_t triangles = 0;
    uint32_t rejected = 0;
};

RayScene::RayScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
RayScene::~RayScene() = default;

Result<std::unique_ptr<RayScene>> RayScene::create(JobSystem& jobs) {
    auto state = std::make_unique<State>(jobs);
    // One thread: Embree then builds where it is called, and meshes are built side by side on the
    // host's threads.
    state->device.reset(rtcNewDevice("threads=1"));
    if (!state->device)
        return fail("ray scene", "Embree could not be started (error " +
                                     std::to_string(int(rtcGetDeviceError(nullptr))) + ").");
    return std::unique_ptr<RayScene>(new RayScene(std::move(state)));
}

Result<void> RayScene::setMesh(MeshHandle handle, const MeshDesc& desc) {
    auto mesh = makeRayMesh(desc);
    if (!mesh) return tl::unexpected(mesh.error());
    state_->placed.clear();  // they may name the mesh that goes
    state_->top.reset();
    state_->glass.reset();
    state_->meshes[handle.value] = std::make_unique<RayMesh>(std::move(*mesh));
    return {};
}

Result<void> RayScene::setImage(ImageHandle handle, const ImageDesc& desc) {
    auto image = RayImage::create(desc);
    if (!image) return tl::unexpected(image.error());
    state_->images.insert_or_assign(handle.value, std::move(*image));
    return {};
}

Result<void> RayScene::setMaterial(MaterialHandle handle, const MaterialDesc& desc) {
    MaterialDesc& kept = state_->materials[handle.value];
    kept = desc;
    kept.label = {};
    return {};
}

void RayScene::State::chooseInstances(std::span<const Instance> instances) {
    placed.clear();
    bounds = {};
    triangles = 0;
    rejected = 0;
    for (size_t i = 0; i < instances.size(); ++i) {
        Placed p;
        const auto mesh = meshes.find(instances[i].mesh.value);
        if (mesh == meshes.end() || !place(instances[i], p)) {
            ++rejected;
            continue;
        }
        const auto material = materials.find(instances[i].material.value);
        p.material = material == materials.end() ? &defaultMaterial : &material->second;
        p.glass = p.material->transmission > 0 && !p.material->unlit;
        if (p.material->alphaMode == AlphaMode::blend && !p.glass) continue;
        p.mesh = mesh->second.get();
        const auto positions = std::span(p.mesh->positions).first(p.mesh->vertexCount());
        p.closed = p.glass && isClosed(positions, p.mesh->indices);
        p.index = uint32_t(i);
        placed.push_back(p);
        bounds.grow(transformAabb(p.worldFromLocal, p.mesh->bounds));
        triangles += p.mesh->indices.size() / 3;
    }
}

void RayScene::State::buildMeshes() {
    std::vector<RayMesh*> used;
    std::unordered_map<RayMesh*, bool> filtered;
    for (const Placed& p : placed) {
        const auto [at, isNew] = filtered.try_emplace(p.mesh, false);
        if (isNew) used.push_back(p.mesh);
        at->second |= p.material->alphaMode == AlphaMode::mask || !p.castsShadow;
    }
    std::erase_if(used, [&](RayMesh* m) { return !m->dirty && m->filtered == filtered[m]; });
    std::vector<uint8_t> filters;
    for (RayMesh* mesh : used) filters.push_back(filtered[mesh]);
    jobs.forRanges(uint32_t(used.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i)
            buildRayMesh(*used[i], device.get(), filters[i] ? filterHit : nullptr);
    });
}

void RayScene::State::buildTop(EmbreeOwner<RTCScene>& scene, bool ofGlass) {
    scene.reset(rtcNewScene(device.get()));
    for (uint32_t i = 0; i < placed.size(); ++i) {
        if (placed[i].glass != ofGlass) continue;
        const EmbreeOwner<RTCGeometry> instance(
            rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        rtcSetGeometryInstancedScene(instance.get(), placed[i].mesh->scene.get());
        rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                &placed[i].worldFromLocal);
        rtcCommitGeometry(instance.get());
        rtcAttachGeometryByID(scene.get(), instance.get(), i);
    }
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene.get());
}

Result<void> RayScene::build(std::span<const Instance> instances) {
    State& s = *state_;
    s.top.reset();
    s.glass.reset();
    s.chooseInstances(instances);
    s.buildMeshes();
    if (auto ok = s.checkDevice("building the meshes"); !ok) return ok;
    s.buildTop(s.top, false);
    if (std::ranges::any_of(s.placed, &Placed::glass)) s.buildTop(s.glass, true);
    return s.checkDevice("building the scene");
}

uint32_t RayScene::rejected() const { return state_->rejected; }
Aabb RayScene::bounds() const { return state_->bounds; }
uint64_t RayScene::triangles() const { return state_->triangles; }

bool RayScene::State::trace(RTCScene scene, const Ray& ray, bool castersOnly, RayHit& hit) const {
    if (!scene || !isFinite(ray)) return false;
    RTCRayHit rayHit;
    fill(ray, rayHit.ray);
    rayHit.hit.geomID = rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Query query = this->query(castersOnly);
    rtcIntersect1(scene, &query.context, &rayHit);
    if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const Placed& p = placed[rayHit.hit.instID[0]];
    const RayMesh& mesh = *p.mesh;
    hit.distance = rayHit.ray.tfar;
    hit.instance = p.index;
    hit.triangle = rayHit.hit.primID;
    hit.barycentrics = {rayHit.hit.u, rayHit.hit.v};
    hit.position = transformPoint(p.worldFromLocal,
                                  mesh.interpolate(mesh.positions, hit.triangle, hit.barycentrics));
    const uint32_t* corner = &mesh.indices[size_t(hit.triangle) * 3];
    const vec3 a = mesh.positions[corner[0]];
    const vec3 face = glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a);
    hit.geometricNormal = glm::normalize(p.normalFromLocal * face);
    const float length = glm::length(hit.geometricNormal);
    if (!(length > 0.5f)) return false;  // a sliver without an area
    hit.shadingNormal = hit.geometricNormal;
    if (!mesh.normals.empty()) {
        const vec3 n = p.normalFromLocal *
                       mesh.interpolate(mesh.normals, hit.triangle, hit.barycentrics);
        if (const float l = glm::length(n); l > 0 && std::isfinite(l)) hit.shadingNormal = n / l;
    }
    hit.front = glm::dot(hit.geometricNormal, ray.direction) < 0;
    return true;
}

// One after the other, each from beyond the last: a ray that passes exactly between two triangles
// may meet both.
vec3 RayScene::State::colorBetween(const RayScene& scene, Ray ray, bool castersOnly) const {
    constexpr uint32_t kMostLayers = 64;
    vec3 color(1);
    RayHit hit;
    for (uint32_t i = 0; i < kMostLayers && trace(glass.get(), ray, castersOnly, hit); ++i) {
        const Placed& p = placedOf(hit.instance);
        if (hit.front || !p.closed || p.material->doubleSided) color *= scene.surface(hit).through;
        ray.nearest = hit.distance * 1.00001f + 1e-5f;
    }
    return color;
}

const Placed& RayScene::State::placedOf(uint32_t instance) const {
    const auto found = std::lower_bound(placed.begin(), placed.end(), instance,
                                        [](const Placed& p, uint32_t i) { return p.index < i; });
    RL_CHECK(found != placed.end() && found->index == instance,
             "a hit's instance is in the scene that was hit");
    return *found;
}

bool RayScene::intersect(const Ray& ray, RayHit& hit) const {
    return state_->trace(state_->top.get(), ray, false, hit);
}

vec3 RayScene::transmittance(const Ray& ray) const {
    return occluded(ray) ? vec3(0) : state_->colorBetween(*this, ray, true);
}

vec3 RayScene::colorBetween(const Ray& ray) const {
    return state_->colorBetween(*this, ray, false);
}

bool RayScene::occluded(const Ray& ray) const {
    const State& s = *state_;
    if (!s.top || !isFinite(ray)) return false;
    RTCRay traced;
    fill(ray, traced);
    Query query = s.query(true);
    rtcOccluded1(s.top.get(), &query.context, &traced);
    return traced.tfar < 0;
}

RaySurface RayScene::surface(const RayHit& hit) const {
    const State& s = *state_;
    const Placed& placed = s.placedOf(hit.instance);
    const RayMesh& mesh = *placed.mesh;
    const MaterialDesc& m = *placed.material;
    const auto texel = [&](const TextureSlot& slot) {
        const auto image = s.images.find(slot.image.value);
        if (!slot.image || image == s.images.end()) return vec4(1);
        return image->second.sample(slot, uvOf(mesh, slot, hit.triangle, hit.barycentrics));
    };
    RaySurface out;
    const vec4 base = m.baseColor * texel(m.baseColorTexture) *
                      colorOf(mesh, hit.triangle, hit.barycentrics);
    const vec4 roughMetal = texel(m.metallicRoughnessTexture);
    out.baseColor = glm::clamp(vec3(base), 0.0f, 1.0f);
    out.metallic = std::clamp(m.metallic * roughMetal.z, 0.0f, 1.0f);
    out.roughness = std::clamp(m.roughness * roughMetal.y, 0.0f, 1.0f);
    out.emissive = glm::max(m.emissive * vec3(texel(m.emissiveTexture)), vec3(0));
    out.doubleSided = m.doubleSided;
    out.unlit = m.unlit;
    if (placed.glass) {
        const float share = m.transmission * texel(m.transmissionTexture).x * (1 - out.metallic);
        const float coverage = m.alphaMode == AlphaMode::blend ? std::clamp(base.w, 0.0f, 1.0f) : 1;
        out.through = glm::mix(vec3(1), out.baseColor * m.transmissionColor * share, coverage);
    }
    return out;
}

vec3 offsetOrigin(const vec3& position, const vec3& normal) {
    constexpr float kNearZero = 1.0f / 32, kFloatScale = 1.0f / 65536, kIntScale = 256;
    vec3 out;
    for (int c = 0; c < 3; ++c) {
        const int32_t steps = int32_t(kIntScale * normal[c]);
        const int32_t bits = std::bit_cast<int32_t>(position[c]);
        const float moved = std::bit_cast<float>(bits + (position[c] < 0 ? -steps : steps));
        out[c] = std::abs(position[c]) < kNearZero ? position[c] + kFloatScale * normal[c] : moved;
    }
    return out;
}

}  // namespace rushlight
