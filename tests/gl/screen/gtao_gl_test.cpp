// Ambient occlusion of the screen against rays cast through the same scene.

#include "renderer/geometry/vertex_packing.h"
#include "renderer/lighting/environment/sampling.h"
#include "tests/support/scenes/screen_frames.h"

#include <cstdlib>

namespace rushlight {
namespace {

constexpr float kRadius = 1;
// As GtaoPass aims to weigh an occluder by its distance: fully up to 0.4 of the radius, then less
// with the square.
float weightAt(float distance) {
    const float share = distance * distance / (kRadius * kRadius);
    return std::clamp((1 - share) / (1 - 0.16f), 0.0f, 1.0f);
}

// Visibility with the light that surfaces of one albedo send on: Jimenez et al. 2016, section 6.
float passedOnTo(float v, float albedo) {
    const float a = 2.0404f * albedo - 0.3324f, b = -4.7951f * albedo + 0.6417f;
    return std::max(v, ((v * a + b) * v + 2.7552f * albedo + 0.6903f) * v);
}

class GtaoGl : public ScreenFrames {
protected:
    void SetUp() override {
        ScreenFrames::SetUp();
        input.settings.debugView = DebugView::ambientOcclusion;
        input.settings.ambientOcclusion = AmbientOcclusion::high;
        input.settings.ambientOcclusionRadius = kRadius;
        input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
    }
    struct Open {
        float share = 0;  ///< of the hemisphere, by the cosine
        vec3 mean{0};     ///< unit
    };
    Open openness(const Seen& seen) const {
        constexpr uint32_t kRays = 400;
        const vec3 tangent = perpendicular(seen.normal);
        const vec3 bitangent = glm::cross(seen.normal, tangent);
        Open open;
        for (uint32_t i = 0; i < kRays; ++i) {
            const vec2 u = hammersley(i, kRays);
            const float r = std::sqrt(u.x), a = 2 * kPi * u.y;
            const vec3 direction = tangent * (r * std::cos(a)) + bitangent * (r * std::sin(a)) +
                                   seen.normal * std::sqrt(1 - u.x);
            const auto hit = scene->cast(seen.position + seen.normal * 1e-4f, direction);
            const float visible = hit ? 1 - weightAt(hit->distance) : 1;
            open.share += visible / float(kRays);
            open.mean += direction * visible;
        }
        open.mean = glm::normalize(open.mean);
        return open;
    }
    static float at(const CapturedImage& image, uint32_t x, uint32_t y) {
        return float(image.rgba8[(size_t(y) * kWidth + x) * 4]) / 255;
    }
    struct Errors {
        float mean = 0, bias = 0, worst = 0;  ///< worst: the 99th of a hundred
        float darkest = 1;  ///< of the truth, to know that something was there to be found
    };
    /// Over a grid of the pixels of which all neighbours see the same object.
    Errors compareWithRays() {
        const CapturedImage image = render(CaptureKind::display);
        const CameraMatrices view = camera();
        std::vector<float> errors;
        Errors result;
        for (uint32_t y = 9; y < kHeight - 9; y += 5)
            for (uint32_t x = 9; x < kWidth - 9; x += 5) {
                const auto seen = seenAt(view, x, y);
                if (!seen || !isInside(view, x, y, *seen)) continue;
                const float expected = openness(*seen).share, error = at(image, x, y) - expected;
                result.bias += error;
                result.mean += std::abs(error);
                result.darkest = std::min(result.darkest, expected);
                errors.push_back(std::abs(error));
            }
        EXPECT_GT(errors.size(), 500u);
        result.bias /= float(errors.size());
        result.mean /= float(errors.size());
        std::ranges::sort(errors);
        result.worst = errors[errors.size() * 99 / 100];
        std::printf("mean error %.4f, bias %+.4f, 99 %% are within %.3f, darkest truth %.3f\n",
                    result.mean, result.bias, result.worst, result.darkest);
        return result;
    }
    bool isInside(const CameraMatrices& view, uint32_t x, uint32_t y, const Seen& seen) const {
        for (int dy : {-2, 2})
            for (int dx : {-2, 2}) {
                const auto other = seenAt(view, uint32_t(int(x) + dx), uint32_t(int(y) + dy));
                if (!other || other->object != seen.object ||
                    glm::dot(other->normal, seen.normal) < 0.9f)
                    return false;
            }
        return true;
    }
};

TEST_F(GtaoGl, ACornerIsAsDarkAsRaysSay) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    scene->addBox({-9, 0, -9}, {9, 9, -1.5f});
    look({0, 2, 2.5f}, {0, 0.4f, -1.5f});
    const Errors errors = compareWithRays();
    EXPECT_LT(errors.darkest, 0.65f);
    EXPECT_LT(errors.mean, 0.02f);
    EXPECT_LT(std::abs(errors.bias), 0.015f);
    EXPECT_LT(errors.worst, 0.08f);
}

TEST_F(GtaoGl, ABoxOnAPlaneIsAsDarkAsRaysSay) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    scene->addBox({-0.5f, 0, -0.5f}, {0.5f, 0.8f, 0.5f});
    look({1.4f, 2.2f, 1.8f}, {0, 0.2f, 0});
    const Errors errors = compareWithRays();
    EXPECT_LT(errors.darkest, 0.65f);
    EXPECT_LT(errors.mean, 0.03f);
    EXPECT_LT(errors.worst, 0.15f);
}

TEST_F(GtaoGl, ABallOnAPlaneIsAsDarkAsRaysSay) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    scene->addBall({0, 0.6f, 0}, 0.6f);
    look({1.2f, 2.4f, 1.6f}, {0, 0.3f, 0});
    const Errors errors = compareWithRays();
    EXPECT_LT(errors.darkest, 0.5f);
    EXPECT_LT(errors.mean, 0.04f);
    EXPECT_LT(errors.worst, 0.2f);
}

TEST_F(GtaoGl, AnOrthographicViewFindsTheSame) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    scene->addBox({-9, 0, -9}, {9, 9, -1.5f});
    input.view.perspective = false;
    input.view.orthoHalfHeight = 1.5f;
    input.view.farPlane = 30;
    look({0, 4, 4}, {0, 0.5f, -1.5f});
    const Errors errors = compareWithRays();
    EXPECT_LT(errors.darkest, 0.6f);
    EXPECT_LT(errors.mean, 0.02f);
    EXPECT_LT(errors.worst, 0.08f);
}

TEST_F(GtaoGl, APlaneDoesNotHideItselfHoweverItIsSeen) {
    scene->addBox({-500, -1, -500}, {500, 0, 500});
    for (const auto quality :
         {AmbientOcclusion::low, AmbientOcclusion::medium, AmbientOcclusion::high})
        for (const float degrees : {1.0f, 4.0f, 12.0f, 45.0f, 89.9f}) {
            SCOPED_TRACE(degrees);
            input.settings.ambientOcclusion = quality;
            const float angle = glm::radians(degrees);
            look({0, 1.5f, 0}, {0.3f, 1.5f - std::sin(angle), -std::cos(angle)});
            const CapturedImage image = render(CaptureKind::display);
            const CameraMatrices view = camera();
            float darkest = 1;
            for (uint32_t y = 0; y < kHeight; ++y)
                for (uint32_t x = 0; x < kWidth; ++x)
                    if (const auto seen = seenAt(view, x, y);
                        seen && glm::length(seen->position) < 300)
                        darkest = std::min(darkest, at(image, x, y));
            EXPECT_GE(darkest, 0.99f);
        }
}

TEST_F(GtaoGl, WhatIsFarBeforeAWallCastsNoHaloOnIt) {
    scene->addBox({-30, -30, -9}, {30, 30, -8});
    scene->addBox({-0.6f, -0.6f, -4.1f}, {0.6f, 0.6f, -4});  // four metres before it: the radius is
                                                             // one
    scene->addBox({1.2f, -1.5f, -4.1f}, {1.26f, 1.5f, -4});  // a pole
    look({0, 0, 0}, {0, 0, -1});
    const CapturedImage image = render(CaptureKind::display);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x)
            if (const auto seen = seenAt(camera(), x, y); seen && seen->object == 0) {
                ASSERT_GE(at(image, x, y), 0.98f) << "at " << x << ", " << y;
            }
}

// The bent normals have no picture: they show under a sky that is white above and black below.
TEST_F(GtaoGl, LightComesFromWhereItIsOpen) {
    constexpr float kAlbedo = 0.6f;
    MaterialDesc matt;
    matt.baseColor = vec4(vec3(kAlbedo), 1);
    matt.metallic = 0;
    const MaterialHandle material = *renderer->createMaterial(matt);
    scene->addBox({-9, -1, -9}, {9, 0, 9}, material);
    scene->addBox({-9, 0, -9}, {9, 9, -1}, material);
    input.settings.debugView = DebugView::none;
    look({0, 2.5f, 2}, {0, 0.2f, -0.6f});
    const auto diffuse = [&](AmbientOcclusion quality) {
        input.settings.ambientOcclusion = quality;
        input.lighting.ambientSky = vec3(1);
        input.lighting.ambientGround = vec3(0);
        return render(CaptureKind::hdr);
    };
    const CapturedImage open = diffuse(AmbientOcclusion::off);
    const CapturedImage hidden = diffuse(AmbientOcclusion::high);
    const CameraMatrices view = camera();
    float error = 0, bending = 0;
    uint32_t compared = 0;
    for (uint32_t y = 0; y < kHeight; y += 4)
        for (uint32_t x = 20; x < kWidth - 20; x += 4) {
            const auto seen = seenAt(view, x, y);
            if (!seen || seen->object != 0 || seen->position.z > -0.7f ||
                !isInside(view, x, y, *seen))
                continue;
            const Open expected = openness(*seen);
            const size_t i = (size_t(y) * kWidth + x) * 4;
            const float share = hidden.rgba32f[i] / open.rgba32f[i];
            const float passedOn = passedOnTo(expected.share, kAlbedo);
            const float wanted = passedOn * (expected.mean.y * 0.5f + 0.5f);
            error += std::abs(share - wanted);
            bending += passedOn - wanted;
            ++compared;
        }
    ASSERT_GT(compared, 50u);
    std::printf("mean error %.4f; without bent normals %.4f more\n", error / float(compared),
                bending / float(compared));
    EXPECT_GT(bending / float(compared), 0.03f);
    EXPECT_LT(error / float(compared), 0.015f);
}

TEST_F(GtaoGl, TheSameBytesEveryTimeForAnyThreads) {
    std::vector<uint8_t> first;
    for (const uint32_t threads : {1u, 2u, 8u}) {
        ThreadJobs jobs(threads);
        open(&jobs);
        scene->addBox({-9, -1, -9}, {9, 0, 9});
        scene->addBall({0, 0.6f, 0}, 0.6f);
        look({1.2f, 2.4f, 1.6f}, {0, 0.3f, 0});
        for (int repeat = 0; repeat < 2; ++repeat) {
            const std::vector<uint8_t> bytes = render(CaptureKind::display).rgba8;
            if (first.empty()) first = bytes;
            EXPECT_EQ(bytes, first);
        }
        renderer.reset();
    }
}

// One frame after the other of a camera that walks and turns: a place keeps its shade.
TEST_F(GtaoGl, AMovingCameraDoesNotMakeShadesSwim) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    scene->addBox({-9, 0, -9}, {9, 9, -1.5f});
    scene->addBox({-0.5f, 0, -0.7f}, {0.5f, 0.8f, 0.3f});
    input.settings.ambientOcclusion = AmbientOcclusion::medium;
    std::vector<float> changes;
    CapturedImage before;
    CameraMatrices viewBefore;
    for (int frame = 0; frame < 8; ++frame) {
        const float step = float(frame) * 0.013f;
        look({0.8f + step, 1.9f, 2.4f - 0.5f * step}, {0.1f + 2 * step, 0.4f, -1});
        const CapturedImage image = render(CaptureKind::display);
        const CameraMatrices view = camera();
        for (uint32_t y = 8; frame > 0 && y < kHeight - 8; y += 3)
            for (uint32_t x = 8; x < kWidth - 8; x += 3) {
                const auto seen = seenAt(view, x, y);
                if (!seen || !isInside(view, x, y, *seen)) continue;
                const vec4 clip = viewBefore.clipFromWorld * vec4(seen->position, 1);
                const vec2 old = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(kWidth, kHeight);
                const int ox = int(old.x), oy = int(float(kHeight) - old.y);
                if (ox < 8 || oy < 8 || ox >= int(kWidth) - 8 || oy >= int(kHeight) - 8) continue;
                const auto same = seenAt(viewBefore, uint32_t(ox), uint32_t(oy));
                if (!same || !isInside(viewBefore, uint32_t(ox), uint32_t(oy), *same) ||
                    same->object != seen->object || glm::dot(same->normal, seen->normal) < 0.9f)
                    continue;
                changes.push_back(
                    std::abs(at(image, x, y) - at(before, uint32_t(ox), uint32_t(oy))));
            }
        before = image;
        viewBefore = view;
    }
    ASSERT_GT(changes.size(), 5000u);
    std::ranges::sort(changes);
    float mean = 0;
    for (const float change : changes) mean += change;
    mean /= float(changes.size());
    const float worst = changes[changes.size() * 99 / 100];
    std::printf("change from frame to frame: mean %.4f, 99 %% are within %.3f\n", mean, worst);
    EXPECT_LT(mean, 0.008f);
    EXPECT_LT(worst, 0.05f);
}

TEST_F(GtaoGl, AFrameWithoutAmbientLightHasNoPassOfIt) {
    scene->addBox({-9, -1, -9}, {9, 0, 9});
    look({0, 1, 2}, {0, 0, 0});
    input.settings.debugView = DebugView::none;
    render(CaptureKind::display);
    EXPECT_TRUE(hasPass("gtao") && hasPass("gtao.denoise"));
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0);
    render(CaptureKind::display);
    EXPECT_FALSE(hasPass("gtao") || hasPass("gtao.denoise"));
    input.lighting.ambientSky = vec3(1);
    input.settings.ambientOcclusion = AmbientOcclusion::off;
    render(CaptureKind::display);
    EXPECT_FALSE(hasPass("gtao"));
}

TEST_F(GtaoGl, ARadiusThatIsNoneIsRefused) {
    for (const float radius : {0.0f, -1.0f, NAN, INFINITY}) {
        input.settings.ambientOcclusionRadius = radius;
        const auto ticket = renderer->renderOffscreen(input, 8, 8, CaptureKind::display);
        ASSERT_FALSE(ticket);
        EXPECT_NE(ticket.error().text().find("ambientOcclusionRadius"), std::string::npos);
    }
}

}  // namespace
}  // namespace rushlight
