#pragma once
// Which pipeline of a shadow pass an object needs, for SurfacePipelines::prepare().

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/visibility/caster.h"

namespace rushlight {

inline uint32_t casterFlags(uint32_t flags) {
    return castsShadow(flags) ? shadowFlags(flags) : SurfacePipelines::kNoPipeline;
}
inline uint32_t glassCasterFlags(uint32_t flags) {
    return coloursLight(flags) ? glassFlags(flags) : SurfacePipelines::kNoPipeline;
}

}  // namespace rushlight
