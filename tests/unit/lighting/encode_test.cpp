// Bit layouts: what is written is what is read back.

#include "interop/encode.h"
#include "renderer/geometry/half.h"
#include "renderer/geometry/vertex_packing.h"
#include "renderer/lighting/environment/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

using namespace interop;

vec3 sphere(uint32_t i, uint32_t count) {
    const vec2 u = hammersley(i, count);
    const float z = 1 - 2 * u.x, ring = std::sqrt(std::max(0.0f, 1 - z * z));
    return {ring * std::cos(2 * kPi * u.y), ring * std::sin(2 * kPi * u.y), z};
}

/// What an RGBA8 attachment keeps.
vec3 throughBytes(const vec3& v) {
    vec3 result;
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(v[c], 0);
        EXPECT_LE(v[c], 1.000001f);
        result[c] = float(std::lround(v[c] * 255)) / 255;
    }
    return result;
}

float degreesBetween(const vec3& a, const vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / kPi;
}

TEST(Encode, NormalSurvivesThreeBytes) {
    float worst = 0;
    for (uint32_t i = 0; i < 200000; ++i) {
        const vec3 n = sphere(i, 200000);
        worst = std::max(worst, degreesBetween(n, unpackNormal(throughBytes(packNormal(n)))));
    }
    EXPECT_LT(worst, 0.06f);
    RecordProperty("worstDegrees", std::to_string(worst));
}

TEST(Encode, AxisNormalsAreExact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            vec3 n(0);
            n[axis] = sign;
            EXPECT_EQ(unpackNormal(throughBytes(packNormal(n))), n);
        }
}

TEST(Encode, VelocityOfAStillPixelIsExactlyZero) {
    EXPECT_EQ(unpackVelocity(throughBytes(packVelocity(vec2(0)))), vec2(0));
    for (const float v : {1e-5f, 0.001f, 0.02f, 0.3f, 1.0f}) {
        const vec2 back = unpackVelocity(throughBytes(packVelocity(vec2(v, -v))));
        const float step = std::sqrt(v) / 2047 + 2.4e-7f;
        EXPECT_NEAR(back.x, v, step);
        EXPECT_FLOAT_EQ(back.y, -back.x);
    }
    EXPECT_EQ(unpackVelocity(throughBytes(packVelocity(vec2(5, -7)))), vec2(1, -1));
}

TEST(Encode, EmissiveKeepsTheBrightestChannelWithinTwoPercent) {
    for (float peak = 1e-3f; peak < 6e4f; peak *= 1.0173f) {
        const vec3 c(peak, peak * 0.7f, peak * 0.11f);
        for (const vec3& radiance : {c, vec3(c.y, c.x, c.z), vec3(c.z, c.y, c.x), vec3(peak)}) {
            const vec3 back = unpackEmissive(throughBytes(packEmissive(radiance)));
            for (int k = 0; k < 3; ++k) {
                // Half a step, when the peak just rounded over to the next exponent.
                const float bits = k == 1 ? 127 : 63.5f;
                EXPECT_NEAR(back[k], radiance[k], peak * 1.001f / bits) << peak << " " << k;
            }
        }
        const vec3 even = unpackEmissive(throughBytes(packEmissive(vec3(peak))));
        EXPECT_NEAR(even.x, peak, 0.016f * peak);
        EXPECT_NEAR(even.y, peak, 0.0079f * peak);
    }
}

TEST(Encode, EmissiveExtremes) {
    const auto roundTrip = [](const vec3& c) {
        return unpackEmissive(throughBytes(packEmissive(c)));
    };
    EXPECT_EQ(roundTrip(vec3(0)), vec3(0));
    EXPECT_EQ(roundTrip(vec3(1)), vec3(1));
    EXPECT_EQ(roundTrip(vec3(0.5f, 4, 0.25f)), vec3(0.5f, 4, 0.25f));
    EXPECT_EQ(roundTrip(vec3(1e9f)).x, kMaxEmissive);
    EXPECT_EQ(roundTrip(vec3(-3, 2, 0)), vec3(0, 2, 0));
}

TEST(Encode, TangentFrameSurvivesSnorm16) {
    float worst = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        const vec3 n = sphere(i, 20000);
        const float angle = float(i) * 0.37f, hand = i % 2 ? 1.0f : -1.0f;
        const vec3 side = glm::normalize(perpendicular(n));
        const vec3 t = side * std::cos(angle) + glm::cross(n, side) * std::sin(angle);
        const auto stored = packTangentFrame(n, vec4(t, hand));
        vec4 frame;
        for (int c = 0; c < 4; ++c) frame[c] = std::max(float(stored[size_t(c)]) / 32767, -1.0f);
        const vec4 tangent = decodeFrameTangent(frame);
        EXPECT_EQ(tangent.w, hand);
        worst = std::max(
            {worst, degreesBetween(n, decodeFrameNormal(frame)), degreesBetween(t, vec3(tangent))});
    }
    EXPECT_LT(worst, 0.01f);
}

TEST(VertexPacking, RepairsWhatIsNoFrame) {
    for (const vec3& n : {vec3(0), vec3(0, 0, -1), vec3(NAN, 0, 0), vec3(3, 0, 0)})
        for (const vec4& t : {vec4(0, 0, 0, 1), vec4(1, 0, 0, -1), vec4(NAN)}) {
            const auto stored = packTangentFrame(n, t);
            const vec4 frame = vec4(stored[0], stored[1], stored[2], stored[3]) / 32767.0f;
            const vec3 normal = decodeFrameNormal(frame);
            const vec3 tangent = vec3(decodeFrameTangent(frame));
            EXPECT_NEAR(glm::length(normal), 1, 1e-4f);
            EXPECT_NEAR(glm::dot(normal, tangent), 0, 1e-3f);
        }
}

TEST(Half, AgreesWithTheFormat) {
    for (uint32_t bits = 0; bits < 0x7c00; ++bits)
        ASSERT_EQ(toHalf(fromHalf(uint16_t(bits))), bits);
    EXPECT_EQ(fromHalf(0x3c00), 1.0f);
    EXPECT_EQ(toHalf(1e9f), 0x7bff);
    EXPECT_EQ(toHalf(INFINITY), 0x7bff);
    EXPECT_EQ(toHalf(NAN), 0);
    EXPECT_EQ(toHalf(-2.0f), 0xc000);
    EXPECT_EQ(toHalf(1.0f + 0x1p-11f), 0x3c00);  // a tie goes to the even neighbour
    EXPECT_EQ(toHalf(1.0f + 3 * 0x1p-11f), 0x3c02);
    EXPECT_EQ(toHalf(0x1p-25f), 0);
    EXPECT_EQ(toHalf(0x1.8p-25f), 1);
}

}  // namespace
}  // namespace rushlight
