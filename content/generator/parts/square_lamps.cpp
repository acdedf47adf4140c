// Every lamp: a lantern with panes, a bulb that shows, and a punctual light just below it. The
// light hangs clear of the cage, so that shadow maps see neither bulb nor bars close to it.

#include "content/generator/square.h"

namespace rushlight::content {
namespace {

struct LampKit {
    int lantern, bulb, post, bracket, chain;
};

struct LampLook {
    vec3 color;
    Mat bulb;
};

LampLook look(LampColor color) {
    switch (color) {
        case LampColor::warm: return {{1.0f, 0.70f, 0.38f}, Mat::bulbWarm};
        case LampColor::amber: return {{1.0f, 0.52f, 0.20f}, Mat::bulbAmber};
        case LampColor::cool: break;
    }
    return {{0.55f, 0.80f, 1.0f}, Mat::bulbCool};
}

/// A lantern that hangs at `local` of `parent`.
void addLantern(Square& s, const LampKit& kit, int parent, const vec3& local, LampColor color,
                float candela, float range) {
    Document& d = s.document;
    const std::string name = numbered("lamp", ++s.lamps);
    const LampLook l = look(color);
    const int lamp = d.addNode(name, parent, at(local), d.mesh(kit.lantern));
    d.addNode(name + ".bulb", lamp, at(vec3(0)), d.mesh(kit.bulb, {{Mat::bulbWarm, l.bulb}}));
    const int light = d.addNode(name + ".light", lamp, at({0, -kLanternDrop, 0}));
    d.addLight(light, {LightSpec::Kind::point, l.color, candela, range});
}

void addPost(Square& s, const LampKit& kit, const vec3& position, double yaw) {
    const int post = s.document.addNode(numbered("lamp.post", s.lamps / 2 + 1), -1,
                                        at(position, yaw), s.document.mesh(kit.post));
    for (const float x : {-0.62f, 0.62f})
        addLantern(s, kit, post, {x, 3.50f, 0}, LampColor::warm, 22, 12);
}

void addBracket(Square& s, const LampKit& kit, const Placement& place, LampColor color,
                float candela, float range) {
    const int bracket = s.document.addNode(numbered("lamp.bracket", s.lamps + 1), -1, place,
                                           s.document.mesh(kit.bracket));
    addLantern(s, kit, bracket, {0, -0.01f, 0.5f}, color, candela, range);
}

/// The node turns about the chain's upper end.
void addSwing(Square& s, const LampKit& kit, const vec3& position, LampColor color, float candela) {
    const int swing = s.document.addNode("lamp.swing." + std::to_string(++s.swingingLamps), -1,
                                         at(position), s.document.mesh(kit.chain));
    addLantern(s, kit, swing, {0, -0.60f, 0}, color, candela, 7);
}

}  // namespace

void buildLamps(Square& s) {
    Document& d = s.document;
    const LampKit kit{d.addPart("lantern", lanternPart()), d.addPart("bulb", bulbPart()),
                      d.addPart("lamp.post", lampPostPart()),
                      d.addPart("lamp.bracket", wallBracketPart()),
                      d.addPart("chain", chainPart(0.60f))};
    addPost(s, kit, {-7.2f, 0, 4.4f}, 0.10);
    addPost(s, kit, {5.4f, 0, 2.6f}, 0.02);
    addPost(s, kit, {-6.4f, 0, -7.2f}, -0.06);
    addPost(s, kit, {6.6f, 0, -8.6f}, 0.05);

    // Under the arcades, in the middle of every other bay.
    const WallFrame north = northArcade(), west = westArcade();
    for (int i = 0; i < 6; ++i)
        addSwing(s, kit, north.point({kBay * (2 * float(i) - 5), 4.12f, -1.9f}),
                 i % 3 == 2 ? LampColor::amber : LampColor::warm, 8);
    for (int i = 0; i < 5; ++i)
        addSwing(s, kit, west.point({kBay * (2 * float(i) - 4.5f), 4.12f, -1.9f}),
                 i % 2 ? LampColor::amber : LampColor::warm, 8);

    const WallFrame east = eastRow(), south = southWall();
    for (const float x : {-14.4f, -8.0f, -3.2f, 8.0f, 14.4f})
        addBracket(s, kit, east.at({x, 3.15f, 0}), LampColor::warm, 9, 9);
    for (const float side : {-1.0f, 1.0f})
        addBracket(s, kit, south.at({-kGateX + 2.6f * side, 3.7f, 0.46f}), LampColor::amber, 14,
                   10);
    addBracket(s, kit, south.at({12.5f, 3.6f, 0.02f}), LampColor::cool, 9, 9);
    addBracket(s, kit, at(kTowerAt + vec3(2.75f, 6.4f, 1.6f), 0.25), LampColor::cool, 6, 8);

    // Over two of the stalls.
    addSwing(s, kit, {2.6f, 2.64f, -10.1f}, LampColor::amber, 3);
    addSwing(s, kit, {-13.0f, 2.64f, 2.0f}, LampColor::amber, 3);

    // Spots: one up the tower, one on the gate's shield, and a cool glow in the fountain.
    const auto spot = [&](const char* name, const vec3& from, const vec3& to,
                          const LightSpec& light) {
        const vec3 back = normalize(from - to), right = normalize(cross(vec3(0, 1, 0), back));
        const quat q = normalize(glm::quat_cast(mat3(right, cross(back, right), back)));
        d.addLight(d.addNode(name, -1, {from, q, vec3(1)}), light);
    };
    spot("spot.belfry", kTowerAt + vec3(1.2f, kTowerShaft + 0.3f, 1.2f),
         kTowerAt + vec3(-0.4f, kTowerShaft + 4.5f, -0.4f),
         {LightSpec::Kind::spot, {1, 0.60f, 0.28f}, 10, 8, 0.17f});
    spot("spot.gate", {kGateX, 4.4f, kSouthFront - 3.2f}, {kGateX, 5.6f, kSouthFront},
         {LightSpec::Kind::spot, {1, 0.75f, 0.5f}, 8, 8, 0.08f});
    const int glow = d.addNode("lamp.fountain", -1, at({-1.0f, 3.05f, -0.2f}));
    d.addLight(glow, {LightSpec::Kind::point, {0.55f, 0.80f, 1.0f}, 0.7f, 6});
}

}  // namespace rushlight::content
