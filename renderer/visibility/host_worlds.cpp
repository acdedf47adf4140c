#include "renderer/visibility/host_worlds.h"

#include <algorithm>

namespace rushlight {
namespace {

tl::unexpected<Error> wrong(const std::string& what) {
    return fail("world", what, ErrorKind::wrongUse);
}

}  // namespace

InstanceWorld* HostWorlds::find(WorldHandle handle) {
    World* world = worlds_.find(handle);
    return world ? &world->instances : nullptr;
}

Result<HostWorlds::World*> HostWorlds::require(WorldHandle handle) {
    World* world = worlds_.find(handle);
    if (!world) return wrong("the handle is stale or none.");
    return world;
}

Result<HostWorlds::World*> HostWorlds::require(WorldHandle handle,
                                               std::span<const InstanceHandle> handles) {
    auto world = require(handle);
    if (!world) return world;
    const std::vector<uint16_t>& generations = (*world)->generations;
    for (InstanceHandle instance : handles)
        if (!instance || instance.index() >= generations.size() ||
            generations[instance.index()] != instance.generation())
            return wrong("the instance handle " + std::to_string(instance.value) +
                         " is stale or none.");
    return world;
}

Result<void> HostWorlds::add(WorldHandle handle, std::span<const Instance> instances,
                             std::span<InstanceHandle> out) {
    auto world = require(handle);
    if (!world) return tl::unexpected(world.error());
    if (out.size() != instances.size())
        return wrong(std::to_string(instances.size()) + " instances but room for " +
                     std::to_string(out.size()) + " handles were given.");
    World& w = **world;
    if (w.instances.count() + instances.size() > InstanceHandle::kMaxIndex)
        return wrong("it would hold " + std::to_string(w.instances.count() + instances.size()) +
                     " instances; at most 1,048,575 are possible.");
    for (size_t i = 0; i < instances.size(); ++i) {
        const uint32_t slot = w.instances.add(instances[i]);
        if (slot >= w.generations.size()) {
            w.generations.resize(slot + 1, 0);
            w.lastGenerations.resize(slot + 1, 0);
        }
        uint16_t& last = w.lastGenerations[slot];
        last = last == InstanceHandle::kMaxGeneration ? 1 : uint16_t(last + 1);
        w.generations[slot] = last;
        out[i] = InstanceHandle::make(slot, last);
    }
    return {};
}

Result<void> HostWorlds::update(WorldHandle handle, std::span<const InstanceHandle> handles,
                                std::span<const Instance> instances) {
    if (handles.size() != instances.size())
        return wrong(std::to_string(handles.size()) + " handles but " +
                     std::to_string(instances.size()) + " instances were given.");
    auto world = require(handle, handles);
    if (!world) return tl::unexpected(world.error());
    for (size_t i = 0; i < handles.size(); ++i)
        (*world)->instances.set(handles[i].index(), instances[i]);
    return {};
}

Result<void> HostWorlds::remove(WorldHandle handle, std::span<const InstanceHandle> handles) {
    auto world = require(handle, handles);
    if (!world) return tl::unexpected(world.error());
    for (InstanceHandle instance : handles) {
        uint16_t& generation = (*world)->generations[instance.index()];
        if (generation != instance.generation()) continue;  // named twice
        generation = 0;
        (*world)->instances.remove(instance.index());
    }
    return {};
}

}  // namespace rushlight
