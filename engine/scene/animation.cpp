// Key-frame interpolation: glTF 2.0, section 3.11 and appendix C.
#include "engine/scene/pose.h"

#include <algorithm>

namespace rushlight::scene {
namespace {

using assets::AnimationChannel;
using assets::AnimationPath;
using assets::Interpolation;

/// The keys around a moment and how far it is from the first to the second.
struct KeySpan {
    size_t first = 0;
    size_t second = 0;
    float fraction = 0;
    float duration = 0;
};

KeySpan findKeys(const std::vector<float>& times, float seconds) {
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin()) return {};
    const size_t first = size_t(after - times.begin()) - 1;
    if (after == times.end()) return {first, first, 0, 0};
    const float duration = times[first + 1] - times[first];
    return {first, first + 1, (seconds - times[first]) / duration, duration};
}

/// Each key of a cubic spline is three elements: in-tangent, value, out-tangent.
float cubicValue(const float* values, const KeySpan& span, size_t components, size_t c) {
    const auto element = [&](size_t key, size_t part) {
        return values[(key * 3 + part) * components + c];
    };
    const float v0 = element(span.first, 1);
    if (span.first == span.second) return v0;
    const float v1 = element(span.second, 1);
    const float b0 = span.duration * element(span.first, 2);
    const float a1 = span.duration * element(span.second, 0);
    const float t = span.fraction, t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * v0 + (t3 - 2 * t2 + t) * b0 + (3 * t2 - 2 * t3) * v1 +
           (t3 - t2) * a1;
}

void sample(const AnimationChannel& channel, const KeySpan& span, size_t components, float* out) {
    const float* values = channel.values.data();
    const float fraction = channel.interpolation == Interpolation::step ? 0 : span.fraction;
    for (size_t c = 0; c < components; ++c) {
        if (channel.interpolation == Interpolation::cubicSpline) {
            out[c] = cubicValue(values, span, components, c);
            continue;
        }
        const float a = values[span.first * components + c];
        const float b = values[span.second * components + c];
        out[c] = a + fraction * (b - a);
    }
}

quat toQuat(const float* v) { return glm::normalize(quat(v[3], v[0], v[1], v[2])); }

quat sampleRotation(const AnimationChannel& channel, const KeySpan& span) {
    if (channel.interpolation == Interpolation::linear) {
        const quat a = toQuat(&channel.values[span.first * 4]);
        const quat b = toQuat(&channel.values[span.second * 4]);
        return glm::normalize(glm::slerp(a, b, span.fraction));
    }
    float value[4];
    sample(channel, span, 4, value);
    return toQuat(value);
}

vec3 sampleVector(const AnimationChannel& channel, const KeySpan& span) {
    vec3 value(0);
    sample(channel, span, 3, &value.x);
    return value;
}

void sampleWeights(const AnimationChannel& channel, const KeySpan& span, NodePose& pose) {
    const size_t parts = channel.interpolation == Interpolation::cubicSpline ? 3 : 1;
    pose.weights.resize(channel.values.size() / (channel.times.size() * parts));
    sample(channel, span, pose.weights.size(), pose.weights.data());
}

}  // namespace

void applyAnimation(const assets::Model& model, const assets::Animation& animation, float seconds,
                    Pose& pose) {
    for (const AnimationChannel& channel : animation.channels) {
        if (channel.node < 0 || size_t(channel.node) >= model.nodes.size()) continue;
        const KeySpan span = findKeys(channel.times, seconds);
        NodePose& node = pose.nodes[size_t(channel.node)];
        switch (channel.path) {
            case AnimationPath::translation: node.translation = sampleVector(channel, span); break;
            case AnimationPath::rotation: node.rotation = sampleRotation(channel, span); break;
            case AnimationPath::scale: node.scale = sampleVector(channel, span); break;
            case AnimationPath::weights: sampleWeights(channel, span, node); break;
        }
    }
}

}  // namespace rushlight::scene
