#include "tests/support/scenes/shadow_truth.h"

#include "renderer/capture/image_files.h"
#include "renderer/geometry/view_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rushlight {

void ShadowFigures::add(const ShadowFigures& o) {
    pixels += o.pixels, falselyShadowed += o.falselyShadowed, falselyLit += o.falselyLit;
    clear += o.clear, clearShadowed += o.clearShadowed, clearLit += o.clearLit;
}

std::ostream& operator<<(std::ostream& out, const ShadowFigures& f) {
    const auto percent = [](double share) { return std::round(share * 100000) / 1000; };
    return out << f.pixels << " pixels: falsely shadowed " << percent(f.shadowedShare())
               << " %, falsely lit " << percent(f.litShare()) << " %; away from edges " << f.clear
               << ": " << percent(f.clearShadowedShare()) << " %, " << percent(f.clearLitShare())
               << " %";
}

std::vector<float> ShadowTruth::luminance(const FrameInput& input) {
    const auto ticket = renderer_.renderOffscreen(input, width, height, CaptureKind::hdr);
    CapturedImage image;
    if (!ticket || !renderer_.takeCapture(*ticket, true, image)) {
        ADD_FAILURE() << (ticket ? "no capture" : ticket.error().text());
        return std::vector<float>(size_t(width) * height);
    }
    std::vector<float> sums(size_t(width) * height);
    for (size_t i = 0; i < sums.size(); ++i)
        sums[i] = image.rgba32f[4 * i] + image.rgba32f[4 * i + 1] + image.rgba32f[4 * i + 2];
    return sums;
}

std::vector<float> ShadowTruth::term(const FrameInput& given, const LightChoice& light) {
    FrameInput input = given;
    std::vector<DirectionalLight> suns(given.lighting.directional.begin(),
                                       given.lighting.directional.end());
    std::vector<PunctualLight> lights(given.lighting.punctual.begin(),
                                      given.lighting.punctual.end());
    for (size_t i = 0; i < suns.size(); ++i)
        suns[i].illuminance = vec3(light.sun && i == 0 ? 100.0f : 0.0f);
    for (size_t i = 0; i < lights.size(); ++i)
        lights[i].intensity = vec3(!light.sun && i == light.punctual ? 100.0f : 0.0f);
    input.lighting.directional = suns;
    input.lighting.punctual = lights;
    input.lighting.environment = {};
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0);
    input.lighting.background = Background::color;
    input.lighting.backgroundColor = vec3(0);
    input.settings.bloom = false;
    input.settings.lodPixelError = input.settings.shadowLodTexelError = 0;
    input.settings.smallObjectPixels = 0;
    const std::vector<float> on = luminance(input);
    input.settings.shadows = false;
    std::vector<float> term = luminance(input);
    for (DirectionalLight& sun : suns) sun.illuminance = vec3(0);
    for (PunctualLight& l : lights) l.intensity = vec3(0);
    const std::vector<float> base = luminance(input);
    for (size_t i = 0; i < term.size(); ++i) {
        const float all = term[i] - base[i];
        term[i] = all > 0.01f + 0.01f * base[i] ? (on[i] - base[i]) / all : -1;
    }
    return term;
}

bool ShadowTruth::isLit(const FrameInput& input, const LightChoice& light, const vec3& position,
                        const vec3& normal) const {
    Ray ray;
    ray.origin = offsetOrigin(position, normal);
    if (light.sun) {
        ray.direction = -glm::normalize(input.lighting.directional[0].direction);
    } else {
        const PunctualLight& l = input.lighting.punctual[light.punctual];
        const vec3 to = l.position - ray.origin;
        ray.direction = glm::normalize(to);
        ray.farthest = glm::length(to) - l.shadowNear;
    }
    return glm::dot(ray.direction, normal) > 0 && !scene_.occluded(ray);
}

ShadowFigures ShadowTruth::compare(const FrameInput& input, const LightChoice& light) {
    const std::vector<float> shares = term(input, light);
    const CameraMatrices camera = makeCamera(input.view, float(width) / float(height)).value();
    CapturedImage shown{width, height, std::vector<uint8_t>(shares.size() * 4, 255), {}};
    ShadowFigures figures;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const size_t at = size_t(y) * width + x;
            uint8_t* pixel = &shown.rgba8[at * 4];
            const float share = shares[at];
            pixel[0] = pixel[1] = pixel[2] = uint8_t(25 + 150 * std::clamp(share, 0.0f, 1.0f));
            if (share < 0) continue;
            const vec2 uv((float(x) + 0.5f) / float(width), 1 - (float(y) + 0.5f) / float(height));
            Ray ray{camera.position, glm::normalize(camera.relativePosition(uv, 1)), 0};
            RayHit hit;
            if (!scene_.intersect(ray, hit)) continue;
            const vec3 n = hit.front ? hit.geometricNormal : -hit.geometricNormal;
            const bool lit = isLit(input, light, hit.position, n);
            const bool wrong = lit != (share > 0.5f);
            // The truth around, in the surface's plane.
            const vec3 u = glm::normalize(std::abs(n.y) < 0.9f ? glm::cross(n, vec3(0, 1, 0))
                                                               : glm::cross(n, vec3(1, 0, 0)));
            const vec3 v = glm::cross(n, u);
            const float reach = 1.5f * texelMetres(hit.position);
            bool clear = true;
            for (int i = 0; i < 8 && clear; ++i) {
                const float angle = kPi / 4 * float(i);
                const vec3 beside = hit.position +
                                    reach * (std::cos(angle) * u + std::sin(angle) * v);
                clear = isLit(input, light, beside, n) == lit;
            }
            ++figures.pixels;
            figures.clear += clear;
            if (!wrong) continue;
            (lit ? figures.falselyShadowed : figures.falselyLit) += 1;
            if (clear) (lit ? figures.clearShadowed : figures.clearLit) += 1;
            pixel[lit ? 1 : 0] = clear ? 255 : 150;  // red: falsely lit, green: falsely shadowed
            pixel[lit ? 0 : 1] = pixel[2] = 0;
        }
    if (!picture.empty())
        if (const auto saved = saveImage(picture, PictureView(shown)); !saved)
            ADD_FAILURE() << saved.error().text();
    return figures;
}

}  // namespace rushlight
