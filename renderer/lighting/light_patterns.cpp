#include "renderer/lighting/light_patterns.h"

#include "interop/light_patterns.h"
#include "renderer/geometry/vertex_packing.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kSide = RL_LIGHT_PATTERN_SIDE;
constexpr uint32_t kMaxImageSide = 16384;
constexpr float kRadian = kPi / 180;

bool isIncreasing(std::span<const float> angles, float low, float high) {
    if (!(angles.front() >= low) || !(angles.back() <= high)) return false;
    for (size_t i = 1; i < angles.size(); ++i)
        if (!(angles[i] > angles[i - 1])) return false;
    return true;
}

std::string degrees(float angle) { return std::to_string(angle) + " degrees"; }

Result<void> checkAngles(const LightProfileDesc& desc, const std::string& object) {
    if (desc.verticalAngles.size() < 2 || !isIncreasing(desc.verticalAngles, 0, 180))
        return fail(
            object,
            "its vertical angles must be two or more that increase within 0 and 180 degrees.");
    const std::span<const float> h = desc.horizontalAngles;
    if (h.empty() || !isIncreasing(h, 0, 360))
        return fail(
            object,
            "its horizontal angles must be one or more that increase within 0 and 360 degrees.");
    const float first = h.front(), last = h.back();
    const bool known = first == 0 ? (last == 0 || last == 90 || last == 180 || last == 360)
                                  : first == 90 && last == 270;
    if (!known)
        return fail(object,
                    "its horizontal angles reach from " + degrees(first) + " to " + degrees(last) +
                        "; 0 alone, 0 to 90, 0 to 180, 0 to 360 and 90 to 270 are possible.");
    return {};
}

/// Of what is measured: where `angle` lies between neighbours, which is exact at both ends.
struct Place {
    size_t index;
    float fraction;
};

Place placeOf(std::span<const float> angles, float angle) {
    if (angles.size() == 1) return {0, 0};
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const size_t next = std::clamp<size_t>(size_t(above - angles.begin()), 1, angles.size() - 1);
    const float low = angles[next - 1], high = angles[next];
    return {next - 1, std::clamp((angle - low) / (high - low), 0.0f, 1.0f)};
}

/// The measured angle that stands for one of the whole turn.
float mirrored(float angle, std::span<const float> h) {
    if (h.size() == 1 || h.back() == 360) return angle;
    if (h.front() == 90) return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
    if (angle > 180) angle = 360 - angle;
    return h.back() == 90 && angle > 90 ? 180 - angle : angle;
}

float candelaAt(const LightProfileDesc& desc, float vertical, float horizontal) {
    constexpr float kSlack = 1e-3f;  // a rounding at the ends is not dark
    if (vertical < desc.verticalAngles.front() - kSlack ||
        vertical > desc.verticalAngles.back() + kSlack)
        return 0;
    const Place v = placeOf(desc.verticalAngles, vertical);
    const Place h = placeOf(desc.horizontalAngles, mirrored(horizontal, desc.horizontalAngles));
    const size_t columns = desc.verticalAngles.size();
    const auto along = [&](size_t row) {
        const float* at = &desc.candela[row * columns + v.index];
        return std::lerp(at[0], at[1], v.fraction);
    };
    if (desc.horizontalAngles.size() == 1) return along(0);
    return std::lerp(along(h.index), along(h.index + 1), h.fraction);
}

/// The mean of the image under a texel; between pixels it is bilinear.
vec3 resampled(const ImageDesc& image, uint32_t x, uint32_t y) {
    const auto texel = [&](uint32_t column, uint32_t row) {
        const uint8_t* p = &image.pixels[(size_t(row) * image.width + column) * 4];
        const vec3 c = vec3(p[0], p[1], p[2]) / 255.0f;
        if (!image.srgb) return c;
        return glm::mix(glm::pow((c + 0.055f) / 1.055f, vec3(2.4f)), c / 12.92f,
                        glm::lessThanEqual(c, vec3(0.04045f)));
    };
    const auto samples = [](uint32_t size) {
        return std::clamp((size + kSide - 1) / kSide, 1u, 8u);
    };
    const auto split = [](float at, uint32_t size, uint32_t& low, uint32_t& high) {
        const float place = std::clamp(at * float(size) - 0.5f, 0.0f, float(size - 1));
        low = uint32_t(place);
        high = std::min(low + 1, size - 1);
        return place - float(low);
    };
    const uint32_t across = samples(image.width), down = samples(image.height);
    vec3 sum(0);
    for (uint32_t j = 0; j < down; ++j)
        for (uint32_t i = 0; i < across; ++i) {
            uint32_t x0, x1, y0, y1;
            const float fx = split((float(x) + (float(i) + 0.5f) / float(across)) / kSide,
                                   image.width, x0, x1);
            const float fy = split((float(y) + (float(j) + 0.5f) / float(down)) / kSide,
                                   image.height, y0, y1);
            sum += glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx),
                            glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
        }
    return sum / float(across * down);
}

}  // namespace

Result<LightPattern> LightPattern::make(const LightProfileDesc& desc) {
    const std::string object = "light profile '" + std::string(desc.label) + "'";
    if (auto ok = checkAngles(desc, object); !ok) return tl::unexpected(ok.error());
    const size_t count = desc.verticalAngles.size() * desc.horizontalAngles.size();
    if (desc.candela.size() != count)
        return fail(object, "it has " + std::to_string(desc.candela.size()) +
                                " values of candela; its angles need " + std::to_string(count) +
                                ".");
    float largest = 0;
    for (const float value : desc.candela) {
        if (!(value >= 0) || !std::isfinite(value))
            return fail(object, "a value of candela is " + std::to_string(value) +
                                    "; they must be finite and not negative.");
        largest = std::max(largest, value);
    }
    if (!(largest > 0)) return fail(object, "all its values of candela are 0.");

    LightPattern pattern;
    const float span = desc.verticalAngles.back() <= 90 ? 90.0f : 180.0f;
    pattern.perRadian = 1 / (span * kRadian);
    pattern.texels.reserve(size_t(kSide) * kSide);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x)
            pattern.texels.emplace_back(
                candelaAt(desc, span * float(y) / float(kSide - 1), 360 * float(x) / float(kSide)) /
                largest);
    return pattern;
}

Result<LightPattern> LightPattern::make(const LightCookieDesc& desc) {
    const ImageDesc& image = desc.image;
    const std::string object = "light cookie '" + std::string(desc.label) + "'";
    const std::string size = std::to_string(image.width) + "x" + std::to_string(image.height);
    if (image.width == 0 || image.height == 0 || image.width > kMaxImageSide ||
        image.height > kMaxImageSide)
        return fail(object, "its image is " + size + "; each side must be 1 to 16,384 pixels.");
    if (image.pixels.size() != size_t(image.width) * image.height * 4)
        return fail(object, "its image has " + std::to_string(image.pixels.size()) + " bytes but " +
                                size + " RGBA8 needs " +
                                std::to_string(size_t(image.width) * image.height * 4) + ".");
    LightPattern pattern;
    pattern.texels.reserve(size_t(kSide) * kSide);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) pattern.texels.push_back(resampled(image, x, y));
    return pattern;
}

vec3 LightPattern::factor(const vec3& direction, float cotangent) const {
    vec2 uv;
    if (perRadian > 0) {
        const vec2 angles = interop::webAngles(direction, perRadian);
        if (angles.y > 1) return vec3(0);
        uv = interop::webCoordinates(angles);
    } else {
        uv = interop::cookieCoordinates(direction, cotangent);
    }
    // As the sampler: repeated along u, clamped along v.
    const vec2 at(uv.x * kSide - 0.5f, std::clamp(uv.y * kSide - 0.5f, 0.0f, float(kSide - 1)));
    const float left = std::floor(at.x);
    const auto column = [](int x) { return size_t(x & int(kSide - 1)); };
    const size_t x0 = column(int(left)), x1 = column(int(left) + 1);
    const size_t y0 = size_t(at.y), y1 = std::min<size_t>(y0 + 1, kSide - 1);
    const auto row = [&](size_t y) {
        return glm::mix(texels[y * kSide + x0], texels[y * kSide + x1], at.x - left);
    };
    return glm::mix(row(y0), row(y1), at.y - float(y0));
}

LightPatternFrame patternFrameOf(const PunctualLight& light) {
    LightPatternFrame frame;
    const float length = glm::length(light.direction);
    frame.forward = length > 0 ? light.direction / length : vec3(0, -1, 0);
    const vec3 right = glm::cross(frame.forward, light.up);
    const float across = glm::length(right);
    frame.right = across > 1e-6f * glm::length(light.up) && across > 0
                      ? right / across
                      : perpendicular(frame.forward);
    frame.up = glm::cross(frame.right, frame.forward);
    if (light.outerConeAngle > 0 && light.outerConeAngle <= kWidestCookieCone)
        frame.cotangent = 1 / std::tan(light.outerConeAngle);
    return frame;
}

vec3 LightPatternSet::factor(const PunctualLight& light, const vec3& direction) const {
    const LightPattern *profile = find(light.profile), *cookie = find(light.cookie);
    if (!profile && !cookie) return vec3(1);
    const LightPatternFrame frame = patternFrameOf(light);
    const vec3 d(glm::dot(direction, frame.right), glm::dot(direction, frame.up),
                 glm::dot(direction, frame.forward));
    return (profile ? profile->factor(d, 0) : vec3(1)) *
           (cookie ? cookie->factor(d, frame.cotangent) : vec3(1));
}

}  // namespace rushlight
