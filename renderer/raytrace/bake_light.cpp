#include "renderer/raytrace/bake_light.h"

#include "engine/core/hash.h"
#include "interop/tonemap.h"
#include "renderer/lighting/environment/equirect.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kTableWidth = 128;

/// The radiance whose irradiance over pi is mix(ground, sky, n.y / 2 + 1/2), as the shaders have
/// it, where it can be.
vec3 hemisphere(const vec3& sky, const vec3& ground, float y) {
    return glm::max(0.5f * (sky + ground) + 0.75f * y * (sky - ground), vec3(0));
}

}  // namespace

uint64_t hashOf(const BakeLighting& lighting) {
    uint64_t hash = 1;
    const auto add = [&](const auto& value) { hash = hashBytes(&value, sizeof value, hash); };
    for (const DirectionalLight& light : lighting.directional) {
        add(light.direction);
        add(light.illuminance);
    }
    for (const PunctualLight& light : lighting.punctual) {
        add(light.position);
        add(light.intensity);
        add(light.range);
        add(light.direction);
        add(light.innerConeAngle);
        add(light.outerConeAngle);
        for (const LightPattern* pattern :
             {lighting.patterns ? lighting.patterns->find(light.profile) : nullptr,
              lighting.patterns ? lighting.patterns->find(light.cookie) : nullptr}) {
            if (!pattern) continue;
            hash = hashBytes(pattern->texels.data(), pattern->texels.size() * sizeof(vec3), hash);
            add(pattern->perRadian);
            add(light.up);
        }
    }
    for (const AreaLight& light : lighting.area) {
        add(uint8_t(light.shape));
        add(light.position);
        add(light.halfX);
        add(light.halfY);
        add(light.radius);
        add(light.luminance);
        add(uint8_t(light.twoSided));
        add(light.range);
        add(light.shadowNear);
    }
    const EnvironmentDesc& env = lighting.environment;
    hash = hashBytes(env.pixels.data(), env.pixels.size_bytes(), hash);
    if (!env.pixels.empty()) {
        add(env.width);
        add(lighting.environmentRotation);
        add(lighting.environmentIntensity);
    } else {
        add(lighting.ambientSky);
        add(lighting.ambientGround);
    }
    return hash;
}

Result<BakeLight> BakeLight::create(const BakeLighting& lighting, JobSystem& jobs) {
    BakeLight out;
    out.patterns_ = lighting.patterns;
    const auto wrong = [](const char* what) {
        return fail("baked light", what, ErrorKind::wrongUse);
    };
    for (const DirectionalLight& light : lighting.directional) {
        const float length = glm::length(light.direction);
        if (!(length > 0) || !std::isfinite(length) || !isFinite(light.illuminance))
            return wrong("a directional light is not finite or has no direction.");
        out.suns_.push_back(light);
        out.suns_.back().direction /= length;
    }
    for (const PunctualLight& light : lighting.punctual) {
        if (!isFinite(light.position) || !isFinite(light.intensity) || !isFinite(light.direction) ||
            !std::isfinite(light.range + light.innerConeAngle + light.outerConeAngle))
            return wrong("a point or spot light is not finite.");
        out.punctual_.push_back(light);
    }
    for (const AreaLight& light : lighting.area) {
        if (!isFinite(light.position) || !isFinite(light.luminance) || !isFinite(light.halfX) ||
            !isFinite(light.halfY) || !std::isfinite(light.radius + light.range + light.shadowNear))
            return wrong("an area light is not finite.");
        out.area_.push_back(light);
    }
    if (!isFinite(lighting.ambientSky) || !isFinite(lighting.ambientGround) ||
        !std::isfinite(lighting.environmentRotation + lighting.environmentIntensity))
        return wrong("the ambient light or the environment's rotation or intensity is not finite.");
    const EnvironmentDesc& env = lighting.environment;
    if (env.pixels.size() != size_t(env.width) * env.height ||
        (!env.pixels.empty() && (env.width > 16384 || env.height > 16384)))
        return wrong("the environment's size does not fit its pixels.");
    out.makeTable(lighting, jobs);
    return out;
}

void BakeLight::makeTable(const BakeLighting& lighting, JobSystem& jobs) {
    const EnvironmentDesc& env = lighting.environment;
    if (!env.pixels.empty()) {
        turn_ = {std::cos(lighting.environmentRotation), std::sin(lighting.environmentRotation)};
        const Equirect table = makeEquirect(env, kTableWidth, jobs);
        width_ = table.width;
        height_ = table.height;
        for (const vec4& texel : table.texels)
            radiance_.push_back(vec3(texel) * std::max(lighting.environmentIntensity, 0.0f));
    } else if (lighting.ambientSky != vec3(0) || lighting.ambientGround != vec3(0)) {
        width_ = kTableWidth;
        height_ = kTableWidth / 2;
        for (uint32_t i = 0; i < width_ * height_; ++i) {
            const vec3 d = equirectDirection(0.5f, (float(i / width_) + 0.5f) / float(height_));
            radiance_.push_back(hemisphere(lighting.ambientSky, lighting.ambientGround, d.y));
        }
    }
    double total = 0;
    std::vector<double> sums;
    for (uint32_t i = 0; i < radiance_.size(); ++i) {
        total += double(interop::luminance(radiance_[i])) *
                 double(equirectTexelSolidAngle(i / width_, width_, height_));
        sums.push_back(total);
    }
    if (!(total > 0)) {
        radiance_.clear();
        return;
    }
    for (uint32_t i = 0; i < radiance_.size(); ++i) {
        cumulative_.push_back(float(sums[i] / total));
        density_.push_back(float(double(interop::luminance(radiance_[i])) / total));
    }
}

uint32_t BakeLight::texelOf(const vec3& d) const {
    const float u = std::atan2(d.z, d.x) * (0.5f / kPi) + 0.5f;
    const float v = 0.5f - std::asin(std::clamp(d.y, -1.0f, 1.0f)) * (1 / kPi);
    const uint32_t x = std::min(uint32_t(std::max(u, 0.0f) * float(width_)), width_ - 1);
    const uint32_t y = std::min(uint32_t(std::max(v, 0.0f) * float(height_)), height_ - 1);
    return y * width_ + x;
}

vec3 BakeLight::sky(const vec3& direction) const {
    return radiance_.empty() ? vec3(0) : radiance_[texelOf(toTable(direction))];
}

float BakeLight::skyDensity(const vec3& direction) const {
    return radiance_.empty() ? 0 : density_[texelOf(toTable(direction))];
}

SkySample BakeLight::sampleSky(RayRandom& random) const {
    const float which = random.next(), u = random.next(), v = random.next();
    if (radiance_.empty()) return {};
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), which);
    const uint32_t texel = uint32_t(
        std::min<size_t>(size_t(found - cumulative_.begin()), cumulative_.size() - 1));
    const uint32_t x = texel % width_, y = texel / width_;
    // Evenly by solid angle within the texel: by sine of the latitude.
    const float top = std::cos(kPi * float(y) / float(height_));
    const float bottom = std::cos(kPi * float(y + 1) / float(height_));
    const float sine = top + (bottom - top) * v;
    const float ring = std::sqrt(std::max(0.0f, 1 - sine * sine));
    const float phi = ((float(x) + u) / float(width_) - 0.5f) * 2 * kPi;
    const vec3 d(ring * std::cos(phi), sine, ring * std::sin(phi));
    SkySample s;
    s.direction = {turn_.x * d.x + turn_.y * d.z, d.y, -turn_.y * d.x + turn_.x * d.z};
    s.radiance = radiance_[texel];
    s.density = density_[texel];
    return s;
}

}  // namespace rushlight
