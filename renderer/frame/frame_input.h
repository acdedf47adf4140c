#pragma once
// One frame as data: what the host hands over. Spans are read during Renderer::render alone.
// Units: metres, seconds, radians; right-handed, y up. Colours are linear Rec.709 unless said
// otherwise.

#include "engine/core/bounds.h"
#include "renderer/frame/decals.h"
#include "renderer/frame/frame_settings.h"
#include "renderer/frame/lights.h"

namespace rushlight {

using ViewHandle = Handle<struct ViewTag>;  ///< what a view remembers, see Renderer::createView
using WorldHandle = Handle<struct WorldTag>;
using InstanceHandle = Handle<struct InstanceTag>;  ///< within its world

enum InstanceFlags : uint32_t {
    kInstanceCastsShadow = 1,
    kInstanceMoving = 2,    ///< `previousTransform` indexes FrameInput::previousTransforms
    kInstanceOccluder = 4,  ///< hides much: considered before the occluders that the renderer finds
                            ///< itself
    kInstanceNoOccluder = 8,  ///< never considered as one
};

struct Instance {
    mat4x3 worldFromLocal{1.0f};
    MeshHandle mesh;
    MaterialHandle material;  ///< zero: glTF's default material
    uint32_t id = 0;          ///< the caller's; kept in the order of ties
    uint32_t flags = kInstanceCastsShadow;
    uint32_t previousTransform = 0;
};

/// A camera looks along -z of its own space.
struct View {
    mat4 viewFromWorld{1};
    bool perspective = true;
    float verticalFov = 0.785f;  ///< perspective
    float orthoHalfHeight = 1;   ///< orthographic
    float aspect = 0;            ///< width over height; 0: that of the target
    /// Perspective, in place of the two: tangents of the angles from the view axis to the left,
    /// right, bottom and top edge, as of an eye of a headset or a part of a larger picture. All
    /// zero: none.
    vec4 frustum{0};
    vec2 jitter{0};          ///< pixels, right and up: where in each pixel the scene is
                             ///< sampled, from its middle; -1 to 1
    float nearPlane = 0.1f;  ///< > 0 for perspective
    float farPlane = 0;      ///< 0: infinite (perspective only)
    ViewHandle state;        ///< what it remembers; zero: the default view
};

/// A run of overlay triangles with one scissor rectangle (pixels from the top left).
struct OverlayBatch {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    ivec2 clipLow{0};
    ivec2 clipHigh{0};
};

/// A user interface drawn over the frame, in sRGB, after everything. `image` (coverage in alpha) is
/// sampled at uv.
struct Overlay {
    std::span<const OverlayVertex> vertices;
    std::span<const uint32_t> indices;
    std::span<const OverlayBatch> batches;
    ImageHandle image;
};

struct FrameInput {
    View view;
    WorldHandle world;                    ///< instances that the renderer keeps; zero: none
    std::span<const Instance> instances;  ///< others, for this frame; equal to the last frame's
                                          ///< they cost a comparison
    std::span<const mat4x3> previousTransforms;
    std::span<const Decal> decals;  ///< at most kMaxDecals; those of no good box or material are
                                    ///< left out
    Lighting lighting;
    FrameSettings settings;
    Overlay overlay;
};

}  // namespace rushlight
