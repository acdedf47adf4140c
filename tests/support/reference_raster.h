#pragma once
// Which object each pixel shows, worked out in double precision with nothing clever about it.

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// What a GPU may do to the corners of a triangle on the screen.
enum class VertexGrid {
    exact,
    nearest,
    down
};  ///< the last two on 1/256 pixel, after a transform in float

struct ReferenceObject {
    std::span<const vec3> positions;
    std::span<const uint32_t> indices;
    mat4x3 worldFromLocal{1};
    bool twoSided = false;
};

class ReferenceRaster {
public:
    ReferenceRaster(uint32_t width, uint32_t height, const mat4& clipFromWorld, VertexGrid grid)
        : width_(width),
          height_(height),
          clipFromWorld_(clipFromWorld),
          grid_(grid),
          ids(size_t(width) * height, -1),
          depths(size_t(width) * height, 0) {}

    /// Reversed z: greater is nearer. The top left rule, so that each sample on an inner edge is
    /// drawn once.
    void draw(const ReferenceObject& object, int id);

private:
    struct Corner {
        double x, y, depth;
    };
    void drawClipped(std::span<const glm::dvec4> polygon, bool clockwise, bool twoSided, int id);
    void drawTriangle(Corner a, Corner b, Corner c, bool clockwise, bool twoSided, int id);
    Corner project(const glm::dvec4& clip) const;

    uint32_t width_, height_;
    mat4 clipFromWorld_;
    VertexGrid grid_;

public:
    std::vector<int> ids;  ///< rows from the bottom; -1 where nothing is
    std::vector<double> depths;
};

}  // namespace rushlight
