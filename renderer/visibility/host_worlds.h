#pragma once
// The worlds that a host keeps in the renderer, by handle. Used on the renderer's thread.

#include "renderer/visibility/instance_world.h"

namespace rushlight {

class HostWorlds {
public:
    WorldHandle create() { return worlds_.insert({}); }
    void destroy(WorldHandle world) { worlds_.erase(world); }

    /// `out` is as long as `instances`. An Error when the world is stale or full; then nothing is
    /// added.
    Result<void> add(WorldHandle world, std::span<const Instance> instances,
                     std::span<InstanceHandle> out);
    /// All or, when a handle is stale or the spans differ in length, none.
    Result<void> update(WorldHandle world, std::span<const InstanceHandle> handles,
                        std::span<const Instance> instances);
    Result<void> remove(WorldHandle world, std::span<const InstanceHandle> handles);

    /// Null when stale or none.
    InstanceWorld* find(WorldHandle world);
    const InstanceWorld* find(WorldHandle world) const {
        return const_cast<HostWorlds*>(this)->find(world);
    }
    template <class F>
    void forEach(F&& f) {
        worlds_.forEach([&](WorldHandle, World& world) { f(world.instances); });
    }

private:
    struct World {
        InstanceWorld instances;
        std::vector<uint16_t> generations;  ///< by slot; 0: free
        std::vector<uint16_t> lastGenerations;
    };
    Result<World*> require(WorldHandle world);
    Result<World*> require(WorldHandle world, std::span<const InstanceHandle> handles);

    Pool<World, WorldTag> worlds_;
};

}  // namespace rushlight
