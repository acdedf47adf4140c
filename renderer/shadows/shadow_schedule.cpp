#include "renderer/shadows/shadow_schedule.h"

#include "engine/core/hash.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kStill = 0, kMoving = 1;  // indices of a world

uint64_t stillContent(const ShadowFace& face) {
    return mixBits(face.viewKey ^ mixBits(face.stillHash)) | 1;
}
uint64_t content(const ShadowFace& face) {
    return mixBits(stillContent(face) + mixBits(face.movingHash)) | 1;
}
bool seesGlass(const ShadowFace* face) { return face->stillGlass || face->movingGlass; }
// What hides light hides what colours it.
uint64_t glassContent(const ShadowFace& face) {
    constexpr uint64_t kEmpty = 1;
    if (!seesGlass(&face)) return kEmpty;
    return mixBits(content(face) + mixBits(face.stillGlass) + mixBits(face.movingGlass ^ 1)) | 1;
}

}  // namespace

uint64_t ShadowSchedule::versionOf(const Inputs& in, uint32_t index) const {
    uint64_t version = mixBits(in.world.value + 1);
    for (const InstanceWorld* world : in.worlds.worlds)
        version = mixBits(version + (world ? world->version(index) + 1 : 0));
    return version | 1;
}

void ShadowSchedule::hashCasters(const Inputs& in, uint32_t index, JobSystem& jobs) {
    const uint64_t version = versionOf(in, index);
    // What the hash was made of: the view too.
    const auto key = [&](const ShadowFace& face) { return mixBits(version ^ face.viewKey) | 1; };
    asked_.clear();
    views_.clear();
    for (ShadowFace* face : in.faces) {
        const uint64_t known = index == kStill ? face->stillVersion : face->movingVersion;
        if (known == key(*face)) continue;
        asked_.push_back(face);
        views_.push_back(&face->view);
    }
    if (asked_.empty()) return;
    visibility_.gather({in.worlds, in.geometry, views_, 1u << index}, jobs);
    // Two worlds may number and stamp their instances alike. Of no casters it stays 0.
    const auto ofWorld = [whose = mixBits(in.world.value)](uint64_t hash) {
        return hash ? hash ^ whose : 0;
    };
    for (uint32_t i = 0; i < asked_.size(); ++i) {
        ShadowFace& face = *asked_[i];
        (index == kStill ? face.stillHash : face.movingHash) = ofWorld(visibility_.found(i).hash);
        (index == kStill ? face.stillGlass
                         : face.movingGlass) = ofWorld(visibility_.foundGlass(i).hash);
        (index == kStill ? face.stillVersion : face.movingVersion) = key(face);
    }
}

void ShadowSchedule::chooseDraws(const Inputs& in) {
    draws_.clear();
    glassDraws_.clear();
    for (auto& requests : requests_) requests.clear();
    hasGlass_ = in.hasGlass;
    drawn_ = cached_ = 0;
    for (ShadowFace* face : in.faces) {
        const bool drawsGlass = hasGlass_ && chooseGlass(in, *face);
        const uint64_t wanted = content(*face);
        const bool isGood = in.caching && face->drawn == wanted;
        ++(isGood && !drawsGlass ? cached_ : drawn_);
        if (isGood) continue;
        const uint32_t number = uint32_t(draws_.size());
        ShadowDraw& draw = draws_.emplace_back();
        draw.face = face;
        const bool layerIsGood = in.caching && face->drawnStill == stillContent(*face);
        // A light that moves itself would draw its layer for one use.
        const bool stands = in.caching && face->drawnView == face->viewKey;
        draw.fromLayer = layerIsGood || (stands && face->stillHash && face->movingHash);
        if (!layerIsGood && face->stillHash)
            requests_[kStill].push_back(
                {number, draw.fromLayer ? &ShadowDraw::layerCasters : &ShadowDraw::still});
        if (face->movingHash) requests_[kMoving].push_back({number, &ShadowDraw::moving});
        if (draw.fromLayer) face->drawnStill = stillContent(*face);
        face->drawn = wanted;
        face->drawnView = face->viewKey;
    }
}

bool ShadowSchedule::chooseGlass(const Inputs& in, ShadowFace& face) {
    const uint64_t wanted = glassContent(face);
    if (in.caching && face.drawnGlass == wanted) return false;
    face.drawnGlass = wanted;
    glassDraws_.push_back({&face, nullptr, {}});
    return true;
}

// Gives each draw that wants casters of that index a list with them.
void ShadowSchedule::listCasters(const Inputs& in, uint32_t index, JobSystem& jobs) {
    const std::span<const Request> requests(requests_[index]);
    if (requests.empty()) return;
    views_.clear();
    for (const Request& request : requests) views_.push_back(&draws_[request.draw].face->view);
    visibility_.gather({in.worlds, in.geometry, views_, 1u << index}, jobs);
    const uint32_t first = usedLists_;
    usedLists_ += uint32_t(requests.size());
    for (uint32_t i = 0; i < requests.size(); ++i) {
        DrawList& list = lists_[first + i];
        const auto items = visibility_.found(i).items;
        list.items.assign(items.begin(), items.end());
        draws_[requests[i].draw].*requests[i].list = &list;
    }
    jobs.forRanges(uint32_t(requests.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i)
            lists_[first + i].arrange(in.worlds, *in.geometry, {.casters = true});
    });
}

void ShadowSchedule::listGlass(const Inputs& in, JobSystem& jobs) {
    if (glassDraws_.empty()) return;
    views_.clear();
    for (const GlassDraw& draw : glassDraws_) views_.push_back(&draw.face->view);
    visibility_.gather({in.worlds, in.geometry, views_}, jobs);
    for (uint32_t i = 0; i < glassDraws_.size(); ++i) {
        const auto items = visibility_.foundGlass(i).items;
        if (items.empty()) continue;
        DrawList& list = lists_[usedLists_++];
        list.items.assign(items.begin(), items.end());
        list.arrange(in.worlds, *in.geometry, {.casters = true});
        glassDraws_[i].casters = &list;
    }
}

void ShadowSchedule::plan(const Inputs& in, JobSystem& jobs) {
    hashCasters(in, kStill, jobs);
    hashCasters(in, kMoving, jobs);
    chooseDraws(in);
    usedLists_ = 0;
    const size_t most = 2 * draws_.size() + glassDraws_.size();
    if (lists_.size() < most) lists_.resize(most);
    listCasters(in, kStill, jobs);
    listCasters(in, kMoving, jobs);
    listGlass(in, jobs);
}

}  // namespace rushlight
