#include "engine/assets/ies_planes.h"

#include <algorithm>
#include <cmath>

namespace rushlight::assets {
namespace {

constexpr float kDegree = kPi / 180;
constexpr float kBeside = 0.01f;  // degrees from an edge to the dark
constexpr int kTurns = 180;       // steps about the axis

struct Place {
    size_t index;
    float share;  // of the next
};

/// None beyond the angles.
bool findPlace(const std::vector<float>& angles, float angle, Place& place) {
    if (angle < angles.front() - 1e-3f || angle > angles.back() + 1e-3f) return false;
    const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, angle);
    place.index = size_t(above - angles.begin()) - 1;
    const float low = angles[place.index];
    place.share = std::clamp((angle - low) / (*above - low), 0.0f, 1.0f);
    return true;
}

float candelaAt(const LightProfile& file, float vertical, float horizontal) {
    if (file.horizontalAngles.front() >= 0) horizontal = std::abs(horizontal);
    Place v, h;
    if (!findPlace(file.verticalAngles, vertical, v) ||
        !findPlace(file.horizontalAngles, horizontal, h))
        return 0;
    const auto along = [&](size_t row) {
        const float* candela = &file.candela[row * file.verticalAngles.size() + v.index];
        return candela[0] + (candela[1] - candela[0]) * v.share;
    };
    return along(h.index) + (along(h.index + 1) - along(h.index)) * h.share;
}

float signedTurn(float horizontal) { return horizontal > 180 ? horizontal - 360 : horizontal; }

void anglesOfA(const LightProfile& file, LightProfile& out) {
    for (const float v : file.verticalAngles) out.verticalAngles.push_back(v + 90);
    std::vector<float>& turns = out.horizontalAngles;
    turns = {0, 90 + kBeside, 270 - kBeside, 360};
    for (const float h : file.horizontalAngles) {
        turns.push_back(h < 0 ? h + 360 : h);
        if (file.horizontalAngles.front() >= 0) turns.push_back(360 - h);
    }
    std::ranges::sort(turns);
    turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
}

void anglesOfB(const LightProfile& file, LightProfile& out) {
    float finest = 1;
    for (const std::vector<float>* angles : {&file.verticalAngles, &file.horizontalAngles})
        for (size_t i = 1; i < angles->size(); ++i)
            finest = std::min(finest, (*angles)[i] - (*angles)[i - 1]);
    const int steps = int(std::ceil(90 / std::max(finest, 0.25f)));
    for (int i = 0; i <= steps; ++i) out.verticalAngles.push_back(90 * float(i) / float(steps));
    for (int i = 0; i <= kTurns; ++i) out.horizontalAngles.push_back(360 * float(i) / kTurns);
}

float candelaOfB(const LightProfile& file, float fromDown, float turn) {
    const float sine = std::sin(fromDown * kDegree);
    const float x = sine * std::cos(turn * kDegree), y = sine * std::sin(turn * kDegree);
    const float down = std::max(std::cos(fromDown * kDegree), 0.0f);
    return candelaAt(file, std::atan2(x, down) / kDegree,
                     std::asin(std::clamp(y, -1.0f, 1.0f)) / kDegree);
}

}  // namespace

LightProfile asTypeC(const LightProfile& file, IesPlanes planes) {
    if (planes == IesPlanes::c) return file;
    LightProfile out;
    out.name = file.name;
    if (planes == IesPlanes::a)
        anglesOfA(file, out);
    else
        anglesOfB(file, out);
    out.candela.reserve(out.verticalAngles.size() * out.horizontalAngles.size());
    for (const float turn : out.horizontalAngles)
        for (const float fromDown : out.verticalAngles) {
            const float candela = planes == IesPlanes::a
                                      ? candelaAt(file, fromDown - 90, signedTurn(turn))
                                      : candelaOfB(file, fromDown, turn);
            out.candela.push_back(candela);
            out.largestCandela = std::max(out.largestCandela, candela);
        }
    return out;
}

}  // namespace rushlight::assets
