#pragma once
// Images that outlive a frame, by name: shadow maps that are kept, the exposure so far.

#include "renderer/plan/frame_plan.h"

#include <vector>

namespace rushlight {

/// Owned by a view. What an image holds is known to whoever noted its generation when it was drawn.
class ImageHistory {
public:
    struct Kept {
        TextureHandle texture;
        uint32_t generation = 0;  ///< never 0; another one when the contents are not known any more
    };

    explicit ImageHistory(Device& device) : device_(device) {}
    ~ImageHistory();
    ImageHistory(const ImageHistory&) = delete;
    ImageHistory& operator=(const ImageHistory&) = delete;

    /// The image of that name. It is made, or made anew, where there is none of that shape.
    Result<Kept> get(const PlanImage& shape);
    /// 0 where there is none of that name.
    uint32_t generationOf(const char* name) const;
    /// Nothing is known of what any image holds: a frame failed midway, or shaders changed.
    void forget();

private:
    struct Image {
        PlanImage shape;
        Kept kept;
    };
    Device& device_;
    std::vector<Image> images_;
    uint32_t lastGeneration_ = 0;
};

}  // namespace rushlight
