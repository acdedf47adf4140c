#pragma once
// A person that walks through the level.

#include "engine/core/math.h"
#include "engine/physics/triangle_grid.h"

namespace rushlight {

/// Metres and seconds.
struct CharacterShape {
    float radius = 0.3f;
    float height = 1.8f;          ///< more than stepHeight + 2 * radius
    float stepHeight = 0.4f;      ///< ledges up to this high are walked onto
    float steepestSlope = 0.87f;  ///< radians from level; steeper ground is a wall
    float gravity = 9.81f;
    float fastestFall = 40;
};

/// An upright capsule that hovers `stepHeight` above the feet, so that low ledges pass under it,
/// and feet that feel for the ground with vertical rays. The capsule moves in pieces shorter than
/// its radius and is pushed out of what it touches, or put back where that fails; the rays cover
/// the whole fall: nothing is passed through at any speed.
class Character {
public:
    Character() = default;
    explicit Character(const vec3& feet, const CharacterShape& shape = {})
        : shape_(shape), feet_(feet) {}

    /// Walks for `seconds` with `velocity` (its y is ignored), sliding along what is in the way.
    void step(const TriangleGrid& level, const vec3& velocity, float seconds);

    /// Puts the feet at `feet` with no speed.
    void placeAt(const vec3& feet);

    const vec3& feet() const { return feet_; }
    bool isOnGround() const { return onGround_; }
    float fallSpeed() const { return fallSpeed_; }  ///< metres a second, down
    const CharacterShape& shape() const { return shape_; }

private:
    struct Contact {
        float depth = 0;
        vec3 normal{0};
    };
    void movePiecewise(const TriangleGrid& level, const vec3& motion);
    Contact deepestContact(const TriangleGrid& level) const;
    vec3 pushAgainst(const Contact& contact) const;
    void pushOut(const TriangleGrid& level);
    void standOrFall(const TriangleGrid& level, float fallen);

    CharacterShape shape_;
    vec3 feet_{0};
    float fallSpeed_ = 0;
    bool onGround_ = false;
};

}  // namespace rushlight
