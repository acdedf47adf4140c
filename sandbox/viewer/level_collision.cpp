#include "engine/scene/pose.h"
#include "sandbox/viewer/level.h"

namespace rushlight {

std::vector<CollisionTriangle> collisionTriangles(const assets::Model& model) {
    std::vector<CollisionTriangle> triangles;
    const scene::Pose pose = scene::restPose(model);
    for (const scene::Drawable& drawable : scene::listDrawables(model, pose)) {
        if (drawable.deforms) continue;  // people and flags are walked through
        const assets::Geometry& geometry = model.geometries[size_t(drawable.geometry)];
        const auto corner = [&](size_t i) {
            return transformPoint(drawable.worldFromLocal, geometry.positions[geometry.indices[i]]);
        };
        for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3)
            triangles.push_back({{corner(i), corner(i + 1), corner(i + 2)}});
    }
    return triangles;
}

}  // namespace rushlight
