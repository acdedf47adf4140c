#include "renderer/lighting/environment/cube_image.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

vec3 cubeDirection(uint32_t face, float s, float t) {
    switch (face) {
        case 0: return {1, -t, -s};
        case 1: return {-1, -t, s};
        case 2: return {s, 1, t};
        case 3: return {s, -1, -t};
        case 4: return {s, -t, 1};
        default: return {-s, -t, -1};
    }
}

CubePoint cubePoint(const vec3& d) {
    const vec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) {
        const float inverse = 1.0f / a.x;
        return d.x >= 0 ? CubePoint{0, -d.z * inverse, -d.y * inverse}
                        : CubePoint{1, d.z * inverse, -d.y * inverse};
    }
    if (a.y >= a.z) {
        const float inverse = 1.0f / a.y;
        return d.y >= 0 ? CubePoint{2, d.x * inverse, d.z * inverse}
                        : CubePoint{3, d.x * inverse, -d.z * inverse};
    }
    const float inverse = 1.0f / a.z;
    return d.z >= 0 ? CubePoint{4, d.x * inverse, -d.y * inverse}
                    : CubePoint{5, -d.x * inverse, -d.y * inverse};
}

// The solid angle of the rectangle from the face's centre to (s, t) is atan(s t / sqrt(s^2 + t^2 +
// 1)).
float cubeTexelSolidAngle(uint32_t x, uint32_t y, uint32_t size) {
    const auto corner = [](double s, double t) {
        return std::atan2(s * t, std::sqrt(s * s + t * t + 1));
    };
    const double texel = 2.0 / size;
    const double s0 = x * texel - 1, t0 = y * texel - 1;
    const double s1 = s0 + texel, t1 = t0 + texel;
    return float(corner(s0, t0) - corner(s0, t1) - corner(s1, t0) + corner(s1, t1));
}

CubeLevel::CubeLevel(uint32_t size)
    : size_(size), stride_(size + 2), texels_(size_t(6) * stride_ * stride_) {}

void CubeLevel::fillBorders() {
    const auto nearest = [&](uint32_t face, int column, int row) {
        const float scale = 2.0f / float(size_);
        const CubePoint p = cubePoint(cubeDirection(face, (float(column) + 0.5f) * scale - 1,
                                                    (float(row) + 0.5f) * scale - 1));
        const auto texel = [&](float c) {
            return uint32_t(std::clamp(int((c + 1) * 0.5f * float(size_)), 0, int(size_) - 1));
        };
        return at(p.face, texel(p.s), texel(p.t));
    };
    const int end = int(size_);
    for (uint32_t face = 0; face < 6; ++face) {
        for (int i = -1; i <= end; ++i) {
            texels_[index(face, uint32_t(i + 1), 0)] = nearest(face, i, -1);
            texels_[index(face, uint32_t(i + 1), size_ + 1)] = nearest(face, i, end);
        }
        for (int i = 0; i < end; ++i) {
            texels_[index(face, 0, uint32_t(i + 1))] = nearest(face, -1, i);
            texels_[index(face, size_ + 1, uint32_t(i + 1))] = nearest(face, end, i);
        }
    }
}

vec4 CubeLevel::sample(const vec3& direction) const {
    const CubePoint p = cubePoint(direction);
    // In texels of the bordered face, from the centre of its first border texel: 0.5 to size + 0.5.
    const float x = (p.s + 1) * 0.5f * float(size_) + 0.5f;
    const float y = (p.t + 1) * 0.5f * float(size_) + 0.5f;
    const uint32_t column = std::min(uint32_t(x), size_), row = std::min(uint32_t(y), size_);
    const float fx = x - float(column), fy = y - float(row);
    const vec4* texel = &texels_[index(p.face, column, row)];
    const vec4 low = texel[0] + (texel[1] - texel[0]) * fx;
    const vec4 high = texel[stride_] + (texel[stride_ + 1] - texel[stride_]) * fx;
    return low + (high - low) * fy;
}

CubeLevel halveCube(const CubeLevel& source, JobSystem& jobs) {
    const uint32_t size = source.size() / 2;
    CubeLevel result(size);
    std::vector<float> weights(size_t(source.size()) * source.size());
    jobs.forRanges(source.size(), 16, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y)
            for (uint32_t x = 0; x < source.size(); ++x)
                weights[size_t(y) * source.size() + x] = cubeTexelSolidAngle(x, y, source.size());
    });
    jobs.forRanges(6 * size, 16, [&](uint32_t begin, uint32_t end) {
        for (uint32_t row = begin; row < end; ++row) {
            const uint32_t face = row / size, y = row % size;
            for (uint32_t x = 0; x < size; ++x) {
                vec4 sum(0);
                float total = 0;
                for (uint32_t i = 0; i < 4; ++i) {
                    const uint32_t sx = 2 * x + i % 2, sy = 2 * y + i / 2;
                    const float weight = weights[size_t(sy) * source.size() + sx];
                    sum += source.at(face, sx, sy) * weight;
                    total += weight;
                }
                result.at(face, x, y) = sum / total;
            }
        }
    });
    result.fillBorders();
    return result;
}

CubeLevel resizeCube(const CubeLevel& source, uint32_t size, JobSystem& jobs) {
    CubeLevel result(size);
    const float scale = 2.0f / float(size);
    jobs.forRanges(6 * size, 16, [&](uint32_t begin, uint32_t end) {
        for (uint32_t row = begin; row < end; ++row) {
            const uint32_t face = row / size, y = row % size;
            for (uint32_t x = 0; x < size; ++x)
                result.at(face, x, y) = source.sample(cubeDirection(
                    face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1));
        }
    });
    result.fillBorders();
    return result;
}

}  // namespace rushlight
