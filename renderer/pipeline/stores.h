#pragma once
// What a host created, in one place for those who build frames of it.

#include "renderer/resources/decal_store.h"
#include "renderer/resources/environment_store.h"
#include "renderer/resources/geometry_store.h"
#include "renderer/resources/irradiance_store.h"
#include "renderer/resources/light_pattern_store.h"
#include "renderer/resources/material_store.h"
#include "renderer/resources/reflection_store.h"
#include "renderer/resources/texture_store.h"
#include "renderer/visibility/host_worlds.h"

#include <string>
#include <utility>

namespace rushlight {

struct Stores {
    Stores(Device& device, JobSystem& jobs, LogSink log, std::string cacheDirectory)
        : geometry(device),
          textures(device, jobs),
          materials(device, textures),
          decals(device),
          lightPatterns(device),
          environments(device, jobs, log, std::move(cacheDirectory)),
          reflections(device, environments),
          irradianceVolumes(device) {}

    GeometryStore geometry;
    TextureStore textures;
    MaterialStore materials;
    DecalStore decals;
    LightPatternStore lightPatterns;
    EnvironmentStore environments;
    ReflectionStore reflections;
    IrradianceStore irradianceVolumes;
    HostWorlds worlds;
};

}  // namespace rushlight
