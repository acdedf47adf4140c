#include "content/generator/parts/wall_panel.h"

#include <algorithm>

namespace rushlight::content {
namespace {

void cutAt(std::vector<float>& cuts, float x) {
    if (std::find(cuts.begin(), cuts.end(), x) == cuts.end()) cuts.push_back(x);
}

bool isOpen(const std::vector<Opening>& openings, float x, float y) {
    return std::any_of(openings.begin(), openings.end(), [&](const Opening& o) {
        return x > o.x0 && x < o.x1 && y > o.y0 && y < o.y1;
    });
}

void reveals(MeshBuilder& b, const Opening& o, float z, float depth) {
    const float back = z - depth;
    b.quad({o.x0, o.y0, z}, {o.x0, o.y0, back}, {o.x0, o.y1, back}, {o.x0, o.y1, z});
    b.quad({o.x1, o.y0, back}, {o.x1, o.y0, z}, {o.x1, o.y1, z}, {o.x1, o.y1, back});
    b.quad({o.x0, o.y0, z}, {o.x1, o.y0, z}, {o.x1, o.y0, back}, {o.x0, o.y0, back});
    b.quad({o.x0, o.y1, back}, {o.x1, o.y1, back}, {o.x1, o.y1, z}, {o.x0, o.y1, z});
}

}  // namespace

void wallPanel(MeshBuilder& b, const WallPanel& wall, const std::vector<Opening>& openings,
               float depth) {
    std::vector<float> xs = {wall.x0, wall.x1}, ys = {wall.y0, wall.y1};
    for (const Opening& o : openings) {
        cutAt(xs, o.x0);
        cutAt(xs, o.x1);
        cutAt(ys, o.y0);
        cutAt(ys, o.y1);
        reveals(b, o, wall.z, depth);
    }
    std::sort(xs.begin(), xs.end());
    std::sort(ys.begin(), ys.end());
    // One grid over the whole wall: no vertex lies on another quad's edge.
    for (size_t j = 0; j + 1 < ys.size(); ++j)
        for (size_t i = 0; i + 1 < xs.size(); ++i) {
            if (isOpen(openings, 0.5f * (xs[i] + xs[i + 1]), 0.5f * (ys[j] + ys[j + 1]))) continue;
            b.quad({xs[i], ys[j], wall.z}, {xs[i + 1], ys[j], wall.z},
                   {xs[i + 1], ys[j + 1], wall.z}, {xs[i], ys[j + 1], wall.z});
        }
}

}  // namespace rushlight::content
