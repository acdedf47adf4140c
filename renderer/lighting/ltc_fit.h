#pragma once
// Fits linearly transformed cosines to the specular lobe of shaders/interop/brdf.h. The program
// fit_ltc writes the table that is checked in (ltc_table.cpp) with it; tests fit some entries
// again.

#include "engine/core/jobs.h"
#include "engine/core/math.h"

#include <vector>

namespace rushlight {

/// The inverse matrix of interop::applyLtc for one view. First Nelder and Mead 1965 on the
/// difference of the two lobes, each normalised, to the power of 1.5, by samples of both (Heitz et
/// al. 2016, section 4, with the cube): of the powers 1 to 3 the one with the least errors of whole
/// lights. Lobes that are not sharp then also by what caps of three sizes all over the hemisphere
/// get of them. Deterministic.
vec4 fitLtc(float nDotV, float roughness);

/// Rows of roughness from 0 to 1, columns of sqrt(1 - nDotV) from 0 to 1. The same for any number
/// of threads.
std::vector<vec4> fitLtcTable(JobSystem& jobs, uint32_t size);

/// The specular lobe times the cosine for a Fresnel term of 1: what is fitted.
float specularLobe(float nDotV, float roughness, const vec3& light);

}  // namespace rushlight
