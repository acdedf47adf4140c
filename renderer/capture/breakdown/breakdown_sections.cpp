#include "renderer/capture/breakdown/breakdown.h"

namespace rushlight {
namespace {

constexpr BreakdownSection kSections[] = {
    {"culling", "What is drawn",
     "Which objects reach the screen, and why the others do not: outside of the view, hidden "
     "behind others, smaller "
     "than a pixel, or not valid."},
    {"gbuffer", "G-buffer",
     "One image of surface properties: each opaque surface writes colour, normal, roughness, "
     "emission and depth, once a "
     "pixel."},
    {"lights", "Each light's view",
     "The scene as the lights see it: depth alone, in cascades for a sun and in tiles of an atlas "
     "for other lights."},
    {"lighting", "Scene lighting",
     "What arrives at each pixel: direct light with shadows, light from around, and the share of "
     "that which is not hidden. "
     "Direct + ambient x share + emission is the lit image."},
    {"textures", "Mix with textures",
     "The light alone, as if every surface were white; the surfaces' own colour; and both "
     "together."},
    {"forward", "Forward and effects",
     "What a G-buffer cannot hold: mirrored surroundings, fog, and blended surfaces, over the lit "
     "image."},
    {"post", "Post-processing",
     "From linear radiance to a picture: glare, exposure, tone mapping, smooth edges."},
    {"present", "Present", "The frame as it is shown."},
    {"other", "Other passes", "Passes of the host or of views into the frame."},
};

struct Place {
    std::string_view prefix, section;
};
constexpr Place kPlaces[] = {
    {"gbuffer", "gbuffer"},     {"shadow", "lights"},     {"gtao", "lighting"},
    {"irradiance", "lighting"}, {"lighting", "lighting"}, {"pyramid", "forward"},
    {"reflections", "forward"}, {"fog", "forward"},       {"forward", "forward"},
    {"bloom", "post"},          {"luminance", "post"},    {"exposure", "post"},
    {"tonemap", "post"},        {"fxaa", "post"},         {"overlay", "present"},
};

}  // namespace

std::span<const BreakdownSection> breakdownSections() { return kSections; }

const char* breakdownSectionOf(std::string_view pass) {
    for (const Place& place : kPlaces)
        if (pass.starts_with(place.prefix))
            for (const BreakdownSection& section : kSections)
                if (section.id == place.section) return section.id;
    return "other";
}

}  // namespace rushlight
