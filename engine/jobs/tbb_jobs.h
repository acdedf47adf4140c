#pragma once

#include "engine/core/jobs.h"

#include <memory>

namespace rushlight {

/// oneTBB behind the job interface, in an arena of its own with `threads` slots (0: one per core).
std::unique_ptr<JobSystem> createTbbJobs(uint32_t threads);

}  // namespace rushlight
