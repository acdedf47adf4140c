#include "renderer/capture/image_files.h"
#include "renderer/testing/verdict.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/frame_runner.h"
#include "sandbox/tool/options.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

namespace rushlight::tool {
namespace {

using namespace golden;

struct CheckArguments {
    RenderOptions render;
    std::string golden;
    std::optional<double> maxFlip, minPsnr, minSsim, maxError;
    bool exact = false;
    EvidenceOptions evidence;
};

Near nearOf(const CheckArguments& arguments) {
    Near near{arguments.golden, {}};
    if (arguments.maxFlip) near.criteria.push_back(flip(*arguments.maxFlip));
    if (arguments.minPsnr) near.criteria.push_back(psnr(*arguments.minPsnr));
    if (arguments.minSsim) near.criteria.push_back(ssim(*arguments.minSsim));
    if (arguments.maxError) near.criteria.push_back(golden::maxError(*arguments.maxError));
    if (arguments.exact || near.criteria.empty()) near.criteria.push_back(golden::exact());
    return near;
}

Result<Frame> renderTheFrame(RenderSetup& setup, const CheckArguments& arguments) {
    const uvec2 size = arguments.render.size;
    const FrameInput input = setup.frame();
    const bool linear = *imageFormatOf(arguments.golden) == ImageFormat::exr;
    const CaptureKind kind = linear ? CaptureKind::hdr : CaptureKind::display;
    FrameTimes times;
    Frame frame;
    for (uint32_t i = 0; i <= arguments.render.warmup; ++i) {
        auto image = tool::renderFrame(setup, input, size, kind, {}, times);
        if (!image) return tl::unexpected(image.error());
        frame.image = std::move(*image);
    }
    if (!arguments.render.stats.empty()) {
        const auto json = statsJson(setup, size, times.wallMs, setup.renderer().report(), times);
        if (auto ok = writeJson(arguments.render.stats, json); !ok)
            return tl::unexpected(ok.error());
    }
    frame.takeApart = [&setup, input, size, &arguments] {
        auto breakdown = takeBreakdown(setup.renderer(), input, {size.x, size.y, {}});
        if (breakdown)
            breakdown->title = std::filesystem::path(arguments.render.scene).filename().string();
        return breakdown;
    };
    return frame;
}

Result<int> check(const CheckArguments& arguments) {
    const auto format = imageFormatOf(arguments.golden);
    if (!format) return tl::unexpected(format.error());
    if (*format == ImageFormat::jpeg)
        return fail(arguments.golden, "A golden picture is a .png, or an .exr for linear pictures.",
                    ErrorKind::wrongUse);
    auto setup = RenderSetup::open(arguments.render, false);
    if (!setup) return tl::unexpected(setup.error());
    const auto frame = renderTheFrame(**setup, arguments);
    if (!frame) return tl::unexpected(frame.error());
    const auto verdict = judge(*frame, nearOf(arguments), arguments.evidence);
    if (!verdict) return tl::unexpected(verdict.error());
    std::fputs(verdict->text().c_str(), stdout);
    return verdict->passed ? kSuccess : kComparisonFailed;
}

void addCriteria(CLI::App& command, CheckArguments& arguments) {
    const auto addLimit = [&](const char* name, std::optional<double>& limit, const char* help) {
        command.add_option(name, limit, help)->check(finiteNumber());
    };
    addLimit("--flip", arguments.maxFlip, "The mean FLIP error may be this (0 to 1)");
    addLimit("--psnr", arguments.minPsnr, "The PSNR must be this (dB)");
    addLimit("--ssim", arguments.minSsim, "The structural similarity must be this (-1 to 1)");
    addLimit("--max-error", arguments.maxError,
             "A value may differ by this (8 bit pictures: 0 to 1)");
    command.add_flag("--exact", arguments.exact,
                     "No pixel may differ; so too where there is no other limit");
}

}  // namespace

void addCheck(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand(
        "check",
        "Render a scene and compare it with its golden picture; exit with 1 where it differs");
    addRenderOptions(*command, arguments->render);
    command
        ->add_option("--golden", arguments->golden,
                     "The golden picture: .png (tone mapped) or .exr (linear)")
        ->required();
    addCriteria(*command, *arguments);
    command->add_option("--evidence", arguments->evidence.folder,
                        "Where a frame that differs is left behind: pictures, heat map, breakdown "
                        "(RUSHLIGHT_EVIDENCE, or rushlight-evidence)");
    command->add_option("--name", arguments->evidence.name,
                        "Its folder in there (the golden's name)");
    command->add_flag("--always", arguments->evidence.always,
                      "Leave it behind where it does not differ, too");
    command->add_flag("--no-breakdown{false}", arguments->evidence.breakdown,
                      "Leave no breakdown behind, which takes some seconds");
    // Options of a scene's own file come after those of all scenes, and count.
    for (CLI::Option* option : command->get_options())
        if (option->get_items_expected_max() == 1) option->take_last();
    command->callback([&action, arguments] {
        if (arguments->evidence.folder.empty() && !std::getenv("RUSHLIGHT_EVIDENCE"))
            arguments->evidence.folder = "rushlight-evidence";
        action = [arguments] { return check(*arguments); };
    });
}

}  // namespace rushlight::tool
