#pragma once
// A Device with no GPU: it accepts and counts, so that the frame builder runs and is tested
// anywhere.

#include "renderer/rhi/device.h"

namespace rushlight {

/// Descriptions and handles are checked as the GL device checks them. Reads and readbacks give
/// zeroes. Each command but DeclareImage counts as one call; hashes are zero.
std::unique_ptr<Device> createNullDevice();

}  // namespace rushlight
