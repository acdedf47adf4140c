#pragma once
// A frame to try changes on, and the pictures of such frames.

#include "renderer/renderer.h"

#include <vector>

namespace rushlight {

/// A copy of a FrameInput that owns its instances and lights. Instances of a kept world are among
/// its own when `facts` are given, so that their materials can be exchanged; else the world stays.
class EditableFrame {
public:
    explicit EditableFrame(const FrameInput& from);
    EditableFrame(const FrameInput& from, std::span<const InstanceFacts> facts);

    /// Good until the frame is changed or destroyed.
    FrameInput input() const;
    FrameSettings& settings() { return frame_.settings; }
    /// Its spans are not looked at; see below.
    Lighting& lighting() { return frame_.lighting; }
    View& view() { return frame_.view; }
    void removeDecals() { frame_.decals = {}; }
    void removeAmbientLight();
    /// No light shines, but all are there: shadow maps and lists are those of the frame.
    void darkenLights();

    std::vector<Instance> instances;
    std::vector<DirectionalLight> directional;
    std::vector<PunctualLight> punctual;
    std::vector<AreaLight> area;

private:
    FrameInput frame_;
};

/// Renders frames of one size to their end.
class Shots {
public:
    Shots(Renderer& renderer, uvec2 size) : renderer_(renderer), size_(size) {}

    Result<CapturedImage> take(const FrameInput& input, CaptureKind kind);
    Result<CapturedImage> take(FrameInput input, DebugView show,
                               CaptureKind kind = CaptureKind::display);
    Renderer& renderer() { return renderer_; }
    uvec2 size() const { return size_; }

private:
    Renderer& renderer_;
    uvec2 size_;
};

/// Materials that are destroyed with it.
class TrialMaterials {
public:
    explicit TrialMaterials(Renderer& renderer) : renderer_(renderer) {}
    ~TrialMaterials() {
        for (const MaterialHandle material : made_) renderer_.destroy(material);
    }
    TrialMaterials(const TrialMaterials&) = delete;
    TrialMaterials& operator=(const TrialMaterials&) = delete;

    Result<MaterialHandle> create(const MaterialDesc& desc) {
        auto made = renderer_.createMaterial(desc);
        if (made) made_.push_back(*made);
        return made;
    }
    /// Shows nothing of what it is on, and casts no shadow.
    Result<MaterialHandle> invisible();

private:
    Renderer& renderer_;
    MaterialHandle invisible_;
    std::vector<MaterialHandle> made_;
};

inline vec3 colorAt(const CapturedImage& image, uvec2 pixel) {
    const float* p = &image.rgba32f[(size_t(pixel.y) * image.width + pixel.x) * 4];
    return {p[0], p[1], p[2]};
}
inline const uint8_t* codesAt(const CapturedImage& image, uvec2 pixel) {
    return &image.rgba8[(size_t(pixel.y) * image.width + pixel.x) * 4];
}

}  // namespace rushlight
