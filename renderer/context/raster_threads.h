#pragma once

#include "renderer/context/context.h"

namespace rushlight {

/// Puts llvmpipe's raster thread N (named "llvmpipe-N") on the N-th core that this process may use,
/// modulo their number. Draws once into an object of its own, so that the threads are there and
/// named. Does nothing on a GPU. Returns how many threads were moved. The kernel otherwise often
/// leaves all of them on one core.
uint32_t pinRasterThreads(GlLoader);

}  // namespace rushlight
