// Ground, furniture, plants.

#include "content/generator/square.h"

namespace rushlight::content {

void buildGround(Square& s) {
    Document& d = s.document;
    // Setts left and right of a drain that runs from the fountain's axis to the gate.
    const float x = kGateX, w = 0.25f;
    const auto field = [&](const char* name, float x0, float x1, float z0, float z1) {
        d.addNode(name, -1, at(vec3(0)), d.mesh(d.addPart(name, groundPart(x0, x1, z0, z1))));
    };
    field("ground.west", -18.6f, x - w, -14.6f, 21.5f);
    field("ground.east", x + w, 17.7f, -14.6f, 21.5f);
    d.addNode("ground.drain", -1, at({x, 0, 3.45f}),
              d.mesh(d.addPart("ground.drain", drainPart(36.1f))));
    MeshBuilder road;
    road.use(Mat::gravel);
    road.quad({-40, -0.02f, 60}, {40, -0.02f, 60}, {40, -0.02f, 21.4f}, {-40, -0.02f, 21.4f});
    d.addNode("ground.road", -1, at(vec3(0)), d.mesh(d.addPart("ground.road", road)));
    const int pavement = d.mesh(d.addPart("pavement", pavementPart(35.2f, 1.6f)));
    d.addNode("pavement.east", -1, eastRow().at(vec3(0)), pavement);
}

void buildFurniture(Square& s) {
    Document& d = s.document;
    const int fountain = d.addNode("fountain", -1, at({-1.0f, 0, -1.0f}));
    d.addNode("fountain.basin", fountain, at(vec3(0)),
              d.mesh(d.addPart("fountain.basin", fountainBasinPart())));
    d.addNode("fountain.column", fountain, at(vec3(0)),
              d.mesh(d.addPart("fountain.column", fountainColumnPart())));
    d.addNode("fountain.water", fountain, at({0, 0.84f, 0}),
              d.mesh(d.addPart("fountain.water", waterPart(2.115f, 12))));
    d.addNode("fountain.water.bowl", fountain, at({0, 2.49f, 0}),
              d.mesh(d.addPart("fountain.water.bowl", waterPart(1.03f, 6))));

    const int bench = d.mesh(d.addPart("bench", benchPart()));
    const vec3 center(-1, 0, -1);
    for (int i = 0; i < 6; ++i) {
        const double yaw = i / 6.0 + 0.04;
        d.addNode(numbered("bench", i + 1), -1, at(center + 5.6f * yawDirection(yaw), yaw + 0.5),
                  bench);
    }

    const int barrel = d.mesh(d.addPart("barrel", barrelPart()));
    const vec2 barrels[] = {{15.4f, 5.2f},   {15.1f, 6.0f},   {15.5f, 6.8f},
                            {-9.2f, -11.6f}, {-8.4f, -11.9f}, {11.6f, 16.6f},
                            {12.4f, 16.9f},  {-14.2f, 8.8f},  {13.9f, -9.8f}};
    int number = 0;
    for (const vec2& p : barrels) {
        ++number;
        d.addNode(numbered("barrel", number), -1, at({p.x, 0, p.y}, unit(uint32_t(number), 801)),
                  barrel);
    }

    const int crate = d.mesh(d.addPart("crate", cratePart()));
    const vec3 crates[] = {{15.0f, 0, 3.9f},  {15.05f, 0.62f, 3.95f}, {14.2f, 0, 4.2f},
                           {6.0f, 0, -11.7f}, {6.9f, 0, -11.9f},      {6.4f, 0.62f, -11.8f},
                           {-14.6f, 0, 4.0f}, {-14.4f, 0, 4.9f},      {10.6f, 0, 17.2f},
                           {1.2f, 0, -9.9f}};
    number = 0;
    for (const vec3& p : crates) {
        ++number;
        d.addNode(numbered("crate", number), -1,
                  at(p, 0.06 * double(unit(uint32_t(number), 802)) - 0.03), crate);
    }

    const int sack = d.addPart("sack", sackPart());
    const vec2 sacks[] = {
        {5.1f, -11.6f}, {4.6f, -11.3f}, {-13.8f, 4.3f}, {-13.9f, 5.5f}, {9.9f, 16.9f}};
    number = 0;
    for (const vec2& p : sacks) {
        ++number;
        d.addNode(numbered("sack", number), -1, at({p.x, 0, p.y}, unit(uint32_t(number), 803)),
                  d.mesh(sack, {{Mat::clothBlue, Mat::plasterInside}}));
    }

    const int frame = d.addPart("stall", stallFramePart());
    const int awning = d.addPart("awning", awningPart());
    const int produce[] = {d.addPart("produce.1", producePart(1)),
                           d.addPart("produce.2", producePart(2))};
    const Placement stalls[] = {at({2.6f, 0, -10.2f}, 0.02), at({-4.2f, 0, -10.8f}, -0.02),
                                at({-13.0f, 0, 2.0f}, 0.23), at({-13.2f, 0, 7.0f}, 0.26),
                                at({12.2f, 0, -8.0f}, -0.10)};
    const Mat fruits[] = {Mat::terracotta, Mat::paintRed, Mat::paintGreen, Mat::plasterOchre};
    number = 0;
    for (const Placement& p : stalls) {
        const std::string name = numbered("stall", ++number);
        const int stall = d.addNode(name, -1, p, d.mesh(frame));
        d.addNode(
            name + ".awning", stall, at(vec3(0)),
            d.mesh(awning, number % 2 ? Repaint{} : Repaint{{Mat::clothRed, Mat::clothBlue}}));
        for (int i = 0; i < 3; ++i)
            d.addNode(
                name + numbered(".tray", i + 1), stall,
                at({-0.95f + 0.95f * float(i), 0.921f, 0.35f}),
                d.mesh(produce[(i + number) % 2], {{Mat::terracotta, fruits[(i + number) % 4]}}));
    }
    d.addNode("cart", -1, at({9.6f, 0, 3.6f}, 0.17), d.mesh(d.addPart("cart", cartPart())));

    const int pot = d.mesh(d.addPart("pot", potPart()));
    const int bushes[] = {d.mesh(d.addPart("bush.1", bushPart(11))),
                          d.mesh(d.addPart("bush.2", bushPart(12)))};
    const int trunk = d.mesh(d.addPart("tree.trunk", treeTrunkPart()));
    const int crowns[] = {d.mesh(d.addPart("tree.crown.1", treeCrownPart(21))),
                          d.mesh(d.addPart("tree.crown.2", treeCrownPart(22)))};
    number = 0;
    const auto potted = [&](const vec3& p) {
        const std::string name = numbered("planter", ++number);
        const int node = d.addNode(name, -1, at(p, unit(uint32_t(number), 804)), pot);
        d.addNode(name + ".bush", node, at({0, 0.45f, 0}), bushes[number % 2]);
    };
    for (int i = 0; i < 5; ++i)
        potted({kWestFront + kBay * (2 * float(i) + 2), 0.15f, kNorthFront + 0.36f});
    for (int i = 0; i < 4; ++i)
        potted({kWestFront + 0.36f, 0.15f, kNorthFront + kBay * (2 * float(i) + 2)});
    for (const float z : {-13.2f, -6.6f, 1.6f, 9.0f, 14.4f}) potted({kEastFront - 0.62f, 0.12f, z});
    const vec2 trees[] = {
        {-10.5f, -5.0f}, {10.2f, -4.6f}, {-9.4f, 10.4f}, {11.8f, 12.6f}, {-4.0f, 14.0f}};
    int trees_ = 0;
    for (const vec2& p : trees) {
        const std::string name = numbered("tree", ++trees_);
        const int node = d.addNode(name, -1, at({p.x, 0, p.y}, unit(uint32_t(trees_), 805)), trunk);
        d.addNode(name + ".crown", node, at(vec3(0), 0, 1.0f), crowns[trees_ % 2]);
    }

    const int ivy[] = {d.mesh(d.addPart("ivy.1", ivyPart(3.2f, 4.6f, 31))),
                       d.mesh(d.addPart("ivy.2", ivyPart(2.4f, 3.6f, 32)))};
    const WallFrame wall = southWall(), east = eastRow(), west = westArcade();
    d.addNode("ivy.01", -1, wall.at({-11.0f, 0, 0.1f}), ivy[0]);
    d.addNode("ivy.02", -1, wall.at({3.0f, 0, 0.1f}), ivy[1]);
    d.addNode("ivy.03", -1, wall.at({9.5f, 0, 0.1f}), ivy[0]);
    d.addNode("ivy.04", -1, east.at({-16.9f, 0.1f, 0.06f}, 0, 1.2f), ivy[1]);
    d.addNode("ivy.05", -1, east.at({6.9f, 0.1f, 0.06f}), ivy[0]);
    d.addNode("ivy.06", -1, at(kTowerAt + vec3(2.9f, 4.2f, 1.2f), 0.25), ivy[0]);
    d.addNode("ivy.07", -1, west.at({-12.8f, 4.4f, 0.3f}), ivy[1]);
}

}  // namespace rushlight::content
