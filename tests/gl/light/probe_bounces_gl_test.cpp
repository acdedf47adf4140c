// Light that reaches a mirror by way of another one: reflection probes of a file are captured twice
// for it.

#include "renderer/geometry/view_math.h"
#include "renderer/scene_bridge/scene_bridge.h"
#include "tests/support/scenes/lit_frame.h"
#include "tests/unit/assets/small_gltf.h"

#include <cmath>

namespace rushlight {
namespace {

using Json = nlohmann::json;

constexpr uint32_t kWidth = 96, kHeight = 72;
constexpr vec3 kLow{-2, 0, -3}, kHigh{2, 2.6f, 3};  // of the room
constexpr vec3 kProbe{-0.6f, 0.7f, 0.3f};
constexpr vec3 kFloor{0.9f, 0.6f, 0.3f}, kWall{0.4f, 0.7f, 0.8f};  // what they mirror, straight on

/// A room whose walls shine with a radiance of 1, but for the floor and the wall towards x, which
/// are mirrors.
test::SmallGltf mirrorRoom() {
    test::SmallGltf gltf;
    const Shape cube = makeCube();
    std::vector<float> corners;
    for (const vec3& corner : cube.positions)
        corners.insert(corners.end(), {corner.x, corner.y, corner.z});
    gltf.addPositions(corners);
    gltf.add<uint32_t>(cube.indices, 5125, "SCALAR", 1);
    gltf.json["extensionsUsed"] = {"KHR_materials_unlit"};
    const auto mirror = [](const vec3& color) {
        return Json{{"pbrMetallicRoughness",
                     {{"baseColorFactor", {color.x, color.y, color.z, 1}},
                      {"metallicFactor", 1},
                      {"roughnessFactor", 0}}}};
    };
    const Json shining = {{"extensions", {{"KHR_materials_unlit", Json::object()}}}};
    gltf.json["materials"] = {shining, mirror(kFloor), mirror(kWall)};
    for (int material = 0; material < 3; ++material)
        gltf.json["meshes"].push_back(
            {{"primitives",
              {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", material}}}}});
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            vec3 low = kLow - 0.1f, high = kHigh + 0.1f;
            (side ? low : high)[axis] = side ? kHigh[axis] : kLow[axis];
            const vec3 center = (low + high) * 0.5f, half = (high - low) * 0.5f;
            const int mesh = axis == 1 && side == 0 ? 1 : axis == 0 && side == 1 ? 2 : 0;
            gltf.json["nodes"].push_back({{"mesh", mesh},
                                          {"translation", {center.x, center.y, center.z}},
                                          {"scale", {half.x, half.y, half.z}}});
        }
    const vec3 size = kHigh - kLow, offset = (kLow + kHigh) * 0.5f - kProbe;
    const Json probe = {{"size", {size.x, size.y, size.z}},
                        {"offset", {offset.x, offset.y, offset.z}},
                        {"resolution", 128}};
    gltf.json["nodes"].push_back({{"translation", {kProbe.x, kProbe.y, kProbe.z}},
                                  {"extras", {{"rushlight", {{"reflectionProbe", probe}}}}}});
    gltf.json["scenes"] = {{{"nodes", {0, 1, 2, 3, 4, 5, 6}}}};
    gltf.json["scene"] = 0;
    return gltf;
}

/// Where a ray from within the room leaves it, and through which wall: its axis, and the side.
struct Exit {
    vec3 position;
    int axis, side;
};
Exit leave(const vec3& from, const vec3& direction) {
    Exit exit{{}, 0, 0};
    float nearest = 1e9f;
    for (int axis = 0; axis < 3; ++axis) {
        const int side = direction[axis] > 0;
        const float distance = ((side ? kHigh : kLow)[axis] - from[axis]) / direction[axis];
        if (distance < nearest) nearest = distance, exit.axis = axis, exit.side = side;
    }
    exit.position = from + direction * nearest;
    return exit;
}
bool isFloor(const Exit& at) { return at.axis == 1 && at.side == 0; }
bool isMirrorWall(const Exit& at) { return at.axis == 0 && at.side == 1; }
/// Not where texels of two walls are mixed.
bool isInside(const Exit& at) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != at.axis &&
            std::min(at.position[axis] - kLow[axis], kHigh[axis] - at.position[axis]) < 0.25f)
            return false;
    return true;
}
vec3 mirrored(const vec3& color, float cosine) {  // Schlick 1994
    return color + (1.0f - color) * std::pow(1.0f - cosine, 5.0f);
}

class ProbeBounces : public LitFrame {
protected:
    ProbeBounces() : LitFrame(kWidth, kHeight) {}
};

TEST_F(ProbeBounces, AMirrorShowsWhatAnotherOneMirrors) {
    test::SmallGltf gltf = mirrorRoom();
    const test::TempFolder folder;
    const assets::Model model = assets::loadModel(gltf.save(folder)).value();
    const auto bridge = std::move(SceneBridge::create(*renderer, model).value());
    ASSERT_TRUE(bridge->hasReflectionProbes());
    input.settings.bloom = input.settings.shadows = false;
    input.settings.ambientOcclusion = AmbientOcclusion::off;
    input.view.verticalFov = 0.9f;
    input.view.viewFromWorld = glm::lookAt(vec3(-1.5f, 1.7f, 0.2f), vec3(0.6f, 0, 0),
                                           vec3(0, 1, 0));
    bridge->fill(input);
    const auto captured = bridge->captureReflections(input);
    ASSERT_TRUE(captured) << captured.error().text();
    bridge->fill(input);
    const CapturedImage image = render();

    // By rays: the eye looks at the floor, there at the wall; that has been seen from the probe,
    // and mirrors a wall that shines.
    const CameraMatrices camera = *makeCamera(input.view, float(kWidth) / float(kHeight));
    uint32_t compared = 0, wrong = 0;
    vec3 mean(0), meanExpected(0);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const vec2 uv((float(x) + 0.5f) / kWidth, 1 - (float(y) + 0.5f) / kHeight);
            const vec3 view = glm::normalize(camera.relativePosition(uv, 1) -
                                             camera.relativePosition(uv, 0));
            const Exit floor = leave(camera.position, view);
            const Exit wall = leave(floor.position + vec3(0, 1e-5f, 0),
                                    glm::reflect(view, vec3(0, 1, 0)));
            const vec3 seen = glm::normalize(wall.position - kProbe);
            const Exit source = leave(wall.position - vec3(1e-5f, 0, 0),
                                      glm::reflect(seen, vec3(1, 0, 0)));
            if (!isFloor(floor) || !isMirrorWall(wall) || isFloor(source) || isMirrorWall(source))
                continue;
            if (!isInside(floor) || !isInside(wall) || !isInside(source)) continue;
            const vec3 expected = mirrored(kFloor, -view.y) * mirrored(kWall, seen.x);
            const vec3 difference = glm::abs(pixelOf(image, x, y) - expected);
            ++compared;
            wrong += std::max({difference.x, difference.y, difference.z}) > 0.03f;
            mean += pixelOf(image, x, y);
            meanExpected += expected;
        }
    // Measured: none of 1744 pixels, and at most 0.4 % on the mean.
    ASSERT_GT(compared, 1000u);
    EXPECT_LE(wrong, compared / 100);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / meanExpected[c], 1, 0.01f);
}

}  // namespace
}  // namespace rushlight
