#include "content/generator/surface.h"

namespace rushlight::content {
namespace {

using Field = std::vector<float>;

uint8_t toByte(float x) { return uint8_t(saturate(x) * 255.0f + 0.5f); }

/// A byte in steps of `step`: the noise of these maps hides it, and it halves the files.
uint8_t toCoarseByte(float x, int step) {
    const int value = int(saturate(x) * 255.0f / float(step) + 0.5f) * step;
    return uint8_t(value > 255 ? 255 : value);
}

/// The mean over a square of 2 * radius + 1 pixels on the torus, as two passes of running sums.
Field boxBlur(const Field& in, int size, int radius) {
    const auto pass = [&](const Field& from, bool rows) {
        Field to(from.size());
        for (int line = 0; line < size; ++line) {
            const auto at = [&](int i) {
                const int k = ((i % size) + size) % size;
                return size_t(rows ? line * size + k : k * size + line);
            };
            double sum = 0;
            for (int i = -radius; i <= radius; ++i) sum += from[at(i)];
            for (int i = 0; i < size; ++i) {
                to[at(i)] = float(sum / double(2 * radius + 1));
                sum += from[at(i + radius + 1)] - from[at(i - radius)];
            }
        }
        return to;
    };
    return pass(pass(in, true), false);
}

/// How open each point is: low where it lies below its neighbourhood, at two scales.
Field cavityOpenness(const Field& height, int size, float metresPerPixel, float strength) {
    Field open(height.size(), 1.0f);
    for (const int radius : {size / 128 + 1, size / 32 + 1}) {
        const Field mean = boxBlur(height, size, radius);
        const float scale = strength / (float(radius) * metresPerPixel);
        for (size_t i = 0; i < open.size(); ++i)
            open[i] *= 1 - 0.85f * saturate((mean[i] - height[i]) * scale);
    }
    return open;
}

/// Steps of 2 from 128 on, so that a flat normal stays exact to half a step.
float coarse(float x) {
    return (std::floor((x * 255.0f - 128.0f) * 0.5f + 0.5f) * 2.0f + 128.0f) / 255.0f;
}

Picture normalPicture(const Field& height, int size, float metresPerPixel) {
    Picture out{size, size, 3, {}};
    const auto at = [&](int x, int y) {
        return height[size_t(((y + size) % size) * size + (x + size) % size)];
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float slopeRight = (at(x + 1, y) - at(x - 1, y)) / (2 * metresPerPixel);
            const float slopeUp = (at(x, y - 1) - at(x, y + 1)) / (2 * metresPerPixel);
            const float scale = 1 / std::sqrt(slopeRight * slopeRight + slopeUp * slopeUp + 1);
            out.bytes.push_back(toByte(coarse(0.5f - 0.5f * slopeRight * scale)));
            out.bytes.push_back(toByte(coarse(0.5f - 0.5f * slopeUp * scale)));
            out.bytes.push_back(toByte(coarse(0.5f + 0.5f * scale)));
        }
    return out;
}

}  // namespace

SurfaceMaps bakeSurface(const SurfaceSpec& spec) {
    const int size = spec.size, half = size / 2;
    const auto count = size_t(size) * size_t(size);
    std::vector<Texel> texels(count);
    Field height(count);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const size_t i = size_t(y * size + x);
            texels[i] = spec.texel((float(x) + 0.5f) / float(size),
                                   (float(y) + 0.5f) / float(size));
            height[i] = texels[i].height;
        }
    const float metresPerPixel = spec.metres / float(size);
    const Field open = cavityOpenness(height, size, metresPerPixel, spec.occlusion);

    SurfaceMaps maps;
    maps.color = {size, size, spec.alpha ? 4 : 3, {}};
    for (size_t i = 0; i < count; ++i) {
        const float shade = mixf(1, open[i], 0.35f);  // dirt gathers where rain and feet do not
                                                      // reach
        for (int c = 0; c < 3; ++c)
            maps.color.bytes.push_back(toCoarseByte(texels[i].color[c] * shade, 4));
        if (spec.alpha) maps.color.bytes.push_back(toByte(texels[i].alpha));
    }
    maps.normal = normalPicture(height, size, metresPerPixel);
    maps.orm = {half, half, 3, {}};
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < half; ++x) {
            float sums[3] = {0, 0, 0};
            for (int k = 0; k < 4; ++k) {
                const size_t i = size_t((2 * y + k / 2) * size + 2 * x + k % 2);
                sums[0] += 0.25f * open[i];
                sums[1] += 0.25f * texels[i].roughness;
                sums[2] += 0.25f * texels[i].metallic;
            }
            for (const float s : sums) maps.orm.bytes.push_back(toCoarseByte(s, 5));
        }
    return maps;
}

}  // namespace rushlight::content
