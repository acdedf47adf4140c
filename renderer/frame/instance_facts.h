#pragma once
// What a frame held, object by object, for tools that answer questions about it.

#include "renderer/frame/frame_input.h"

namespace rushlight {

/// An instance as the last frame saw it.
struct InstanceFacts {
    Instance instance;   ///< as it was given; of a kept one `flags` and `previousTransform` are the
                         ///< renderer's
    bool kept = false;   ///< of FrameInput::world; else of FrameInput::instances
    uint32_t index = 0;  ///< in FrameInput::instances, or the slot in the world
    bool rejected = false;  ///< left out of the frame, and why:
    bool staleMesh = false, staleMaterial = false;
    bool notFinite = false;  ///< its transform or its box, or its previous transform is missing
    Aabb bounds;             ///< world space; of no meaning where it is rejected
    uint8_t lod = 0;         ///< the level that the camera saw last, 0 is the finest
    uint8_t lodCount = 0;
    uint32_t triangles = 0;  ///< of that level
    bool closed = false;     ///< every edge of the mesh has its opposite
};

}  // namespace rushlight
