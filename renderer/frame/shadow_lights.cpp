#include "renderer/frame/shadow_lights.h"

#include "engine/core/hash.h"
#include "renderer/frame/light_clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kNoSlot = ~0u;
constexpr uint32_t kMaxSlots = 512;
constexpr uint32_t kSmallestLevel = 6;
static_assert(1u << kSmallestLevel == ShadowLights::kSmallestTile);
/// Lights that were seen so many frames ago keep their squares as if they were seen: the camera may turn back.
constexpr uint64_t kRecentFrames = 1200;
/// A spot with a wider cone has a cube's faces: a single view would waste its texels at the rim.
constexpr float kWidestSpot = 1.05f;

bool isCube(const PunctualLight& light) {
    return light.outerConeAngle < 0 || light.outerConeAngle > kWidestSpot;
}

float spotTangent(const PunctualLight& light) {
    return std::tan(std::max(light.outerConeAngle, 0.02f));
}

// Of a light without a range it follows from the intensity, which may flicker: then in steps.
float shadowRange(const PunctualLight& light) {
    if (light.range > 0) return light.range;
    const float range = effectiveRange(light);
    return range > 0 ? std::exp2(std::ceil(std::log2(range))) : 0;
}

uint64_t identityOf(const PunctualLight& light, float range) {
    const bool cube = isCube(light);
    const float parts[] = {light.position.x, light.position.y, light.position.z, range,
                           std::max(light.shadowNear, 1e-3f),
                           cube ? 0.0f : light.direction.x, cube ? 0.0f : light.direction.y,
                           cube ? 0.0f : light.direction.z, cube ? 0.0f : spotTangent(light)};
    return hashBytes(parts, sizeof parts, 11) | 1;
}

// The texels a side for which a texel on a surface at 60 % of the range is a pixel of the camera's.
float texelsOnScreen(const CameraMatrices& camera, uint32_t targetHeight,
                     const PunctualLight& light, float range) {
    const float distance = range * 0.6f;
    const float tangent = isCube(light) ? 1 : spotTangent(light);
    float pixelsPerMetre =
        float(targetHeight) / (2 * (camera.perspective ? camera.tanHalfY : camera.halfHeight));
    if (camera.perspective) {
        const float fromCamera = glm::length(light.position - camera.position);
        pixelsPerMetre /= std::max({fromCamera - distance, distance, camera.nearPlane});
    }
    return 2 * tangent * distance * pixelsPerMetre;
}

}  // namespace

void ShadowLights::begin(const FrameSettings& settings) {
    ++frame_;
    counts_ = {};
    const uint32_t size = std::bit_floor(settings.shadowAtlasSize);
    largestLevel_ = uint32_t(std::countr_zero(
        std::clamp(std::bit_floor(settings.shadowTileSize), kSmallestTile, size)));
    if (size == tiles_.size()) return;
    slots_.reserve(kMaxSlots);  // faces are pointed at
    slots_.clear();
    slotOfLight_.clear();
    bias_ = 0;
    tiles_.reset(size, kSmallestTile);
}

void ShadowLights::findWanted(const Inputs& in) {
    wanted_.clear();
    for (uint32_t i = 0; i < in.punctual.size(); ++i) {
        const PunctualLight& light = in.punctual[i];
        if (!light.castsShadow) continue;
        const float range = shadowRange(light);
        if (!(range > light.shadowNear) ||
            !intersects(in.camera->frustum, light.position, vec3(range)))
            continue;
        Wanted w{};
        w.light = i;
        w.range = range;
        w.identity = identityOf(light, range);
        w.faceCount = isCube(light) ? 6 : 1;
        const float texels = texelsOnScreen(*in.camera, in.targetHeight, light, range);
        w.wish = std::clamp(std::log2(std::max(texels, 1.0f)), float(kSmallestLevel),
                            float(largestLevel_));
        const float peak = std::max({light.intensity.x, light.intensity.y, light.intensity.z});
        w.priority = texels * std::sqrt(std::max(peak, 0.0f)) / range;
        wanted_.push_back(w);
    }
}

void ShadowLights::matchSlots(size_t lightCount) {
    slotOfLight_.assign(lightCount, kNoSlot);
    for (uint32_t s = 0; s < slots_.size(); ++s)
        if (slots_[s].identity && slots_[s].light < lightCount) {
            uint32_t& of = slotOfLight_[slots_[s].light];
            if (of == kNoSlot || slots_[s].lastSeen > slots_[of].lastSeen) of = s;
        }
    const auto claim = [&](Wanted& w, uint32_t slot) {
        w.slot = slot;
        slots_[slot].lastSeen = frame_;
        slots_[slot].light = w.light;
    };
    for (Wanted& w : wanted_) {
        w.slot = kNoSlot;
        if (const uint32_t known = findSlot(w); known != kNoSlot) claim(w, known);
    }
    for (Wanted& w : wanted_) {
        if (w.slot != kNoSlot) continue;
        // What was at its index and is nowhere now has moved: it keeps its squares.
        uint32_t slot = slotOfLight_[w.light];
        if (slot == kNoSlot || slots_[slot].lastSeen == frame_ ||
            slots_[slot].faceCount != w.faceCount)
            slot = freeSlot();
        if (slot == kNoSlot) continue;
        slots_[slot].identity = w.identity;
        slots_[slot].faceCount = w.faceCount;
        claim(w, slot);
    }
}

uint32_t ShadowLights::findSlot(const Wanted& w) {
    const auto is = [&](uint32_t s) {
        return slots_[s].identity == w.identity && slots_[s].lastSeen != frame_;
    };
    if (const uint32_t s = slotOfLight_[w.light]; s != kNoSlot && is(s)) return s;
    for (uint32_t s = 0; s < slots_.size(); ++s)
        if (is(s)) return s;
    return kNoSlot;
}

uint32_t ShadowLights::freeSlot() {
    for (uint32_t s = 0; s < slots_.size(); ++s)
        if (!slots_[s].identity) return s;
    if (slots_.size() < kMaxSlots) {
        slots_.emplace_back();
        return uint32_t(slots_.size() - 1);
    }
    if (!evictOldest()) return kNoSlot;
    return freeSlot();
}

// Frees the slot of the light that has been out of view for longest.
bool ShadowLights::evictOldest() {
    Slot* oldest = nullptr;
    for (Slot& slot : slots_)
        if (slot.identity && slot.lastSeen != frame_ &&
            (!oldest || slot.lastSeen < oldest->lastSeen))
            oldest = &slot;
    if (!oldest) return false;
    releaseTiles(*oldest);
    *oldest = {};
    return true;
}

void ShadowLights::releaseTiles(Slot& slot) {
    if (slot.level)
        for (uint32_t f = 0; f < slot.faceCount; ++f) tiles_.release(slot.faces[f].tile);
    slot.level = 0;
    slot.faces = {};
}

// Up when twice the texels are asked for, down when less than a third are.
void ShadowLights::updateWishes() {
    for (const Wanted& w : wanted_) {
        if (w.slot == kNoSlot) continue;
        uint32_t& wish = slots_[w.slot].wish;
        if (wish == 0 || w.wish <= float(wish) - 1.6f) wish = uint32_t(std::lround(w.wish));
        else if (w.wish >= float(wish) + 1) wish = uint32_t(w.wish);
        wish = std::clamp(wish, kSmallestLevel, largestLevel_);
    }
    for (Slot& slot : slots_)
        if (slot.identity && slot.lastSeen + kRecentFrames < frame_) {
            releaseTiles(slot);
            slot = {};
        }
}

// What lowers all by a level does so in four steps, a quarter of the lights each, whichever they are: an order by
// importance would change with the camera, and each change is a map to draw.
uint32_t ShadowLights::levelOf(const Slot& slot, uint32_t bias) const {
    const uint32_t isLower = (slot.identity >> 8 & 3) < bias % 4;
    const uint32_t less = std::min(bias / 4 + isLower, largestLevel_ - kSmallestLevel);
    return std::min(slot.wish, largestLevel_ - less);
}

uint64_t ShadowLights::texelsAt(uint32_t bias) const {
    uint64_t sum = 0;
    for (const Slot& slot : slots_)
        if (slot.identity) sum += uint64_t(slot.faceCount) << 2 * levelOf(slot, bias);
    return sum;
}

// The largest lose what it takes for those seen lately to fit, and get it back when there is ample room.
void ShadowLights::chooseBias() {
    const uint64_t room = uint64_t(tiles_.size()) * tiles_.size();
    const uint32_t before = bias_;
    while (bias_ < 4 * (largestLevel_ - kSmallestLevel) && texelsAt(bias_) > room) ++bias_;
    if (bias_ == before)
        while (bias_ > 0 && texelsAt(std::max(bias_, 2u) - 2) <= room / 4 * 3) --bias_;
    while (texelsAt(bias_) > room && evictOldest()) {}
}

bool ShadowLights::placeTiles(Slot& slot) {
    const uint32_t level = levelOf(slot, bias_);
    for (uint32_t f = 0; f < slot.faceCount; ++f) {
        const auto tile = tiles_.allocate(1u << level);
        if (!tile) {
            while (f-- > 0) tiles_.release(slot.faces[f].tile);
            slot.faces = {};
            return false;
        }
        slot.faces[f] = {};
        slot.faces[f].tile = *tile;
    }
    slot.level = level;
    return true;
}

// Even the smallest may be too many. Then the least important go without; who has squares has to be clearly less
// important to lose them.
void ShadowLights::dropTooMany() {
    uint64_t room = uint64_t(tiles_.size()) * tiles_.size();
    if (texelsAt(bias_) <= room) return;
    const auto rank = [&](const Wanted& w) {
        return w.slot != kNoSlot && slots_[w.slot].level ? w.priority * 1.5f : w.priority;
    };
    std::ranges::sort(wanted_, [&](const Wanted& a, const Wanted& b) {
        return rank(a) != rank(b) ? rank(a) > rank(b) : a.light < b.light;
    });
    for (Wanted& w : wanted_) {
        if (w.slot == kNoSlot) continue;
        Slot& slot = slots_[w.slot];
        const uint64_t needed = uint64_t(slot.faceCount) << 2 * levelOf(slot, bias_);
        if (needed <= room) {
            room -= needed;
            continue;
        }
        releaseTiles(slot);
        slot = {};
        w.slot = kNoSlot;
    }
}

// The largest first: what fits by its area then fits into an empty atlas. When the gaps between those that are kept are
// too small, all are placed anew.
void ShadowLights::placeTiles() {
    const auto level = [&](const Wanted& w) {
        return w.slot == kNoSlot ? 0 : levelOf(slots_[w.slot], bias_);
    };
    std::ranges::sort(wanted_, [&](const Wanted& a, const Wanted& b) {
        return level(a) != level(b) ? level(a) > level(b) : a.light < b.light;
    });
    for (Slot& slot : slots_)
        if (slot.level && slot.level != levelOf(slot, bias_)) releaseTiles(slot);
    const auto placeAll = [&] {
        bool all = true;
        for (const Wanted& w : wanted_)
            if (w.slot != kNoSlot && !slots_[w.slot].level) all &= placeTiles(slots_[w.slot]);
        return all;
    };
    if (placeAll()) return;
    for (Slot& slot : slots_) releaseTiles(slot);
    placeAll();
}

void ShadowLights::fillFace(const Inputs& in, const Wanted& w, uint32_t index) {
    const PunctualLight& light = in.punctual[w.light];
    ShadowFace& face = slots_[w.slot].faces[index];
    ShadowFaceDesc desc;
    desc.position = light.position;
    desc.nearPlane = std::max(light.shadowNear, 1e-3f);
    desc.range = w.range;
    desc.texels = face.tile.size;
    if (w.faceCount == 6) {
        cubeFaceBasis(index, desc.right, desc.up, desc.forward);
    } else {
        const float length = glm::length(light.direction);
        desc.forward = length > 0 ? light.direction / length : vec3(0, -1, 0);
        desc.tanHalf = spotTangent(light);
        spotBasis(desc.forward, desc.right, desc.up);
    }
    face.view.scale.maxError = in.settings->shadowLodTexelError;
    face.view.scale.minSize = in.settings->smallObjectPixels;
    makeShadowView(desc, face.view);
    if (!in.settings->frustumCulling) face.view.volume = {};
    const float limits[] = {face.view.scale.maxError, face.view.scale.minSize, w.range};
    face.viewKey = hashBytes(limits, sizeof limits, hashBytes(&face.view.clipFromWorld, sizeof(mat4)));
    gpuFaces_.push_back(makeGpuShadowFace(desc, face.tile.x, face.tile.y, tiles_.size(), light.radius));
    faces_.push_back(&face);
}

// A record is twice the index of the first face; odd for a cube.
void ShadowLights::fillFaces(const Inputs& in) {
    std::ranges::sort(wanted_, {}, &Wanted::light);
    records_.assign(in.punctual.size(), -1);
    for (const Wanted& w : wanted_) {
        if (w.slot == kNoSlot || !slots_[w.slot].level) {
            ++counts_.without;
            continue;
        }
        const Slot& slot = slots_[w.slot];
        ++counts_.lights;
        counts_.reduced += slot.level < slot.wish;
        records_[w.light] = int32_t(2 * gpuFaces_.size() + (w.faceCount == 6 ? 1 : 0));
        for (uint32_t f = 0; f < slot.faceCount; ++f) fillFace(in, w, f);
    }
    anyRecord_ = !gpuFaces_.empty();
}

ShadowLights::Counts ShadowLights::select(const Inputs& inputs) {
    begin(*inputs.settings);
    faces_.clear();
    gpuFaces_.clear();
    findWanted(inputs);
    matchSlots(inputs.punctual.size());
    updateWishes();
    chooseBias();
    dropTooMany();
    placeTiles();
    fillFaces(inputs);
    return counts_;
}

void ShadowLights::forget() {
    for (Slot& slot : slots_)
        for (ShadowFace& face : slot.faces) face.drawn = face.drawnStill = 0;
}

}  // namespace rushlight
