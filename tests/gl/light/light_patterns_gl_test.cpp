// Profiles and cookies of lights on a plane, against the measured candela and the picture itself.
#include "tests/support/scenes/lit_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rushlight {
namespace {

/// A web with no symmetry, 5 by 15 degrees.
struct Web {
    std::vector<float> vertical, horizontal, candela;
    float largest = 0;

    explicit Web(float lastVertical = 180) {
        for (float v = 0; v <= lastVertical; v += 5) vertical.push_back(v);
        for (float h = 0; h <= 360; h += 15) horizontal.push_back(h);
        for (const float h : horizontal)
            for (const float v : vertical) {
                const float turn = h * kPi / 180, fall = v * kPi / 180;
                candela.push_back(700 + 300 * std::cos(fall) +
                                  std::sin(fall) *
                                      (250 * std::cos(turn) + 120 * std::sin(2 * turn)));
                largest = std::max(largest, candela.back());
            }
    }
    LightProfileDesc desc() const { return {"web", vertical, horizontal, candela}; }
    /// In degrees; bilinear.
    float at(float v, float h) const {
        const size_t columns = vertical.size();
        const size_t x = std::min(size_t(v / 5), columns - 2),
                     y = std::min<size_t>(size_t(h / 15), 23);
        const float fx = v / 5 - float(x), fy = h / 15 - float(y);
        const auto value = [&](size_t i, size_t j) { return candela[(y + j) * columns + x + i]; };
        return std::lerp(std::lerp(value(0, 0), value(1, 0), fx),
                         std::lerp(value(0, 1), value(1, 1), fx), fy);
    }
};

class LightPatternsGl : public LitPlane {
protected:
    /// Light of 5 candela shines down; seen from above its right is the picture's right, its up the
    /// picture's up.
    void SetUp() override {
        LitPlane::SetUp();
        light.position = {0.2f, 1.2f, -0.3f};
        light.intensity = vec3(5);
        input.lighting.punctual = {&light, 1};
    }
    /// Red, green, blue and black quarters, in reading order.
    LightCookieHandle quarters() {
        std::vector<uint8_t> pixels(64 * 64 * 4, 255);
        for (uint32_t y = 0; y < 64; ++y)
            for (uint32_t x = 0; x < 64; ++x)
                for (uint32_t c = 0; c < 3; ++c)
                    pixels[(y * 64 + x) * 4 + c] = c == (y / 32) * 2 + x / 32 ? 255 : 0;
        return *renderer->createLightCookie({"quarters", {"quarters", 64, 64, true, pixels}});
    }
    /// Irradiance at a place as a share of what the light without its cookie gives there.
    vec3 share(const std::vector<vec3>& lit, float x, float z) const {
        const auto pixel = [](float p) { return size_t((p / kHalf + 1) / 2 * kSide); };
        const vec3 to = light.position - vec3(x, 0, z);
        const float d = glm::length(to);
        return lit[pixel(z) * kSide + pixel(x)] / (light.intensity.x * to.y / (d * d * d));
    }
    static void expectColor(const vec3& got, const vec3& want, const char* where) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 0.06f) << where;
    }

    PunctualLight light;
};

TEST_F(LightPatternsGl, AProfileIsItsCandelaOverDistanceSquared) {
    for (const float last : {180.0f, 90.0f}) {
        const Web web(last);
        light.profile = *renderer->createLightProfile(web.desc());
        light.direction = glm::normalize(vec3(0.2f, -1, 0.1f));
        light.up = glm::normalize(vec3(0.4f, 0.3f, -1));
        const vec3 right = glm::normalize(glm::cross(light.direction, light.up));
        const vec3 up = glm::cross(right, light.direction);
        expectIrradiance(
            [&](vec3 p) {
                const vec3 to = light.position - p;
                const float d2 = glm::dot(to, to);
                const vec3 d = -to / std::sqrt(d2);
                const float vertical = std::acos(glm::dot(d, light.direction)) * 180 / kPi;
                float horizontal = std::atan2(glm::dot(d, up), glm::dot(d, right)) * 180 / kPi;
                if (horizontal < 0) horizontal += 360;
                if (vertical > last - 1) return -1.0f;
                return 5 * web.at(vertical, horizontal) / web.largest / d2 * -d.y;
            },
            0.05f);
        renderer->destroy(light.profile);
    }
}

TEST_F(LightPatternsGl, BeyondItsAnglesAProfileIsDark) {
    const Web web(90);
    light.profile = *renderer->createLightProfile(web.desc());
    light.direction = {0, 1, 0};
    light.up = {0, 0, -1};
    for (const vec3& e : irradiance()) ASSERT_EQ(e.x, 0);
}

TEST_F(LightPatternsGl, ASpotThrowsItsCookieUprightAndNotMirrored) {
    light.cookie = quarters();
    light.position = {0, 2, 0};
    light.innerConeAngle = 0.69f;
    light.outerConeAngle = 0.7f;
    const std::vector<vec3> lit = irradiance();
    expectColor(share(lit, -0.5f, -0.5f), {1, 0, 0}, "far left");
    expectColor(share(lit, 0.5f, -0.5f), {0, 1, 0}, "far right");
    expectColor(share(lit, -0.5f, 0.5f), {0, 0, 1}, "near left");
    expectColor(share(lit, 0.5f, 0.5f), {0, 0, 0}, "near right");
    light.up = {1, 0, 0};  // the picture's upper edge now lies to the right
    const std::vector<vec3> rolled = irradiance();
    expectColor(share(rolled, 0.5f, -0.5f), {1, 0, 0}, "far right");
    expectColor(share(rolled, 0.5f, 0.5f), {0, 1, 0}, "near right");
    expectColor(share(rolled, -0.5f, -0.5f), {0, 0, 1}, "far left");
}

TEST_F(LightPatternsGl, ACookieTouchesTheConesCircle) {
    // White within a twentieth of the edge, else black: a frame around the cone.
    std::vector<uint8_t> pixels(200 * 200 * 4, 0);
    for (uint32_t y = 0; y < 200; ++y)
        for (uint32_t x = 0; x < 200; ++x)
            if (std::min(x, 199 - x) < 10)
                for (uint32_t c = 0; c < 3; ++c) pixels[(y * 200 + x) * 4 + c] = 255;
    light.cookie = *renderer->createLightCookie({"frame", {"frame", 200, 200, false, pixels}});
    light.position = {0, 2, 0};
    light.outerConeAngle = std::atan(0.75f);  // a circle of 1.5 m
    light.innerConeAngle = light.outerConeAngle - 0.001f;
    const std::vector<vec3> lit = irradiance();
    EXPECT_GT(share(lit, 1.43f, 0).x, 0.9f);
    EXPECT_LT(share(lit, 1.28f, 0).x, 0.1f);
    EXPECT_LT(share(lit, 1.55f, 0).x, 0.1f);
}

TEST_F(LightPatternsGl, AroundAPointLightTheCookieIsEquirectangular) {
    light.cookie = quarters();
    light.position = {0, 1, 0};
    const std::vector<vec3> lit = irradiance();
    expectColor(share(lit, -0.5f, -0.5f), {1, 0, 0}, "far left");
    expectColor(share(lit, 0.5f, -0.5f), {0, 1, 0}, "far right");
    expectColor(share(lit, -0.5f, 0.5f), {0, 0, 1}, "near left");
    expectColor(share(lit, 0.5f, 0.5f), {0, 0, 0}, "near right");
    light.direction = {0, 1, 0};  // its middle is overhead: below is the edge, left and right
                                  // change sides
    const std::vector<vec3> behind = irradiance();
    expectColor(share(behind, 0.5f, -0.5f), {1, 0, 0}, "behind, far right");
    expectColor(share(behind, -0.5f, -0.5f), {0, 1, 0}, "behind, far left");
}

TEST_F(LightPatternsGl, BlendedSurfacesAndFogAreLitByThem) {
    light.cookie = quarters();
    light.position = {0, 2, 0};
    light.outerConeAngle = 0.7f;
    MaterialDesc glass;
    glass.metallic = 0;
    glass.baseColor = {1, 1, 1, 0.999f};
    glass.alphaMode = AlphaMode::blend;
    const vec3 surface = pixelOf(render(glass), kSide * 3 / 8, kSide * 3 / 8);
    EXPECT_GT(surface.x, 0.1f);
    EXPECT_LT(surface.y, 0.01f * surface.x);
    MaterialDesc black;
    black.unlit = true;
    black.baseColor = {0, 0, 0, 1};
    input.lighting.fog.density = 0.1f;
    const vec3 air = pixelOf(render(black), kSide * 3 / 8, kSide * 3 / 8);
    EXPECT_GT(air.x, 0.001f);
    EXPECT_LT(air.y, 0.1f * air.x);  // froxels are sixteen pixels wide
}

TEST_F(LightPatternsGl, WithoutThemAFrameIsAsBefore) {
    const auto commands = [&] {
        render({});
        const std::string all = renderer->printCommands();
        return all.substr(0, all.find("Readback"));
    };
    const std::string before = commands();
    const Web web;
    const LightProfileHandle profile = *renderer->createLightProfile(web.desc());
    EXPECT_EQ(commands(), before);
    light.profile = profile;
    EXPECT_NE(commands().find("BindTexture 24 "), std::string::npos);
    light.position = {0, 500, 0};  // in use, but out of sight: a camera that turns compiles nothing
    light.range = 5;
    EXPECT_NE(commands().find("BindTexture 24 "), std::string::npos);
    renderer->destroy(profile);
    EXPECT_FALSE(renderer->renderOffscreen(input, kSide, kSide, CaptureKind::hdr));
}

TEST_F(LightPatternsGl, ManyKeepTheirLayersAsTheArrayGrows) {
    std::vector<LightCookieHandle> cookies;
    for (uint32_t i = 0; i < 9; ++i) {
        const std::vector<uint8_t> pixels{uint8_t(28 * i), uint8_t(255 - 28 * i), 7, 255};
        cookies.push_back(*renderer->createLightCookie({"one", {"one", 1, 1, false, pixels}}));
    }
    for (uint32_t i = 0; i < 9; ++i) {
        light.cookie = cookies[i];
        expectColor(share(irradiance(), 0.5f, 0.5f),
                    {float(28 * i) / 255, float(255 - 28 * i) / 255, 7.0f / 255}, "colour");
    }
}

TEST_F(LightPatternsGl, BadDescriptionsAreErrors) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto makes = [&](std::vector<float> v, std::vector<float> h, std::vector<float> c) {
        return renderer->createLightProfile({"bad", v, h, c}).has_value();
    };
    EXPECT_TRUE(makes({0, 90}, {0}, {1, 1}));
    EXPECT_TRUE(makes({0, 90}, {90, 180, 270}, {1, 1, 1, 1, 1, 1}));
    EXPECT_FALSE(makes({0}, {0}, {1}));
    EXPECT_FALSE(makes({0, 190}, {0}, {1, 1}));
    EXPECT_FALSE(makes({90, 0}, {0}, {1, 1}));
    EXPECT_FALSE(makes({0, nan}, {0}, {1, 1}));
    EXPECT_FALSE(makes({0, 90}, {0, 45}, {1, 1, 1, 1}));
    EXPECT_FALSE(makes({0, 90}, {}, {}));
    EXPECT_FALSE(makes({0, 90}, {0}, {1, 1, 1}));
    EXPECT_FALSE(makes({0, 90}, {0}, {1, -1}));
    EXPECT_FALSE(makes({0, 90}, {0}, {1, nan}));
    EXPECT_FALSE(makes({0, 90}, {0}, {0, 0}));
    const std::vector<uint8_t> pixels(16);
    EXPECT_FALSE(renderer->createLightCookie({"bad", {"bad", 2, 3, true, pixels}}));
    EXPECT_FALSE(renderer->createLightCookie({"bad", {"bad", 0, 0, true, {}}}));
    light.cookie = quarters();
    light.up.x = nan;
    EXPECT_FALSE(renderer->renderOffscreen(input, kSide, kSide, CaptureKind::hdr));
}

}  // namespace
}  // namespace rushlight
