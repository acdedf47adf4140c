#include "renderer/raytrace/path_tracer.h"

#include "interop/brdf.h"
#include "interop/tonemap.h"
#include "renderer/geometry/vertex_packing.h"
#include "renderer/raytrace/area_sampling.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

struct PathTracer::Surface {
    vec3 origin;  // off the surface
    // Geometric, on the side the path came from: it loses no energy where a smooth normal points
    // away from a coarse triangle, and what is gathered is smooth anyway.
    vec3 normal;
    vec3 albedo;
};

namespace {

constexpr uint32_t kSureBounces = 2;  // before paths may end by chance
constexpr float kMostSurvival = 0.95f;

vec3 hemisphericalAlbedo(const RaySurface& s, float nDotV, const BrdfTable& table) {
    const vec3 f0 = glm::mix(vec3(interop::kDielectricF0), s.baseColor, s.metallic);
    const vec2 split = table.lookUp(nDotV, interop::clampRoughness(s.roughness));
    const interop::EnvironmentWeights w = interop::environmentWeights(
        s.baseColor * (1 - s.metallic), f0, split);
    return glm::clamp(w.diffuse + w.specular, vec3(0), vec3(1));
}

vec3 cosineDirection(const vec3& normal, RayRandom& random) {
    const float r = std::sqrt(random.next()), phi = 2 * kPi * random.next();
    const vec3 tangent = perpendicular(normal);
    const vec3 d = tangent * (r * std::cos(phi)) +
                   glm::cross(normal, tangent) * (r * std::sin(phi)) +
                   normal * std::sqrt(std::max(0.0f, 1 - r * r));
    return glm::normalize(d);
}

/// Draws one light of many by what each would give, as they come by.
class DrawnLight {
public:
    explicit DrawnLight(RayRandom& random) : random_(random) {}

    /// True where this is the one drawn so far.
    bool offer(const vec3& irradiance) {
        const float weight = interop::luminance(irradiance);
        if (!(weight > 0)) return false;
        total_ += weight;
        if (random_.next() * total_ > weight) return false;
        irradiance_ = irradiance;
        weight_ = weight;
        return true;
    }
    explicit operator bool() const { return weight_ > 0; }
    /// Of the light drawn, in the stead of all.
    vec3 irradiance() const { return irradiance_ * (total_ / weight_); }

private:
    RayRandom& random_;
    float total_ = 0, weight_ = 0;
    vec3 irradiance_{0};
};

}  // namespace

// Irradiance of suns, point, spot and area lights.
vec3 PathTracer::lampLight(const Surface& s, RayRandom& random) const {
    vec3 sum(0);
    for (const DirectionalLight& sun : light_.suns()) {
        const float cosine = -glm::dot(s.normal, sun.direction);
        if (cosine <= 0) continue;
        sum += sun.illuminance * cosine * scene_.transmittance({s.origin, -sun.direction});
    }
    return sum + punctualLight(s, random) + areaLight(s, random);
}

// Irradiance of all lamps, by one shadow ray: a light is drawn by what it would give if nothing
// were in between.
vec3 PathTracer::punctualLight(const Surface& s, RayRandom& random) const {
    DrawnLight drawn(random);
    vec3 towards(0);
    float distance = 0;
    for (const PunctualLight& light : light_.punctual()) {
        const vec3 to = light.position - s.origin;
        const float distance2 = glm::dot(to, to);
        if (light.range > 0 && distance2 > light.range * light.range) continue;
        const vec3 l = to / std::sqrt(std::max(distance2, 1e-8f));
        const float cosine = glm::dot(s.normal, l);
        if (cosine <= 0) continue;
        float attenuation = interop::distanceAttenuation(distance2,
                                                         interop::inverseRangeSquared(light.range));
        if (light.outerConeAngle >= 0)
            attenuation *= interop::spotAttenuation(
                -glm::dot(l, light.direction),
                interop::spotScaleOffset(light.innerConeAngle, light.outerConeAngle));
        if (!drawn.offer(light.intensity * light_.pattern(light, -l) * (attenuation * cosine)))
            continue;
        towards = l;
        distance = std::sqrt(distance2);
    }
    if (!drawn) return vec3(0);
    return drawn.irradiance() * scene_.transmittance({s.origin, towards, 0, distance * 0.9999f});
}

// As punctualLight: of a point on each light one is drawn by what it would give.
vec3 PathTracer::areaLight(const Surface& s, RayRandom& random) const {
    DrawnLight drawn(random);
    Ray ray;
    for (const AreaLight& light : light_.area()) {
        const AreaSample sample = sampleAreaLight(light, s.origin, random);
        if (drawn.offer(sample.light * std::max(glm::dot(s.normal, sample.direction), 0.0f)))
            ray = {s.origin, sample.direction, 0, sample.distance};
    }
    if (!drawn) return vec3(0);
    const vec3 share = ray.farthest > 0 ? scene_.transmittance(ray) : vec3(1);
    return drawn.irradiance() * share;
}

// What stands for an area light shines already as that light.
vec3 PathTracer::glow(const RaySurface& surface, const vec3& position,
                      const vec3& direction) const {
    const vec3 color = surface.unlit ? surface.baseColor : surface.emissive;
    if (color == vec3(0)) return color;
    for (const AreaLight& light : light_.area())
        if (standsFor(light, position, direction)) return vec3(0);
    return color;
}

vec3 PathTracer::skyLight(const Surface& s, RayRandom& random) const {
    const SkySample sky = light_.sampleSky(random);
    if (!(sky.density > 0)) return vec3(0);
    const float cosine = glm::dot(s.normal, sky.direction);
    if (cosine <= 0) return vec3(0);
    return sky.radiance * (cosine / (sky.density + cosine * interop::kInversePi)) *
           scene_.transmittance({s.origin, sky.direction});
}

vec3 PathTracer::radiance(const vec3& origin, const vec3& direction, float density,
                          float skySamples, RayRandom& random) const {
    vec3 sum(0), throughput(1);
    Ray ray{origin, direction};
    for (uint32_t bounce = 0;; ++bounce) {
        RayHit hit;
        if (!scene_.intersect(ray, hit)) {
            const float other = skySamples * light_.skyDensity(ray.direction);
            const float share = std::isinf(density) ? 1 : density / (density + other);
            return sum + throughput * light_.sky(ray.direction) * share * scene_.colorBetween(ray);
        }
        throughput *= scene_.colorBetween({ray.origin, ray.direction, ray.nearest, hit.distance});
        const RaySurface surface = scene_.surface(hit);
        if (!hit.front && !surface.doubleSided) return sum;
        sum += throughput * glow(surface, hit.position, ray.direction);
        if (surface.unlit) return sum;

        Surface s;
        s.normal = hit.front ? hit.geometricNormal : -hit.geometricNormal;
        const float nDotV = std::clamp(-glm::dot(s.normal, ray.direction), interop::kMinNdotV,
                                       1.0f);
        s.albedo = hemisphericalAlbedo(surface, nDotV, table_);
        s.origin = offsetOrigin(hit.position, s.normal);
        const vec3 outgoing = throughput * s.albedo;
        sum += outgoing * interop::kInversePi * lampLight(s, random);
        if (known_ && bounce == 0)
            if (const vec4 known = sampleIrradiance(*known_, hit.position, s.normal); known.w == 1)
                return sum + outgoing * vec3(known);
        sum += outgoing * interop::kInversePi * skyLight(s, random);
        if (bounce >= bounces_) return sum;

        throughput = outgoing;
        if (bounce >= kSureBounces) {
            const float survival = std::min(
                std::max(throughput.x, std::max(throughput.y, throughput.z)), kMostSurvival);
            if (!(random.next() < survival)) return sum;
            throughput /= survival;
        }
        const vec3 d = cosineDirection(s.normal, random);
        density = std::max(glm::dot(d, s.normal), 1e-6f) * interop::kInversePi;
        skySamples = 1;
        ray = {s.origin, d};
    }
}

}  // namespace rushlight
