#include "engine/physics/character.h"

#include "engine/physics/closest.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr float kSkin = 0.002f;      // metres of penetration that are left alone
constexpr float kRingRadius = 0.7f;  // of the capsule's, for the rays around the middle one
constexpr int kRingRays = 8;
constexpr int kPushes = 8;

Segment axisOf(const vec3& feet, const CharacterShape& shape) {
    return {feet + vec3(0, shape.stepHeight + shape.radius, 0),
            feet + vec3(0, shape.height - shape.radius, 0)};
}

}  // namespace

void Character::placeAt(const vec3& feet) {
    feet_ = feet;
    fallSpeed_ = 0;
    onGround_ = false;
}

void Character::step(const TriangleGrid& level, const vec3& velocity, float seconds) {
    movePiecewise(level, vec3(velocity.x, 0, velocity.z) * seconds);
    // Trapezoidal rule: exact for a constant acceleration, whatever the length of the step.
    const float before = fallSpeed_;
    fallSpeed_ = std::min(fallSpeed_ + shape_.gravity * seconds, shape_.fastestFall);
    standOrFall(level, 0.5f * (before + fallSpeed_) * seconds);
}

void Character::movePiecewise(const TriangleGrid& level, const vec3& motion) {
    const float length = glm::length(motion);
    if (length == 0) return;
    const int pieces = int(std::ceil(length / (0.5f * shape_.radius)));
    for (int i = 0; i < pieces; ++i) {
        const vec3 before = feet_;
        const float depthBefore = deepestContact(level).depth;
        feet_ += motion / float(pieces);
        pushOut(level);
        // Wedged in: stay, rather than be squeezed through to the other side.
        const float depth = deepestContact(level).depth;
        if (depth > 0.5f * shape_.radius && depth > depthBefore) feet_ = before;
    }
}

Character::Contact Character::deepestContact(const TriangleGrid& level) const {
    const Segment axis = axisOf(feet_, shape_);
    const Aabb box{axis.start - shape_.radius, axis.end + shape_.radius};
    const vec3 middle = 0.5f * (axis.start + axis.end);
    Contact deepest;
    level.forEachTouching(box, [&](const CollisionTriangle& triangle) {
        const auto& [a, b, c] = triangle.corners;
        const ClosestPoints points = closestPoints(axis, a, b, c);
        const float distance = std::sqrt(points.distanceSquared);
        const float depth = shape_.radius - distance;
        if (depth <= deepest.depth) return;
        vec3 normal;
        if (distance > 1e-6f) {
            normal = (points.first - points.second) / distance;
        } else {
            normal = glm::normalize(glm::cross(b - a, c - a));
            if (glm::dot(middle - a, normal) < 0) normal = -normal;
        }
        deepest = {depth, normal};
    });
    return deepest;
}

/// Ground pushes up; on the ground everything else pushes sideways, so that nobody is lifted over a
/// high ledge or pressed into the floor.
vec3 Character::pushAgainst(const Contact& contact) const {
    const vec3 level = vec3(contact.normal.x, 0, contact.normal.z);
    const float across = glm::length(level);
    const bool isGround = contact.normal.y >= std::cos(shape_.steepestSlope);
    if (isGround || !onGround_ || across < 0.1f) return contact.normal * contact.depth;
    return level * (contact.depth / (across * across));
}

void Character::pushOut(const TriangleGrid& level) {
    for (int i = 0; i < kPushes; ++i) {
        const Contact contact = deepestContact(level);
        if (contact.depth <= kSkin) return;
        feet_ += pushAgainst(contact);
        if (contact.normal.y >= std::cos(shape_.steepestSlope)) fallSpeed_ = 0;
    }
}

void Character::standOrFall(const TriangleGrid& level, float fallen) {
    const float above = shape_.stepHeight + shape_.radius;  // inside the capsule: free of obstacles
    const float below = onGround_ ? std::max(fallen, shape_.stepHeight) : fallen;
    const vec3 top = feet_ + vec3(0, above, 0);
    float nearest = above + below;
    bool found = false;
    const auto feel = [&](const vec3& offset) {
        const std::optional<RayHit> hit = level.castDown(top + offset, nearest);
        if (!hit || hit->normal.y < std::cos(shape_.steepestSlope)) return;
        nearest = hit->distance;
        found = true;
    };
    feel(vec3(0));
    for (int i = 0; i < kRingRays; ++i) {
        const float angle = 2 * kPi * float(i) / kRingRays;
        feel(vec3(std::cos(angle), 0, std::sin(angle)) * (kRingRadius * shape_.radius));
    }
    onGround_ = found;
    if (found) {
        feet_.y = top.y - nearest;
        fallSpeed_ = 0;
    } else {
        // No ground that holds: steep faces are left to the capsule.
        movePiecewise(level, vec3(0, -fallen, 0));
    }
}

}  // namespace rushlight
