// Reflection probes as data: which a frame shows, how they are weighed, what is refused, how a cube
// is captured.

#include "interop/reflection_probe.h"
#include "renderer/pipeline/capture_cube.h"
#include "renderer/renderer.h"
#include "renderer/resources/reflection_store.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rushlight {
namespace {

CameraMatrices cameraAt(const vec3& eye) {
    View view;
    view.viewFromWorld = glm::lookAt(eye, eye + vec3(0, 0, -1), vec3(0, 1, 0));
    view.verticalFov = 1.2f;
    return *makeCamera(view, 1.5f);
}

ReflectionProbe probeAt(const vec3& center, const vec3& halfSize, const vec3& blend = vec3(0)) {
    ReflectionProbe probe;
    probe.position = probe.center = center;
    probe.halfSize = halfSize;
    probe.blend = blend;
    return probe;
}

/// What the shader's loop gives each probe at a place relative to the eye, and last what is left.
std::vector<float> sharesAt(std::span<const vec4> records, const vec3& place) {
    std::vector<float> shares;
    float left = 1;
    for (size_t i = 0; i < size_t(records[0].x); ++i) {
        const vec4* r = &records[1 + i * RL_REFLECTION_TEXELS];
        const vec4 at(place, 1);
        const vec3 local(glm::dot(r[0], at), glm::dot(r[1], at), glm::dot(r[2], at));
        shares.push_back(left * interop::reflectionInfluence(local, vec3(r[4]), vec3(r[5])));
        left -= shares.back();
    }
    shares.push_back(left);
    return shares;
}

struct Recorded {
    std::vector<uint32_t> chosen;
    std::vector<vec4> records;
};
Recorded record(std::span<const ReflectionProbe> probes, const vec3& eye) {
    Recorded r;
    chooseReflectionProbes(probes, cameraAt(eye), r.chosen);
    const std::vector<uint32_t> layers(r.chosen.size(), 0);
    writeReflectionRecords(probes, r.chosen, layers, eye, r.records);
    return r;
}

TEST(ReflectionProbes, SharesAddUpToOneAndNeverJump) {
    const vec3 eye(3, 1, 9);
    std::vector<ReflectionProbe> probes = {probeAt({0, 0, -2}, {4, 3, 5}, {1, 0.5f, 2}),
                                           probeAt({1, 0, -3}, {1, 1, 1}, vec3(0.4f)),
                                           probeAt({3, 0, -2}, {2, 2, 2}, vec3(0.3f, 0, 0.3f))};
    probes[1].rotation = glm::angleAxis(0.7f, glm::normalize(vec3(1, 2, 0.5f)));
    const Recorded r = record(probes, eye);
    ASSERT_EQ(r.chosen.size(), 3u);
    Random random(3);
    for (int line = 0; line < 200; ++line) {
        const vec3 from = random.vector(-7, 7), to = random.vector(-7, 7);
        constexpr int kSteps = 4000;
        const float step = glm::length(to - from) / kSteps;
        std::vector<float> last;
        for (int i = 0; i <= kSteps; ++i) {
            const vec3 place = glm::mix(from, to, float(i) / kSteps);
            const std::vector<float> shares = sharesAt(r.records, place - eye);
            float sum = 0;
            for (const float share : shares) {
                ASSERT_GE(share, -1e-6f);
                sum += share;
            }
            ASSERT_NEAR(sum, 1, 1e-5f);
            // The steepest ramp there is rises over the skin; three of them may meet.
            for (size_t k = 0; k < last.size(); ++k)
                ASSERT_LE(std::abs(shares[k] - last[k]),
                          3 * step / interop::kReflectionSkin + 1e-5f);
            last = shares;
        }
    }
}

TEST(ReflectionProbes, TheSmallerBoxCountsAndWallsAreWithin) {
    const vec3 eye(0, 0, 9);
    const std::vector<ReflectionProbe> probes = {
        probeAt({0, 0, 0}, {4, 3, 5}), probeAt({1, 0, 0}, {1, 1, 1}, vec3(0.5f, 0, 0.5f))};
    const Recorded r = record(probes, eye);
    EXPECT_EQ(r.chosen, (std::vector<uint32_t>{1, 0}));
    EXPECT_NEAR(sharesAt(r.records, vec3(1, 0, 0) - eye)[0], 1, 1e-5f);
    EXPECT_NEAR(sharesAt(r.records, vec3(1, -1, 0) - eye)[0], 1, 1e-3f) << "on its floor";
    EXPECT_NEAR(sharesAt(r.records, vec3(0.27f, 0, 0) - eye)[0], 0.58f, 1e-3f) << "in its ramp";
    EXPECT_NEAR(sharesAt(r.records, vec3(0.27f, 0, 0) - eye)[1], 0.42f, 1e-3f) << "what it leaves";
    EXPECT_NEAR(sharesAt(r.records, vec3(-4, 0, 0) - eye)[1], 1, 1e-3f) << "on a wall";
    EXPECT_EQ(sharesAt(r.records, vec3(-4.03f, 0, 0) - eye)[1], 0) << "beyond it";
}

TEST(ReflectionProbes, RaysEndWhereTheBoxDoes) {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const vec3 place = random.vector(-1, 1), direction = random.vector(-1, 1);
        const vec3 hit = place + direction * interop::distanceToBox(place, direction);
        const vec3 reach = glm::abs(hit);
        EXPECT_NEAR(std::max(reach.x, std::max(reach.y, reach.z)), 1, 1e-4f);
    }
    EXPECT_NEAR(interop::distanceToBox(vec3(0.5f, 0, 0), vec3(0, -2, 0)), 0.5f, 1e-6f);
    EXPECT_EQ(interop::distanceToBox(vec3(1.5f, 0, 0), vec3(1, 0, 0)), 0) << "from beyond a side";
}

TEST(ReflectionProbes, AFrameShowsTheNearestInView) {
    std::vector<ReflectionProbe> probes;
    for (int i = 0; i < 40; ++i)
        probes.push_back(probeAt({0, 0, -2.0f * float(i + 1)}, vec3(0.5f)));
    probes[0].center.z = 50;  // behind the eye
    std::vector<uint32_t> chosen;
    chooseReflectionProbes(probes, cameraAt(vec3(0)), chosen);
    ASSERT_EQ(chosen.size(), kMaxShownReflectionProbes);
    for (uint32_t i = 0; i < chosen.size(); ++i) EXPECT_EQ(chosen[i], i + 1);
}

std::string refusal(const ReflectionProbe& probe) {
    const auto ok = checkReflectionProbes(std::span(&probe, 1));
    return ok ? "" : ok.error().text();
}

TEST(ReflectionProbes, WhatIsNoProbeIsRefusedInASentence) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const ReflectionProbe good = probeAt({0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(refusal(good), "");
    const auto with = [&](auto change) {
        ReflectionProbe probe = good;
        change(probe);
        return refusal(probe);
    };
    EXPECT_NE(with([](auto& p) { p.center.y = kNan; }).find("not finite"), std::string::npos);
    EXPECT_NE(with([](auto& p) { p.halfSize.z = 0; }).find("no size"), std::string::npos);
    EXPECT_NE(with([](auto& p) { p.halfSize.x = kNan; }).find("no size"), std::string::npos);
    EXPECT_NE(with([](auto& p) { p.blend.x = -1; }).find("blend"), std::string::npos);
    EXPECT_NE(with([](auto& p) {
                  p.rotation = {0, 0, 0, 0};
              }).find("quaternion"),
              std::string::npos);
    EXPECT_NE(with([](auto& p) { p.intensity = -1; }).find("intensity"), std::string::npos);
    EXPECT_NE(with([](auto& p) { p.position.x = 3; }).find("outside of its box"),
              std::string::npos);
    const std::vector<ReflectionProbe> many(257, good);
    const auto ok = checkReflectionProbes(many);
    ASSERT_FALSE(ok);
    EXPECT_NE(ok.error().text().find("257"), std::string::npos);
}

TEST(ReflectionProbes, ACaptureIsRefusedWhereItCannotBe) {
    auto renderer = Renderer::create({});
    ASSERT_TRUE(renderer);
    const auto refusal = [&](const vec3& position, const CaptureDesc& desc) {
        const auto made = (*renderer)->captureEnvironment({}, position, desc);
        return made ? std::string() : made.error().text();
    };
    EXPECT_EQ(refusal(vec3(0), {.size = 16}), "");
    EXPECT_NE(refusal(vec3(0), {.size = 0}).find("its size is 0"), std::string::npos);
    EXPECT_NE(refusal(vec3(0), {.size = 65536}).find("its size is 65536"), std::string::npos);
    EXPECT_NE(refusal(vec3(0), {.size = 100}).find("power of two"), std::string::npos);
    EXPECT_NE(refusal(vec3(std::numeric_limits<float>::infinity()), {}).find("not finite"),
              std::string::npos);
    EXPECT_NE(refusal(vec3(0), {.nearPlane = 0}).find("near plane"), std::string::npos);
    EXPECT_NE(refusal(vec3(0), {.nearPlane = 2, .farPlane = 1}).find("far plane"),
              std::string::npos);
    EXPECT_FALSE((*renderer)->recaptureEnvironment({}, {}, vec3(0), {.size = 16}));

    ReflectionProbe probe = probeAt(vec3(0), vec3(1));
    FrameInput input;
    input.lighting.reflectionProbes = std::span(&probe, 1);
    const auto drawn = (*renderer)->renderOffscreen(input, 16, 16, CaptureKind::hdr);
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().text().find("stale"), std::string::npos) << "it has no environment";
}

// A renderer of nothing but directions: every texel must come from where the cube says that it is.
TEST(ReflectionProbes, FacesLookTheWayThatCubesHaveThem) {
    const vec3 place(1, 2, 3);
    const auto render = [&](const FrameInput& face, uint32_t size,
                            CapturedImage& image) -> Result<void> {
        const auto camera = makeCamera(face.view, 1);
        if (!camera) return tl::unexpected(camera.error());
        EXPECT_EQ(camera->position, place);
        image.width = image.height = size;
        image.rgba32f.clear();
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const vec2 uv((float(x) + 0.5f) / float(size), 1 - (float(y) + 0.5f) / float(size));
                const vec3 d = glm::normalize(camera->relativePosition(uv, 1));
                for (const float c : {d.x + 1, d.y + 1, d.z + 1, 1.0f}) image.rgba32f.push_back(c);
            }
        return {};
    };
    const auto cube = captureCube({}, place, {.size = 16}, render);
    ASSERT_TRUE(cube);
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < 16; ++y)
            for (uint32_t x = 0; x < 16; ++x) {
                const vec3 d = glm::normalize(
                    cubeDirection(face, (float(x) + 0.5f) / 8 - 1, (float(y) + 0.5f) / 8 - 1));
                const vec4 t = cube->at(face, x, y);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(t[c], d[c] + 1, 1e-5f) << face << " " << x << " " << y;
            }
}

}  // namespace
}  // namespace rushlight
