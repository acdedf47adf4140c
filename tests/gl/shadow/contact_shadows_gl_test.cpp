// Contact shadows: what a coarse shadow map misses is there, and an open plane stays as it is.
#include "renderer/geometry/view_math.h"
#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rushlight {
namespace {

class ContactShadowsGl : public LitFrame {
protected:
    ContactShadowsGl() : LitFrame(320, 180) {}

    /// A floor of 40 metres, and shadow maps of 64 texels over it: over half a metre each.
    void SetUp() override {
        LitFrame::SetUp();
        MaterialDesc white;
        white.metallic = 0;
        white_ = *renderer->createMaterial(white);
        addBox({0, -1, 0}, {20, 1, 20}, white_);
        sun.illuminance = vec3(3);
        sun.direction = glm::normalize(vec3(1, -1, 0));
        input.lighting.directional = {&sun, 1};
        input.settings.shadowResolution = 64;
        input.settings.shadowCascades = 1;
        look({0, 1, 1.5f}, {0, 0, 0});
    }
    void look(const vec3& eye, const vec3& target) {
        input.view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
    }
    CapturedImage picture(bool contact) {
        input.settings.contactShadows = contact ? of : ContactShadows::off;
        return render();
    }
    /// A post of 2 cm, 20 cm high.
    void addPost() { addBox({0, 0.1f, 0}, {0.01f, 0.1f, 0.01f}, white_); }
    /// Of the pixel that shows a point of the floor: what of its light contact shadows leave.
    float leftAt(const CapturedImage& without, const CapturedImage& with, float x, float z) const {
        const vec4 clip = makeCamera(input.view, float(width) / float(height))->clipFromWorld *
                          vec4(x, 0, z, 1);
        const auto column = uint32_t((clip.x / clip.w * 0.5f + 0.5f) * float(width));
        const auto row = uint32_t((0.5f - clip.y / clip.w * 0.5f) * float(height));
        return pixelOf(with, column, row).x / pixelOf(without, column, row).x;
    }
    /// Square metres of the floor that lie in contact shadow, in the middle of the picture.
    double shadowedArea(const CapturedImage& without, const CapturedImage& with) const {
        const CameraMatrices camera = *makeCamera(input.view, float(width) / float(height));
        const auto floorAt = [&](float x, float y) {
            const vec3 ray = camera.relativePosition({x / float(width), 1 - y / float(height)}, 1);
            return camera.position + ray * (-camera.position.y / ray.y);
        };
        double area = 0;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const float before = pixelOf(without, x, y).x,
                            share = 1 - pixelOf(with, x, y).x / before;
                if (!(share > 0)) continue;
                const vec3 p = floorAt(float(x), float(y));
                const vec3 a = floorAt(float(x) + 1, float(y)) - p,
                           b = floorAt(float(x), float(y) + 1) - p;
                area += double(share * glm::length(glm::cross(a, b)));
            }
        return area;
    }

    DirectionalLight sun;
    ContactShadows of = ContactShadows::sun;
    MaterialHandle white_;
};

TEST_F(ContactShadowsGl, AThinPostShadowsWhatTheMapMisses) {
    addPost();
    const CapturedImage without = picture(false), with = picture(true);
    for (const float x : {0.03f, 0.06f, 0.1f}) {
        EXPECT_LT(leftAt(without, with, x, 0), 0.2f) << x;
        EXPECT_EQ(leftAt(without, with, -x, 0), 1) << x;
        EXPECT_EQ(leftAt(without, with, x, 0.08f), 1) << x;
        EXPECT_EQ(leftAt(without, with, x, -0.08f), 1) << x;
    }
    EXPECT_EQ(leftAt(without, with, 0.3f, 0), 1);  // the post ends at 20 cm
    input.settings.contactShadowLength = 0.05f;    // shorter than the way to the post
    EXPECT_EQ(leftAt(without, picture(true), 0.1f, 0), 1);
}

TEST_F(ContactShadowsGl, AnOrthographicViewHasThemToo) {
    addPost();
    input.view.perspective = false;
    input.view.orthoHalfHeight = 0.6f;
    input.view.farPlane = 40;
    const CapturedImage without = picture(false), with = picture(true);
    EXPECT_LT(leftAt(without, with, 0.06f, 0), 0.2f);
    EXPECT_EQ(leftAt(without, with, -0.06f, 0), 1);
}

TEST_F(ContactShadowsGl, AnOpenPlaneKeepsItsLightAtEveryAngle) {
    for (const bool perspective : {true, false})
        for (const float eye : {0.3f, 1.5f, 6.0f})
            for (const float elevation : {0.02f, 0.05f, 0.2f, 0.8f, 1.5f})
                for (const float turn : {0.0f, 1.0f, 2.2f, 3.1416f, 4.5f}) {
                    input.view.perspective = perspective;
                    input.view.orthoHalfHeight = 3;
                    input.view.farPlane = perspective ? 0.0f : 100.0f;
                    look({0, eye, 6}, {0, 0, 0});
                    sun.direction = -vec3(std::cos(elevation) * std::cos(turn), std::sin(elevation),
                                          std::cos(elevation) * std::sin(turn));
                    const CapturedImage without = picture(false), with = picture(true);
                    uint32_t changed = 0;
                    for (size_t i = 0; i < with.rgba32f.size(); i += 4)
                        changed += with.rgba32f[i] != without.rgba32f[i];
                    EXPECT_EQ(changed, 0u)
                        << perspective << " " << eye << " " << elevation << " " << turn;
                }
}

// No history and no frame number: a still picture stays the same, and a moving one keeps its
// shadow.
TEST_F(ContactShadowsGl, FramesAgree) {
    addPost();
    EXPECT_EQ(picture(true).rgba32f, picture(true).rgba32f);
    double least = 1e9, most = 0;
    for (int i = 0; i < 8; ++i) {
        look({0.02f * float(i), 1 + 0.01f * float(i), 1.5f}, {0.01f * float(i), 0, 0});
        const CapturedImage without = picture(false);
        const double area = shadowedArea(without, picture(true));
        least = std::min(least, area);
        most = std::max(most, area);
    }
    EXPECT_GT(least, 0.001);
    EXPECT_LT(most / least, 1.15) << least << " to " << most;
}

/// A lamp 2 m up to the side, in faces of 64 texels: at the post 6 cm each.
class LampContactShadowsGl : public ContactShadowsGl {
protected:
    void SetUp() override {
        ContactShadowsGl::SetUp();
        lamp.position = {-2, 2, 0};
        lamp.intensity = vec3(30);
        lamp.castsShadow = true;
        input.lighting.directional = {};
        input.lighting.punctual = {&lamp, 1};
        input.settings.lightShadows = true;
        input.settings.shadowTileSize = 64;
        of = ContactShadows::lights;
    }
    PunctualLight lamp;
};

TEST_F(LampContactShadowsGl, AThinPostShadowsWhatTheMapMisses) {
    addPost();
    for (const bool perspective : {true, false}) {
        input.view.perspective = perspective;
        input.view.orthoHalfHeight = 0.6f;
        input.view.farPlane = perspective ? 0.0f : 40.0f;
        const CapturedImage without = picture(false), with = picture(true);
        for (const float x : {0.03f, 0.06f, 0.1f}) {
            EXPECT_LT(leftAt(without, with, x, 0), 0.2f) << x;
            EXPECT_EQ(leftAt(without, with, -x, 0), 1) << x;
            EXPECT_EQ(leftAt(without, with, x, 0.08f), 1) << x;
        }
        EXPECT_EQ(leftAt(without, with, 0.3f, 0), 1);
    }
}

TEST_F(LampContactShadowsGl, AnOpenPlaneKeepsItsLight) {
    for (const float up : {0.05f, 0.3f, 2.0f})
        for (const float turn : {0.0f, 1.0f, 2.2f, 3.1416f, 4.5f}) {
            look({0, 1.5f, 6}, {0, 0, 0});
            lamp.position = {2 * std::cos(turn), up, 2 * std::sin(turn)};
            EXPECT_EQ(picture(true).rgba32f, picture(false).rgba32f) << up << " " << turn;
        }
}

TEST_F(LampContactShadowsGl, AreOfLightsThatHaveAShadow) {
    addPost();
    const CapturedImage with = picture(true);
    of = ContactShadows::sun;
    const CapturedImage without = picture(false);
    EXPECT_EQ(picture(true).rgba32f, without.rgba32f);
    EXPECT_NE(with.rgba32f, without.rgba32f);
    of = ContactShadows::lights;
    lamp.castsShadow = false;
    EXPECT_EQ(picture(true).rgba32f, picture(false).rgba32f);
}

TEST_F(ContactShadowsGl, WithoutASunThatCastsNothingChanges) {
    addPost();
    sun.castsShadow = false;
    EXPECT_EQ(picture(true).rgba32f, picture(false).rgba32f);
    input.settings.contactShadows = ContactShadows::sun;
    for (const float length : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        input.settings.contactShadowLength = length;
        EXPECT_FALSE(renderer->renderOffscreen(input, width, height, CaptureKind::hdr));
    }
}

}  // namespace
}  // namespace rushlight
