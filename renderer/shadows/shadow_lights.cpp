#include "renderer/shadows/shadow_lights.h"

#include "engine/core/hash.h"
#include "renderer/lighting/clusters/light_clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kNoSlot = ~0u;
constexpr uint32_t kMaxSlots = 512;
constexpr uint32_t kSmallestLevel = 6;
static_assert(1u << kSmallestLevel == ShadowLights::kSmallestTile);
/// Lights that were seen so many frames ago keep their squares as if they were seen: the camera may
/// turn back.
constexpr uint64_t kRecentFrames = 1200;
// The texels a side for which two texels on a surface at 60 % of the range are a pixel of the
// camera's: filters are four wide, and what is nearer than that has larger pixels.
float texelsOnScreen(const CameraMatrices& camera, uint32_t targetHeight,
                     const ShadowSource& light) {
    const float distance = light.range * 0.6f;
    const float tangent = light.tanHalf;
    float pixelsPerMetre = float(targetHeight) /
                           (2 * (camera.perspective ? camera.tanHalfY : camera.halfHeight));
    if (camera.perspective) {
        const float fromCamera = glm::length(light.position - camera.position);
        pixelsPerMetre /= std::max({fromCamera - distance, distance, camera.nearPlane});
    }
    return 4 * tangent * distance * pixelsPerMetre;
}

}  // namespace

void ShadowLights::begin(const FrameSettings& settings) {
    ++history_->frame;
    counts_ = {};
    const uint32_t size = std::bit_floor(settings.shadowAtlasSize);
    largestLevel_ = uint32_t(
        std::countr_zero(std::clamp(std::bit_floor(settings.shadowTileSize), kSmallestTile, size)));
    before_.clear();
    if (settings.cut) history_->slots.swap(before_);
    if (size == history_->tiles.size() && !settings.cut) return;
    if (size != history_->tiles.size()) before_.clear();
    history_->slots.clear();
    slotOfLight_.clear();
    history_->bias = 0;
    history_->tiles.reset(size, kSmallestTile);
}

// After a cut: what the square holds already, if it is this light's again.
void ShadowLights::takeOver(ShadowFace& face, const Slot& slot, uint32_t index) const {
    for (const Slot& was : before_)
        if (was.identity == slot.identity && was.level && was.faces[index].tile == face.tile) {
            face = was.faces[index];
            return;
        }
}

void ShadowLights::findWanted(const Inputs& in) {
    wanted_.clear();
    for (uint32_t i = 0; i < in.punctual.size(); ++i)
        if (in.punctual[i].castsShadow)
            addIfWanted(in, i, in.punctual[i].shadowNear, makeShadowSource(in.punctual[i]));
    for (uint32_t i = 0; i < in.area.size(); ++i)
        if (in.area[i].castsShadow)
            addIfWanted(in, uint32_t(in.punctual.size()) + i, 0, makeShadowSource(in.area[i]));
}

void ShadowLights::addIfWanted(const Inputs& in, uint32_t light, float nearest,
                               const ShadowSource& source) {
    if (!(source.range > nearest) || !intersects(in.camera->frustum, source.position, source.range))
        return;
    Wanted w{};
    w.light = light;
    w.source = source;
    const float texels = texelsOnScreen(*in.camera, in.targetHeight, source);
    w.wish = std::clamp(std::log2(std::max(texels, 1.0f)), float(kSmallestLevel),
                        float(largestLevel_));
    w.priority = texels * std::sqrt(source.peak) / source.range;
    wanted_.push_back(w);
}

void ShadowLights::matchSlots(size_t lightCount) {
    slotOfLight_.assign(lightCount, kNoSlot);
    for (uint32_t s = 0; s < history_->slots.size(); ++s)
        if (history_->slots[s].identity && history_->slots[s].light < lightCount) {
            uint32_t& of = slotOfLight_[history_->slots[s].light];
            if (of == kNoSlot || history_->slots[s].lastSeen > history_->slots[of].lastSeen) of = s;
        }
    const auto claim = [&](Wanted& w, uint32_t slot) {
        w.slot = slot;
        history_->slots[slot].lastSeen = history_->frame;
        history_->slots[slot].light = w.light;
    };
    for (Wanted& w : wanted_) {
        w.slot = kNoSlot;
        if (const uint32_t known = findSlot(w); known != kNoSlot) claim(w, known);
    }
    for (Wanted& w : wanted_) {
        if (w.slot != kNoSlot) continue;
        // What was at its index and is nowhere now has moved: it keeps its squares.
        uint32_t slot = slotOfLight_[w.light];
        if (slot == kNoSlot || history_->slots[slot].lastSeen == history_->frame ||
            history_->slots[slot].faceCount != w.source.faceCount)
            slot = freeSlot();
        if (slot == kNoSlot) continue;
        history_->slots[slot].identity = w.source.identity;
        history_->slots[slot].faceCount = w.source.faceCount;
        claim(w, slot);
    }
}

uint32_t ShadowLights::findSlot(const Wanted& w) {
    const auto is = [&](uint32_t s) {
        return history_->slots[s].identity == w.source.identity &&
               history_->slots[s].lastSeen != history_->frame;
    };
    if (const uint32_t s = slotOfLight_[w.light]; s != kNoSlot && is(s)) return s;
    for (uint32_t s = 0; s < history_->slots.size(); ++s)
        if (is(s)) return s;
    return kNoSlot;
}

uint32_t ShadowLights::freeSlot() {
    for (uint32_t s = 0; s < history_->slots.size(); ++s)
        if (!history_->slots[s].identity) return s;
    if (history_->slots.size() < kMaxSlots) {
        history_->slots.emplace_back();
        return uint32_t(history_->slots.size() - 1);
    }
    if (!evictOldest()) return kNoSlot;
    return freeSlot();
}

// Frees the slot of the light that has been out of view for longest.
bool ShadowLights::evictOldest() {
    Slot* oldest = nullptr;
    for (Slot& slot : history_->slots)
        if (slot.identity && slot.lastSeen != history_->frame &&
            (!oldest || slot.lastSeen < oldest->lastSeen))
            oldest = &slot;
    if (!oldest) return false;
    releaseTiles(*oldest);
    *oldest = {};
    return true;
}

void ShadowLights::releaseTiles(Slot& slot) {
    if (slot.level)
        for (uint32_t f = 0; f < slot.faceCount; ++f) history_->tiles.release(slot.faces[f].tile);
    slot.level = 0;
    slot.faces = {};
}

// Up when twice the texels are asked for, down when less than a third are.
void ShadowLights::updateWishes() {
    for (const Wanted& w : wanted_) {
        if (w.slot == kNoSlot) continue;
        uint32_t& wish = history_->slots[w.slot].wish;
        if (wish == 0 || w.wish <= float(wish) - 1.6f)
            wish = uint32_t(std::lround(w.wish));
        else if (w.wish >= float(wish) + 1)
            wish = uint32_t(w.wish);
        wish = std::clamp(wish, kSmallestLevel, largestLevel_);
    }
    for (Slot& slot : history_->slots)
        if (slot.identity && slot.lastSeen + kRecentFrames < history_->frame) {
            releaseTiles(slot);
            slot = {};
        }
}

// What lowers all by a level does so in four steps, a quarter of the lights each, whichever they
// are: an order by importance would change with the camera, and each change is a map to draw.
uint32_t ShadowLights::levelOf(const Slot& slot, uint32_t bias) const {
    const uint32_t isLower = (slot.identity >> 8 & 3) < bias % 4;
    const uint32_t less = std::min(bias / 4 + isLower, largestLevel_ - kSmallestLevel);
    return std::min(slot.wish, largestLevel_ - less);
}

uint64_t ShadowLights::texelsAt(uint32_t bias) const {
    uint64_t sum = 0;
    for (const Slot& slot : history_->slots)
        if (slot.identity) sum += uint64_t(slot.faceCount) << 2 * levelOf(slot, bias);
    return sum;
}

// The largest lose what it takes for those seen lately to fit, and get it back when there is ample
// room.
void ShadowLights::chooseBias() {
    const uint64_t room = uint64_t(history_->tiles.size()) * history_->tiles.size();
    const uint32_t before = history_->bias;
    while (history_->bias < 4 * (largestLevel_ - kSmallestLevel) && texelsAt(history_->bias) > room)
        ++history_->bias;
    if (history_->bias == before)
        while (history_->bias > 0 && texelsAt(std::max(history_->bias, 2u) - 2) <= room / 4 * 3)
            --history_->bias;
    while (texelsAt(history_->bias) > room && evictOldest()) {
    }
}

bool ShadowLights::placeTiles(Slot& slot) {
    const uint32_t level = levelOf(slot, history_->bias);
    for (uint32_t f = 0; f < slot.faceCount; ++f) {
        const auto tile = history_->tiles.allocate(1u << level);
        if (!tile) {
            while (f-- > 0) history_->tiles.release(slot.faces[f].tile);
            slot.faces = {};
            return false;
        }
        slot.faces[f] = {};
        slot.faces[f].tile = *tile;
        takeOver(slot.faces[f], slot, f);
    }
    slot.level = level;
    return true;
}

// Even the smallest may be too many. Then the least important go without; who has squares has to be
// clearly less important to lose them.
void ShadowLights::dropTooMany() {
    uint64_t room = uint64_t(history_->tiles.size()) * history_->tiles.size();
    if (texelsAt(history_->bias) <= room) return;
    const auto rank = [&](const Wanted& w) {
        return w.slot != kNoSlot && history_->slots[w.slot].level ? w.priority * 1.5f : w.priority;
    };
    std::ranges::sort(wanted_, [&](const Wanted& a, const Wanted& b) {
        return rank(a) != rank(b) ? rank(a) > rank(b) : a.light < b.light;
    });
    for (Wanted& w : wanted_) {
        if (w.slot == kNoSlot) continue;
        Slot& slot = history_->slots[w.slot];
        const uint64_t needed = uint64_t(slot.faceCount) << 2 * levelOf(slot, history_->bias);
        if (needed <= room) {
            room -= needed;
            continue;
        }
        releaseTiles(slot);
        slot = {};
        w.slot = kNoSlot;
    }
}

// The largest first: what fits by its area then fits into an empty atlas. When the gaps between
// those that are kept are too small, all are placed anew.
void ShadowLights::placeTiles() {
    const auto level = [&](const Wanted& w) {
        return w.slot == kNoSlot ? 0 : levelOf(history_->slots[w.slot], history_->bias);
    };
    std::ranges::sort(wanted_, [&](const Wanted& a, const Wanted& b) {
        return level(a) != level(b) ? level(a) > level(b) : a.light < b.light;
    });
    for (Slot& slot : history_->slots)
        if (slot.level && slot.level != levelOf(slot, history_->bias)) releaseTiles(slot);
    const auto placeAll = [&] {
        bool all = true;
        for (const Wanted& w : wanted_)
            if (w.slot != kNoSlot && !history_->slots[w.slot].level)
                all &= placeTiles(history_->slots[w.slot]);
        return all;
    };
    if (placeAll()) return;
    for (Slot& slot : history_->slots) releaseTiles(slot);
    placeAll();
}

void ShadowLights::fillFace(const Inputs& in, const Wanted& w, uint32_t index) {
    const ShadowSource& source = w.source;
    ShadowFace& face = history_->slots[w.slot].faces[index];
    ShadowFaceDesc desc;
    desc.position = source.position;
    desc.nearPlane = source.nearPlane(index);
    desc.range = source.range;
    desc.texels = face.tile.size;
    desc.border = source.border;
    desc.tanHalf = source.tanHalf;
    source.face(index, desc.right, desc.up, desc.forward);
    face.view.scale.maxError = in.settings->shadowLodTexelError;
    face.view.scale.minSize = in.settings->smallObjectPixels;
    makeShadowView(desc, face.view);
    // Behind a light of one side there is nothing that it could light.
    if (source.faceCount == 5)
        face.view.volume.add(Plane{source.axes[2], -glm::dot(source.axes[2], source.position)});
    if (!in.settings->frustumCulling) face.view.volume = {};
    const float limits[] = {face.view.scale.maxError, face.view.scale.minSize, source.range};
    face.viewKey = hashBytes(limits, sizeof limits,
                             hashBytes(&face.view.clipFromWorld, sizeof(mat4)));
    gpuFaces_.push_back(
        makeGpuShadowFace(desc, face.tile.x, face.tile.y, history_->tiles.size(), source.radius));
    faces_.push_back(&face);
}

// A record is twice the index of the first face; odd for a cube. An area light's is the index
// alone.
void ShadowLights::fillFaces(const Inputs& in) {
    std::ranges::sort(wanted_, {}, &Wanted::light);
    records_.assign(in.punctual.size(), -1);
    areaRecords_.assign(in.area.size(), -1);
    anyRecord_ = anyAreaRecord_ = false;
    for (const Wanted& w : wanted_) {
        if (w.slot == kNoSlot || !history_->slots[w.slot].level) {
            ++counts_.without;
            continue;
        }
        const Slot& slot = history_->slots[w.slot];
        ++counts_.lights;
        counts_.reduced += slot.level < slot.wish;
        const int32_t first = int32_t(in.firstFace + gpuFaces_.size());
        if (w.light < records_.size()) {
            records_[w.light] = 2 * first + (w.source.isCube() ? 1 : 0);
            anyRecord_ = true;
        } else {
            areaRecords_[w.light - records_.size()] = first;
            anyAreaRecord_ = true;
        }
        for (uint32_t f = 0; f < slot.faceCount; ++f) fillFace(in, w, f);
    }
}

ShadowLights::Counts ShadowLights::select(const Inputs& inputs, ShadowAtlasHistory& history) {
    history_ = &history;
    begin(*inputs.settings);
    faces_.clear();
    gpuFaces_.clear();
    findWanted(inputs);
    matchSlots(inputs.punctual.size() + inputs.area.size());
    updateWishes();
    chooseBias();
    dropTooMany();
    placeTiles();
    fillFaces(inputs);
    return counts_;
}

void ShadowAtlasHistory::forgetContents() {
    for (Slot& slot : slots)
        for (ShadowFace& face : slot.faces) face.drawn = face.drawnStill = face.drawnGlass = 0;
}

}  // namespace rushlight
