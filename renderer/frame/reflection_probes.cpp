#include "renderer/frame/reflection_probes.h"

#include <bit>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

constexpr uint32_t kLeastCapture = 16;
constexpr uint32_t kMostCapture = 1024;

bool finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

const char* faultOf(const ReflectionProbe& p) {
    if (!finite(p.position) || !finite(p.center)) return "its place is not finite.";
    if (!finite(p.halfSize) || !(p.halfSize.x > 0 && p.halfSize.y > 0 && p.halfSize.z > 0))
        return "its box has no size; every half side must be finite and over 0.";
    if (!finite(p.blend) || !(p.blend.x >= 0 && p.blend.y >= 0 && p.blend.z >= 0))
        return "its blend distance must be finite and not negative.";
    const float turn = glm::length(p.rotation);
    if (!std::isfinite(turn) || std::abs(turn - 1) > 1e-3f)
        return "its rotation is no unit quaternion.";
    if (!std::isfinite(p.intensity) || p.intensity < 0)
        return "its intensity must be finite and not negative.";
    const vec3 place = glm::abs(glm::inverse(p.rotation) * (p.position - p.center));
    if (glm::any(glm::greaterThan(place, p.halfSize * 1.001f)))
        return "it was captured outside of its box.";
    return nullptr;
}

}  // namespace

Result<void> checkReflectionProbes(std::span<const ReflectionProbe> probes) {
    if (probes.size() > kMaxReflectionProbes)
        return fail("lighting",
                    "there are " + std::to_string(probes.size()) +
                        " reflection probes; at most 256 are possible.",
                    ErrorKind::wrongUse);
    for (size_t i = 0; i < probes.size(); ++i)
        if (const char* fault = faultOf(probes[i]))
            return fail("reflection probe " + std::to_string(i), fault, ErrorKind::wrongUse);
    return {};
}

Result<void> checkCapture(const vec3& position, const CaptureDesc& desc) {
    const auto wrong = [](const std::string& what) {
        return fail("capture of an environment", what, ErrorKind::wrongUse);
    };
    if (desc.size < kLeastCapture || desc.size > kMostCapture || !std::has_single_bit(desc.size))
        return wrong("its size is " + std::to_string(desc.size) +
                     "; it must be a power of two from 16 to 1,024 pixels.");
    if (!finite(position)) return wrong("its position is not finite.");
    if (!(desc.nearPlane > 0) || !std::isfinite(desc.nearPlane) || !std::isfinite(desc.farPlane) ||
        (desc.farPlane != 0 && !(desc.farPlane > desc.nearPlane)))
        return wrong("it sees from " + std::to_string(desc.nearPlane) + " to " +
                     std::to_string(desc.farPlane) +
                     " m; the near plane must be over 0 and the far plane beyond it, or 0.");
    return {};
}

}  // namespace rushlight
