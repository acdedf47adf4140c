#pragma once

#include "engine/core/result.h"
#include "renderer/frame/resource_descs.h"

namespace rushlight {

/// Gets the descriptions of resources that a Renderer has, under the renderer's handles. Spans are
/// good during the call; an Error ends the walk.
class ResourceSink {
public:
    virtual ~ResourceSink() = default;
    virtual Result<void> image(ImageHandle, const ImageDesc&) = 0;
    virtual Result<void> mesh(MeshHandle, const MeshDesc&) = 0;
    virtual Result<void> material(MaterialHandle, const MaterialDesc&) = 0;
};

}  // namespace rushlight
