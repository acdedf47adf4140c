#include "renderer/capture/breakdown/breakdown.h"

#include "renderer/capture/breakdown/breakdown_pictures.h"
#include "renderer/passes/post/tonemap_pass.h"

#include <algorithm>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint32_t kWarmFrames = 2;
constexpr uint32_t kLargestPicture = 2048;

struct ViewOfFrame {
    DebugView show;
    const char* section;
    const char* title;
    Readout readout;
    const char* note;
    float high = 1;
};

// Drawn as they are shown.
constexpr ViewOfFrame kViews[] = {
    {DebugView::baseColor, "gbuffer", "Base colour", Readout::color, "sRGB."},
    {DebugView::metallic, "gbuffer", "Metallic", Readout::unit, ""},
    {DebugView::roughness, "gbuffer", "Roughness", Readout::unit, "Perceptual; white is rough."},
    {DebugView::normal, "gbuffer", "Normals", Readout::direction,
     "World axes: x red, y green, z blue."},
    {DebugView::emissive, "gbuffer", "Emission", Readout::color, "Tone mapped, before exposure."},
    {DebugView::occlusion, "gbuffer", "Occlusion of materials", Readout::unit, ""},
    {DebugView::velocity, "gbuffer", "Velocity", Readout::velocity,
     "Grey is rest; red to the right, green up."},
    {DebugView::overdraw, "gbuffer", "Overdraw", Readout::count,
     "How often the G-buffer was written at a pixel.", 8},
    {DebugView::clusters, "lighting", "Light clusters", Readout::count,
     "Lights in the list of each pixel's froxel.", 32},
    {DebugView::ambientOcclusion, "lighting", "Ambient occlusion of the screen", Readout::unit,
     "White where light from around is open."},
};

// Drawn as radiance, and shown with the frame's own exposure.
constexpr ViewOfFrame kParts[] = {
    {DebugView::direct, "lighting", "Direct light", Readout::color,
     "Suns and lamps, with their shadows."},
    {DebugView::ambient, "lighting", "Ambient light, unhidden", Readout::color,
     "From around, if nothing hid it."},
    {DebugView::ambientShare, "lighting", "Share of ambient light", Readout::color,
     "What occlusion leaves of it, by channel: white is all."},
    {DebugView::emission, "lighting", "Emission and background", Readout::color,
     "What glows by itself, unlit surfaces, and what is behind the scene."},
    {DebugView::untextured, "textures", "Light on white", Readout::color,
     "All lighting, as if every surface were white and not metallic."},
};

class Taker {
public:
    Taker(Renderer& renderer, const FrameInput& input, const BreakdownOptions& options)
        : renderer_(renderer), input_(input), options_(options) {
        input_.settings.debugView = DebugView::none;
    }

    Result<Breakdown> take() {
        Result<void> step = warmUp();
        if (step) step = measure();
        if (step) step = views();
        if (step) step = culling();
        if (!step) return tl::unexpected(step.error());
        return std::move(out_);
    }

private:
    uint32_t frameCount() const {
        return kWarmFrames + 1 + uint32_t(std::size(kViews) + std::size(kParts)) + 3;
    }

    Result<void> draw(const FrameInput& input, CaptureKind kind, const FrameOptions& options,
                      CapturedImage& image) {
        const auto ticket = renderer_.renderOffscreen(input, options_.width, options_.height, kind,
                                                      options);
        if (!ticket) return tl::unexpected(ticket.error());
        renderer_.finish();
        if (!renderer_.takeCapture(*ticket, true, image))
            return fail("breakdown", "the context was lost.", ErrorKind::noContext);
        if (options_.progress) options_.progress(++drawn_, frameCount());
        return {};
    }

    Result<void> warmUp() {
        input_.settings.shadowCaching = false;
        CapturedImage image;
        for (uint32_t i = 0; i < kWarmFrames; ++i)
            if (auto ok = draw(input_, CaptureKind::display, {}, image); !ok) return ok;
        return {};
    }

    Result<void> measure() {
        FrameOptions options;
        options.hashPasses = options.keepImages = true;
        if (auto ok = draw(input_, CaptureKind::display, options, frame_); !ok) return ok;
        out_.report = renderer_.report();
        out_.commands = renderer_.printLabelledCommands();
        if (auto ok = setRules(); !ok) return ok;
        std::vector<PassReport>& passes = out_.report.passes;
        for (size_t p = 0; p < passes.size(); ++p)
            for (size_t i = 0; i < passes[p].images.size(); ++i)
                addImage(passes[p], int(p), int(i));
        add(pictureOf("present", "frame", "The frame", ""), frame_);
        input_.settings.shadowCaching = true;  // what follows looks into the same frame
        return {};
    }

    Result<void> setRules() {
        const auto camera = makeCamera(input_.view, float(options_.width) / float(options_.height));
        if (!camera) return tl::unexpected(camera.error());
        rules_ = {exposureFactor(input_.settings), input_.settings.toneMap, camera->depthDecode,
                  camera->perspective};
        if (!input_.settings.autoExposure) return {};
        for (const PassReport& pass : out_.report.passes)
            for (const PassImage& image : pass.images)
                if (std::string_view(image.name) == "exposure" &&
                    image.texels.size() == sizeof(float))
                    std::memcpy(&rules_.exposure, image.texels.data(), sizeof(float));
        return {};
    }

    void addImage(PassReport& pass, int passIndex, int imageIndex) {
        PassImage& image = pass.images[size_t(imageIndex)];
        BreakdownPicture picture;
        picture.section = breakdownSectionOf(pass.name);
        picture.pass = passIndex;
        picture.image = imageIndex;
        picture.name = std::string(pass.name) + "." + image.name;
        picture.title = image.name;
        if (std::string_view(image.name) == "shadow-map")
            picture.title += ", layer " + std::to_string(image.layer);
        if (!image.texels.empty()) {
            fillPicture(picture, image, rules_);
            finish(std::move(picture));
        }
        std::vector<std::byte>().swap(image.texels);
    }

    void add(BreakdownPicture picture, CapturedImage& image) {
        picture.width = image.width;
        picture.height = image.height;
        picture.rgba8 = image.rgba8;
        for (size_t i = 3; i < picture.rgba8.size(); i += 4) picture.rgba8[i] = 255;
        finish(std::move(picture));
    }

    void finish(BreakdownPicture&& picture) {
        shrinkPicture(picture.width, picture.height, picture.rgba8, kLargestPicture);
        out_.pictures.push_back(std::move(picture));
    }

    static BreakdownPicture pictureOf(const char* section, std::string name, const char* title,
                                      const char* note) {
        BreakdownPicture picture;
        picture.section = section;
        picture.name = std::move(name);
        picture.title = title;
        picture.note = note;
        return picture;
    }

    static BreakdownPicture named(const ViewOfFrame& view) {
        BreakdownPicture picture = pictureOf(view.section, std::string("view.") + toText(view.show),
                                             view.title, view.note);
        picture.readout = view.readout;
        picture.high = view.high;
        picture.exact = view.readout != Readout::color;
        return picture;
    }

    Result<void> views() {
        CapturedImage image;
        FrameInput input = input_;
        for (const ViewOfFrame& view : kViews) {
            input.settings.debugView = view.show;
            if (auto ok = draw(input, CaptureKind::display, {.timers = false}, image); !ok)
                return ok;
            add(named(view), image);
        }
        for (const ViewOfFrame& part : kParts) {
            input.settings.debugView = part.show;
            if (auto ok = draw(input, CaptureKind::hdr, {.timers = false}, image); !ok) return ok;
            image.rgba8 = part.show == DebugView::ambientShare
                              ? factorPicture(image.rgba32f)
                              : displayedRadiance(image.rgba32f, rules_);
            add(named(part), image);
        }
        return {};
    }

    Result<void> culling() {
        FrameInput input = input_;
        input.settings.debugView = DebugView::bounds;
        CapturedImage visible, unhidden, all;
        if (auto ok = draw(input, CaptureKind::display, {.timers = false}, visible); !ok) return ok;
        input.settings.occlusionCulling = false;
        if (auto ok = draw(input, CaptureKind::display, {.timers = false}, unhidden); !ok)
            return ok;
        input.settings.smallObjectPixels = 0;
        if (auto ok = draw(input, CaptureKind::display, {.timers = false}, all); !ok) return ok;
        unhidden.rgba8 = culledPicture(frame_.rgba8, visible.rgba8, unhidden.rgba8, all.rgba8);
        add(pictureOf(
                "culling", "view.culled", "Boxes by what became of them",
                "Green is drawn, red is hidden behind others, yellow is too small; what is outside "
                "of the view is not to be seen."),
            unhidden);
        return {};
    }

    Renderer& renderer_;
    FrameInput input_;
    const BreakdownOptions& options_;
    Breakdown out_;
    CapturedImage frame_;
    PictureRules rules_;
    uint32_t drawn_ = 0;
};

}  // namespace

Result<Breakdown> takeBreakdown(Renderer& renderer, const FrameInput& input,
                                const BreakdownOptions& options) {
    return Taker(renderer, input, options).take();
}

}  // namespace rushlight
