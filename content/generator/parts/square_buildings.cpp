// Arcades, houses, the tower and the town wall.

#include "content/generator/square.h"

namespace rushlight::content {
namespace {

struct HouseSpec {
    int bays;
    int storeys;  ///< above the ground floor
    Mat plaster;
    Mat paint;
};

struct HouseKit {
    int window, shutter, door, step, chimney;
    std::map<std::pair<int, int>, int> upper, ground;
    std::map<int, int> string, cornice, roof;
};

HouseKit makeKit(Document& d) {
    HouseKit kit{d.addPart("window", windowPart()),
                 d.addPart("shutter", shutterPart()),
                 d.addPart("door", doorPart()),
                 d.addPart("doorstep", doorStepPart()),
                 d.addPart("chimney", chimneyPart()),
                 {},
                 {},
                 {},
                 {},
                 {}};
    for (const int bays : {2, 3}) {
        for (const int storeys : {1, 2})
            kit.upper[{bays, storeys}] = d.addPart(numbered("house.upper", 10 * bays + storeys),
                                                   upperWallPart(bays, storeys));
        for (int door = 0; door < bays; ++door)
            kit.ground[{bays, door}] = d.addPart(numbered("house.ground", 10 * bays + door),
                                                 groundWallPart(bays, door));
        kit.string[bays] = d.addPart(numbered("house.string", bays), stringCoursePart(bays));
        kit.cornice[bays] = d.addPart(numbered("house.cornice", bays), cornicePart(bays));
        kit.roof[bays] = d.addPart(numbered("house.roof", bays), roofPart(bays));
    }
    return kit;
}

void addWindow(Square& s, const HouseKit& kit, int house, const vec3& local, Mat paint,
               bool shutters) {
    Document& d = s.document;
    const auto n = uint32_t(s.windows++);
    const bool lit = unit(n, 701) < 0.36f;
    const Repaint glow = lit ? Repaint{} : Repaint{{Mat::windowLit, Mat::windowDark}};
    const std::string name = d.nodeName(house) + numbered(".window", int(n));
    const int window = d.addNode(name, house, at(local), d.mesh(kit.window, glow));
    if (!shutters) return;
    // Each leaf stands open at its own angle; a few are closed.
    for (const double side : {-1.0, 1.0}) {
        const float h = kWindowWidth / 2;
        const bool closed = !lit && unit(n, 702) > 0.84f;
        const double open = closed ? 0.02 : 0.455 + 0.035 * double(unit(n, 703, side > 0));
        const vec3 hinge(float(side) * (h + (closed ? 0.01f : 0.135f)), -0.01f,
                         closed ? 0.14f : 0.065f);
        // The leaf lies over +x; the left one is turned by the opening, the right one starts from
        // its far side.
        const double yaw = side < 0 ? open : 0.5 - open;
        d.addNode(name + (side < 0 ? ".shutter.left" : ".shutter.right"), window, at(hinge, -yaw),
                  d.mesh(kit.shutter, {{Mat::paintGreen, paint}}));
    }
}

/// A house over `base` metres of something else; its node is at the foot of its front.
int addUpper(Square& s, const HouseKit& kit, const WallFrame& row, float x, float base,
             const HouseSpec& spec, int number) {
    Document& d = s.document;
    const std::string name = numbered("house", number);
    const Repaint plaster = {{Mat::plasterCream, spec.plaster}};
    const int house = d.addNode(name, -1, row.at({x, 0, 0}));
    d.addNode(name + ".wall", house, at({0, base, 0}),
              d.mesh(kit.upper.at({spec.bays, spec.storeys}), plaster));
    for (int storey = 0; storey < spec.storeys; ++storey) {
        const float y = base + kStorey * float(storey);
        d.addNode(name + numbered(".string", storey), house, at({0, y, 0}),
                  d.mesh(kit.string.at(spec.bays)));
        for (int i = 0; i < spec.bays; ++i) {
            const vec3 local(kBay * (float(i) - 0.5f * float(spec.bays - 1)), y + kWindowSill, 0);
            addWindow(s, kit, house, local, spec.paint, true);
        }
    }
    const float top = base + kStorey * float(spec.storeys);
    d.addNode(name + ".cornice", house, at({0, top, 0}), d.mesh(kit.cornice.at(spec.bays)));
    d.addNode(name + ".roof", house, at({0, top + 0.03f, 0}), d.mesh(kit.roof.at(spec.bays)));
    const float side = kBay * 0.5f * float(spec.bays) - 1.1f;
    d.addNode(name + ".chimney", house,
              at({unit(uint32_t(number), 711) > 0.5f ? side : -side, top + 2.2f,
                  -kHouseDepth / 2 + 1.1f}),
              d.mesh(kit.chimney));
    return house;
}

struct ArcadeKit {
    int arch, floor, column, pier, back, backWithDoor;
};

void addArcade(Square& s, const ArcadeKit& kit, const HouseKit& house, const std::string& stem,
               const WallFrame& row, int bays) {
    Document& d = s.document;
    const std::string& name = stem;
    const int root = d.addNode(name, -1, row.at({0, 0, 0}));
    for (int i = 0; i <= bays; ++i) {
        const bool end = i == 0 || i == bays;
        d.addNode(numbered((stem + (end ? ".pier" : ".column")).c_str(), i), root,
                  at({kBay * (float(i) - 0.5f * float(bays)), kArcadeFloor, 0}),
                  d.mesh(end ? kit.pier : kit.column));
    }
    for (int i = 0; i < bays; ++i) {
        const float x = kBay * (float(i) - 0.5f * float(bays - 1));
        const auto piece = [&](const char* suffix, float y, int part) {
            d.addNode(numbered((stem + suffix).c_str(), i), root, at({x, y, 0}), d.mesh(part));
        };
        const bool hasDoor = i % 3 == 1;
        piece(".floor", 0, kit.floor);
        piece(".arch", kArcadeFloor, kit.arch);
        piece(".back", kArcadeFloor, hasDoor ? kit.backWithDoor : kit.back);
        const Mat paints[] = {Mat::paintGreen, Mat::paintBlue, Mat::paintRed, Mat::wood};
        if (hasDoor)
            d.addNode(numbered((stem + ".door").c_str(), i), root,
                      at({x, kArcadeFloor, -kArcadeDepth}),
                      d.mesh(house.door, {{Mat::paintGreen, paints[(i / 3) % 4]}}));
        else
            d.addNode(numbered((stem + ".window").c_str(), i), root,
                      at({x, kArcadeFloor + 1.0f, -kArcadeDepth}),
                      d.mesh(house.window,
                             i % 2 ? Repaint{} : Repaint{{Mat::windowLit, Mat::windowDark}}));
    }
}

void addRow(Square& s, const HouseKit& kit, const WallFrame& row, float base, bool ground,
            std::span<const HouseSpec> houses, int& number) {
    int bays = 0;
    for (const HouseSpec& h : houses) bays += h.bays;
    float left = -0.5f * kBay * float(bays);
    for (const HouseSpec& spec : houses) {
        const float x = left + 0.5f * kBay * float(spec.bays);
        left += kBay * float(spec.bays);
        const int house = addUpper(s, kit, row, x, base, spec, ++number);
        if (!ground) continue;
        Document& d = s.document;
        const std::string name = numbered("house", number);
        const int doorBay = number % spec.bays;
        d.addNode(name + ".ground", house, at(vec3(0)),
                  d.mesh(kit.ground.at({spec.bays, doorBay}), {{Mat::plasterCream, spec.plaster}}));
        for (int i = 0; i < spec.bays; ++i) {
            const float local = kBay * (float(i) - 0.5f * float(spec.bays - 1));
            if (i != doorBay) {
                addWindow(s, kit, house, {local, 0.35f + kWindowSill, 0}, spec.paint, false);
                continue;
            }
            d.addNode(name + ".door", house, at({local, 0.3f, 0}),
                      d.mesh(kit.door, {{Mat::paintGreen, spec.paint}}));
            d.addNode(name + ".steps", house, at({local, 0, 0}), d.mesh(kit.step));
        }
    }
}

void addTower(Square& s) {
    Document& d = s.document;
    const int tower = d.addNode("tower", -1, at(kTowerAt));
    d.addNode("tower.shaft", tower, at(vec3(0)),
              d.mesh(d.addPart("tower.shaft", towerShaftPart())));
    d.addNode("tower.belfry", tower, at({0, kTowerShaft, 0}),
              d.mesh(d.addPart("tower.belfry", belfryPart())));
    d.addNode("tower.roof", tower, at({0, kTowerShaft + 5.21f, 0}),
              d.mesh(d.addPart("tower.roof", towerRoofPart())));
    d.addNode("tower.bell", tower, at({0, kTowerShaft + 4.02f, 0}),
              d.mesh(d.addPart("tower.bell", bellPart())));
}

void addTownWall(Square& s) {
    Document& d = s.document;
    const WallFrame row = southWall();
    const int part = d.addPart("wall", townWallPart());
    const int root = d.addNode("wall", -1, row.at(vec3(0)));
    // The gate takes 7.2 m; segments fill both sides, and reach under the houses at the ends.
    int number = 0;
    const float gate = -kGateX;
    for (int i = 0; i < 4; ++i)
        d.addNode(numbered("wall", ++number), root,
                  at({gate - 3.6f - kWallSegment * (float(i) + 0.5f), 0, 0}), d.mesh(part));
    for (int i = 0; i < 6; ++i)
        d.addNode(numbered("wall", ++number), root,
                  at({gate + 3.6f + kWallSegment * (float(i) + 0.5f), 0, 0}), d.mesh(part));
    d.addNode("gate", root, at({gate, 0, 0.45f}), d.mesh(d.addPart("gate", gateTowerPart())));
    const int leaf = d.mesh(d.addPart("gate.leaf", gateLeafPart()));
    d.addNode("gate.leaf.left", root, at({gate - 1.66f, 0, -0.75f}, 0.27), leaf);
    d.addNode("gate.leaf.right", root, at({gate + 1.66f, 0, -0.75f}, 0.23), leaf);
}

}  // namespace

void buildBuildings(Square& s) {
    Document& d = s.document;
    const HouseKit kit = makeKit(d);
    const ArcadeKit arcade{d.addPart("arcade.arch", archPart()),
                           d.addPart("arcade.floor", arcadeFloorPart()),
                           d.addPart("arcade.column", columnPart()),
                           d.addPart("arcade.pier", pierPart()),
                           d.addPart("arcade.back", arcadeBackPart(false)),
                           d.addPart("arcade.back.door", arcadeBackPart(true))};
    addArcade(s, arcade, kit, "arcade.north", northArcade(), 11);
    addArcade(s, arcade, kit, "arcade.west", westArcade(), 10);
    int number = 0;
    const float overArcade = kArcadeFloor + kArcadeHeight;
    const HouseSpec north[] = {{3, 2, Mat::plasterOchre, Mat::paintGreen},
                               {2, 1, Mat::plasterRose, Mat::paintBlue},
                               {3, 2, Mat::plasterCream, Mat::paintRed},
                               {3, 1, Mat::plasterOchre, Mat::paintBlue}};
    const HouseSpec west[] = {{3, 1, Mat::plasterCream, Mat::paintBlue},
                              {2, 2, Mat::plasterOchre, Mat::paintRed},
                              {2, 1, Mat::brick, Mat::paintGreen},
                              {3, 1, Mat::plasterRose, Mat::paintGreen}};
    const HouseSpec east[] = {{3, 2, Mat::plasterRose, Mat::paintGreen},
                              {2, 1, Mat::plasterCream, Mat::paintRed},
                              {3, 2, Mat::brick, Mat::paintBlue},
                              {3, 1, Mat::plasterOchre, Mat::paintGreen}};
    const WallFrame rows[] = {northArcade(), westArcade(), eastRow()};
    // The upper fronts stand 6 cm behind the arches' faces.
    addRow(s, kit, {rows[0].point({0, 0, 0.19f}), rows[0].yaw}, overArcade, false, north, number);
    addRow(s, kit, {rows[1].point({0, 0, 0.19f}), rows[1].yaw}, overArcade, false, west, number);
    addRow(s, kit, rows[2], kGroundFloor, true, east, number);
    addTower(s);
    addTownWall(s);
}

}  // namespace rushlight::content
