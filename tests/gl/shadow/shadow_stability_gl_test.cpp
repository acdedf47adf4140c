// Shadows of a scene that stands still do not swim while the camera moves or turns.

#include "tests/support/scenes/shadow_truth.h"

#include "renderer/geometry/view_math.h"
#include "tests/support/gl/offscreen_renderer.h"
#include "tests/support/scenes/torture_scene.h"

#include <gtest/gtest.h>

#include <iostream>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 480, kHeight = 270;

/// How the light on surfaces differs between two frames where both see them, and neither sees an
/// edge of theirs.
struct Change {
    uint64_t pixels = 0, jumps = 0;  ///< by more than a half
    double sum = 0;
};

class ShadowStabilityGl : public OffscreenRenderer {
protected:
    void SetUp() override {
        OffscreenRenderer::SetUp();
        if (IsSkipped()) return;
        rays = RayScene::create(*jobs).value();
        scene = std::make_unique<TortureScene>(*renderer, *rays);
        ASSERT_TRUE(rays->build(scene->instances));
    }
    static CameraMatrices cameraOf(const FrameInput& input) {
        return makeCamera(input.view, float(kWidth) / float(kHeight)).value();
    }
    bool hitAt(const CameraMatrices& camera, float x, float y, RayHit& hit) const {
        const vec2 uv((x + 0.5f) / float(kWidth), 1 - (y + 0.5f) / float(kHeight));
        return rays->intersect({camera.position, glm::normalize(camera.relativePosition(uv, 1)), 0},
                               hit);
    }
    /// The place in the other picture, in pixels from the top left.
    static vec2 project(const CameraMatrices& camera, const vec3& p) {
        const vec4 clip = camera.clipFromWorld * vec4(p, 1);
        return {(clip.x / clip.w * 0.5f + 0.5f) * float(kWidth) - 0.5f,
                (0.5f - clip.y / clip.w * 0.5f) * float(kHeight) - 0.5f};
    }
    Change compare(const CameraMatrices& a, const std::vector<float>& termA,
                   const CameraMatrices& b, const std::vector<float>& termB) const {
        Change change;
        for (uint32_t y = 1; y + 1 < kHeight; ++y)
            for (uint32_t x = 1; x + 1 < kWidth; ++x) {
                const float now = termA[y * kWidth + x];
                RayHit hit;
                if (now < 0 || !hitAt(a, float(x), float(y), hit)) continue;
                const vec2 at = project(b, hit.position);
                const int left = int(std::floor(at.x)), top = int(std::floor(at.y));
                if (left < 0 || top < 0 || left + 1 >= int(kWidth) || top + 1 >= int(kHeight))
                    continue;
                float corners[4];
                bool same = true;
                for (int c = 0; c < 4 && same; ++c) {
                    const int cx = left + c % 2, cy = top + c / 2;
                    corners[c] = termB[size_t(cy) * kWidth + size_t(cx)];
                    RayHit there;
                    same = corners[c] >= 0 && hitAt(b, float(cx), float(cy), there) &&
                           there.instance == hit.instance &&
                           glm::dot(there.geometricNormal, hit.geometricNormal) > 0.95f;
                }
                if (!same) continue;
                const vec2 f = at - vec2(float(left), float(top));
                const float then = glm::mix(glm::mix(corners[0], corners[1], f.x),
                                            glm::mix(corners[2], corners[3], f.x), f.y);
                ++change.pixels;
                change.sum += std::abs(then - now);
                change.jumps += std::abs(then - now) > 0.5f;
            }
        return change;
    }
    /// Along the way, between each frame and the next.
    Change along(const LightChoice& light, vec3 (*eyeAt)(int), vec3 (*aheadAt)(int)) {
        ShadowTruth truth(*renderer, *rays);
        truth.width = kWidth, truth.height = kHeight;
        Change all;
        std::vector<float> before;
        CameraMatrices cameraBefore;
        for (int i = 0; i < 8; ++i) {
            FrameInput input = scene->frame(eyeAt(i), eyeAt(i) + aheadAt(i));
            input.settings.lightShadows = true;
            // Texels larger than pixels: what changes then is the shadow, not how pixels sample it.
            input.settings.shadowResolution = 512;
            input.settings.shadowTileSize = 256;
            const CameraMatrices camera = cameraOf(input);
            std::vector<float> now = truth.term(input, light);
            if (i > 0) {
                const Change step = compare(camera, now, cameraBefore, before);
                all.pixels += step.pixels, all.jumps += step.jumps, all.sum += step.sum;
            }
            before = std::move(now);
            cameraBefore = camera;
        }
        return all;
    }
    void expectCalm(const char* name, const Change& change) {
        const double mean = change.sum / double(change.pixels),
                     jumps = double(change.jumps) / double(change.pixels);
        std::cout << name << ": mean change " << mean << ", by more than a half " << jumps * 100
                  << " % of " << change.pixels << std::endl;
        EXPECT_GT(change.pixels, 100'000u);
        EXPECT_LT(mean, 0.006) << name;
        EXPECT_LT(jumps, 0.0005) << name;
    }

    std::unique_ptr<RayScene> rays;
    std::unique_ptr<TortureScene> scene;
};

vec3 standing(int) { return {-7, 3, 7}; }
vec3 walking(int i) { return vec3(-7, 3, 7) + float(i) * vec3(0.05f, 0.01f, -0.03f); }
vec3 ahead(int) { return {7, -2.5f, -7}; }
vec3 turning(int i) {
    return {7 * std::cos(0.01f * float(i)), -2.5f, -7 * std::cos(0.02f * float(i))};
}

TEST_F(ShadowStabilityGl, TheSunsWhileTheCameraMovesOrTurns) {
    expectCalm("sun, moving", along({true, 0}, walking, ahead));
    expectCalm("sun, turning", along({true, 0}, standing, turning));
}

TEST_F(ShadowStabilityGl, ALampsWhileTheCameraMovesOrTurns) {
    expectCalm("point, moving", along({false, 0}, walking, ahead));
    expectCalm("spot, turning", along({false, 1}, standing, turning));
}

}  // namespace
}  // namespace rushlight
