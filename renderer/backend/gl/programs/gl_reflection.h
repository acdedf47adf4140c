#pragma once
// What a linked program reads, asked of the driver: what it has optimised away is not among it.

#include "renderer/backend/gl/gl_functions.h"
#include "renderer/rhi/resource_lookup.h"

namespace rushlight {

PipelineSlots reflectSlots(const GlFunctions& gl, GLuint program);

}  // namespace rushlight
