#pragma once

#include <string>

namespace rushlight {

/// Copies the test card (`testcard`, its folder) into `folder` and adds moving.gltf: the test card
/// with an animation of 3 s, in which the camera goes far away and comes back, and a lamp and a
/// sphere move. Aborts where that cannot be written.
void writeMovingScene(const std::string& testcard, const std::string& folder);

}  // namespace rushlight
