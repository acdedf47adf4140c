#pragma once
// Which instance each pixel shows, found with the frame's own G-buffer: every instance gets a
// material whose metalness is a digit of its number, with what decides over coverage (alpha cut,
// sides) as it was; one frame a digit.

#include "renderer/answers/editable_frame.h"

namespace rushlight {

class SurfaceFinder {
public:
    static constexpr uint32_t kNone = ~0u;

    /// `facts`: of the last frame of `input`. They must outlive it.
    SurfaceFinder(Shots& shots, const FrameInput& input, std::span<const InstanceFacts> facts)
        : shots_(shots), input_(input), facts_(facts), materials_(shots.renderer()) {}

    bool hasBlended() const;
    /// By pixel, rows from the top: which of the facts is seen there, of opaque and masked surfaces
    /// or, `withBlended`, of all that are not wholly transparent there; kNone for the background.
    Result<std::vector<uint32_t>> find(bool withBlended);

private:
    static constexpr uint32_t kDigits = 16;

    Result<MaterialHandle> digitMaterial(MaterialHandle original, uint32_t digit, bool withBlended);
    Result<void> paint(EditableFrame& frame, uint32_t digitPlace, bool withBlended);

    struct Painted {
        MaterialHandle original;
        uint32_t digit;
        bool withBlended;
        MaterialHandle material;
    };
    Shots& shots_;
    const FrameInput& input_;
    std::span<const InstanceFacts> facts_;
    TrialMaterials materials_;
    std::vector<Painted> painted_;
};

}  // namespace rushlight
