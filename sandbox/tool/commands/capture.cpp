#include "renderer/capture/image_files.h"
#include "renderer/capture/write_file.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/frame_runner.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/output_names.h"
#include "sandbox/tool/progress.h"
#include "sandbox/tool/sequence/frame_key.h"
#include "sandbox/tool/sequence/sequence.h"
#include "sandbox/tool/trace_file.h"

#include <nlohmann/json.hpp>

#include <cinttypes>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

namespace rushlight::tool {
namespace {

struct CaptureArguments {
    RenderOptions render;
    std::string output;
    std::string pass;
    std::string saveFrame;
    std::string trace;
    bool hashes = false;
    std::optional<FrameRange> frames;
    SequenceOptions sequence;
};

std::optional<DebugView> findDebugView(const std::string& name) {
    for (uint8_t i = 0; i < uint8_t(DebugView::count); ++i)
        if (name == toText(DebugView(i))) return DebugView(i);
    return {};
}

std::string checkPassName(const std::string& name) {
    if (name == "all" || findDebugView(name)) return {};
    std::string message = "\"" + name + "\" is no pass; there are all";
    for (uint8_t i = 0; i < uint8_t(DebugView::count); ++i)
        message += std::string(", ") + toText(DebugView(i));
    return message;
}

void printHashes(const FrameReport& report) {
    for (const PassReport& pass : report.passes)
        for (size_t i = 0; i < pass.hashes.size() && i < pass.writes.size(); ++i)
            std::printf("%s %s %016" PRIx64 "\n", pass.name, pass.writes[i], pass.hashes[i]);
}

class Capture {
public:
    Capture(const CaptureArguments& arguments, RenderSetup& setup, TraceFile& trace)
        : arguments_(arguments), setup_(setup), trace_(trace) {}

    Result<void> warmUp();
    Result<void> sequence();
    Result<void> allPasses();
    Result<void> single() { return write(input(), arguments_.output); }
    Result<void> writeStats() const;

private:
    FrameInput input() const;
    Result<void> write(const FrameInput&, const std::string& path);
    Result<CapturedImage> render(const FrameInput&, CaptureKind, const FrameOptions&);

    const CaptureArguments& arguments_;
    RenderSetup& setup_;
    TraceFile& trace_;
    bool warmingUp_ = false;
    FrameTimes times_;
    double firstFrameMs_ = -1;
    std::optional<SequenceCounts> sequence_;
};

FrameInput Capture::input() const {
    FrameInput input = setup_.frame();
    input.settings.deltaTime = 1 / arguments_.sequence.framesPerSecond;
    if (const auto shown = findDebugView(arguments_.pass)) input.settings.debugView = *shown;
    return input;
}

Result<CapturedImage> Capture::render(const FrameInput& frame, CaptureKind kind,
                                      const FrameOptions& options) {
    auto image = renderFrame(setup_, frame, arguments_.render.size, kind, options, times_);
    if (firstFrameMs_ < 0) firstFrameMs_ = times_.wallMs;
    if (image) trace_.add(setup_.renderer().report(), times_, warmingUp_);
    return image;
}

Result<void> Capture::warmUp() {
    warmingUp_ = true;
    for (uint32_t i = 0; i < arguments_.render.warmup; ++i)
        if (auto image = render(input(), CaptureKind::display, {}); !image)
            return tl::unexpected(image.error());
    warmingUp_ = false;
    return {};
}

Result<void> Capture::write(const FrameInput& frame, const std::string& path) {
    const auto format = imageFormatOf(path);
    if (!format) return tl::unexpected(format.error());
    const CaptureKind kind = *format == ImageFormat::exr ? CaptureKind::hdr : CaptureKind::display;
    std::vector<std::byte> saved;
    FrameOptions options;
    options.hashPasses = arguments_.hashes;
    if (!arguments_.saveFrame.empty()) options.savedFrame = &saved;
    const auto image = render(frame, kind, options);
    if (!image) return tl::unexpected(image.error());
    if (options.savedFrame)
        if (auto written = writeFile(arguments_.saveFrame, saved); !written) return written;
    if (arguments_.hashes) printHashes(setup_.renderer().report());
    return saveImage(path, PictureView(*image), arguments_.sequence.effort);
}

Result<void> Capture::allPasses() {
    const Progress progress("picture");
    for (uint8_t i = 0; i < uint8_t(DebugView::count); ++i) {
        FrameInput frame = input();
        frame.settings.debugView = DebugView(i);
        const std::string path = arguments_.output + "/" + toText(DebugView(i)) + ".png";
        if (auto written = write(frame, path); !written) return written;
        progress.show(i + 1u, uint32_t(DebugView::count));
    }
    return {};
}

Result<void> Capture::sequence() {
    Sequence sequence(arguments_.sequence, setup_, [this] { return input(); });
    FrameOptions options;
    options.hashPasses = arguments_.hashes;
    const auto counts = sequence.run(options, [&](const FrameReport& report) {
        trace_.add(report, sequence.times(), false);
        if (arguments_.hashes) printHashes(report);
    });
    if (!counts) return tl::unexpected(counts.error());
    sequence_ = *counts;
    times_ = sequence.times();
    if (firstFrameMs_ < 0) firstFrameMs_ = sequence.firstFrameMs();
    return {};
}

Result<void> Capture::writeStats() const {
    if (arguments_.render.stats.empty()) return {};
    auto json = statsJson(setup_, arguments_.render.size, firstFrameMs_, setup_.renderer().report(),
                          times_);
    if (sequence_)
        json["sequence"] = {{"rendered", sequence_->rendered},
                            {"kept", sequence_->kept},
                            {"writer_waits", sequence_->writerWaits},
                            {"seconds", sequence_->seconds}};
    return writeJson(arguments_.render.stats, json);
}

/// What can be known to be wrong before anything is loaded.
Result<void> checkOutput(const CaptureArguments& arguments) {
    if (arguments.pass == "all" && !arguments.saveFrame.empty())
        return fail("--save-frame", "It saves one frame; --pass all draws several.",
                    ErrorKind::wrongUse);
    if (arguments.pass == "all") return {};
    const std::string& output = arguments.output;
    if (auto format = imageFormatOf(output); !format) return tl::unexpected(format.error());
    if (!arguments.frames) return {};
    if (auto name = frameFileName(output, 0); !name) return tl::unexpected(name.error());
    return {};
}

Result<int> capture(const CaptureArguments& arguments) {
    if (auto checked = checkOutput(arguments); !checked) return tl::unexpected(checked.error());
    TraceFile trace(arguments.trace);
    if (auto checked = trace.check(); !checked) return tl::unexpected(checked.error());
    auto setup = RenderSetup::open(arguments.render, false);
    if (!setup) return tl::unexpected(setup.error());
    Capture capturing(arguments, **setup, trace);
    Result<void> step = capturing.warmUp();
    if (step && arguments.pass == "all")
        step = capturing.allPasses();
    else if (step)
        step = arguments.frames ? capturing.sequence() : capturing.single();
    if (step) step = capturing.writeStats();
    step = trace.finish(std::move(step), **setup);
    if (!step) return tl::unexpected(step.error());
    return kSuccess;
}

void prepareSequence(const CLI::App& command, CaptureArguments& arguments) {
    SequenceOptions& sequence = arguments.sequence;
    sequence.output = arguments.output;
    sequence.frames = *arguments.frames;
    sequence.size = arguments.render.size;
    sequence.startTime = arguments.render.time;
    sequence.key = frameKey(
        command, arguments.render,
        {"--output", "--frames", "--shard", "--resume", "--no-write", "--warmup", "--threads",
         "--context", "--stats", "--trace", "--hashes", "--strict"});
}

void addSequenceOptions(CLI::App& command, CLI::Option& frames, SequenceOptions& sequence) {
    command.add_option("--fps", sequence.framesPerSecond, "Frames a second of the sequence")
        ->check(finiteNumber())
        ->check(CLI::Range(0.01f, 100000.0f))
        ->capture_default_str()
        ->needs(&frames);
    command
        .add_option_function<std::string>(
            "--shard", [&sequence](const std::string& text) { sequence.shard = parseShard(text); },
            "I/N: only this part of the sequence")
        ->needs(&frames);
    command
        .add_flag("--resume", sequence.resume,
                  "Keep the frames that are there, whole and of the same scene and options")
        ->needs(&frames);
    command
        .add_flag("--no-write{false}", sequence.write,
                  "Draw and read back the frames, but write no file: what writing costs")
        ->needs(&frames);
}

}  // namespace

void addCapture(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<CaptureArguments>();
    CLI::App* command = app.add_subcommand("capture", "Render a scene offscreen into a picture");
    addRenderOptions(*command, arguments->render);
    command
        ->add_option("-o,--output", arguments->output,
                     ".png or .jpg (tone mapped), .exr (linear); shot_%04d.png with --frames; a "
                     "folder with --pass all")
        ->required();
    command
        ->add_option(
            "--compression", arguments->sequence.effort,
            "Of .png and .exr: none is the fastest for sequences, small the smallest (fast)")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, EncodeEffort>{{"none", EncodeEffort::none},
                                                {"fast", EncodeEffort::fast},
                                                {"small", EncodeEffort::small}}));
    CLI::Option* pass = command->add_option("--pass", arguments->pass,
                                            "Show the output of this pass instead of the frame; "
                                            "all writes each");
    pass->check(CLI::Validator(checkPassName, "NAME"));
    command->add_flag("--hashes", arguments->hashes,
                      "Print a `pass attachment hash` line for all that was drawn");
    CLI::Option* saveFrame = command->add_option(
        "--save-frame", arguments->saveFrame,
        "Also write the frame's commands and resources into this .rlf file, for replay");
    addTraceOption(*command, arguments->trace);
    CLI::Option* frames = command->add_option_function<std::string>(
        "--frames", [arguments](const std::string& text) { arguments->frames = parseFrames(text); },
        "A-B: a sequence of frames");
    frames->excludes(saveFrame);
    addSequenceOptions(*command, *frames, arguments->sequence);
    command->callback([&action, command, arguments] {
        action = [command, arguments] {
            if (arguments->frames) prepareSequence(*command, *arguments);
            return capture(*arguments);
        };
    });
}

}  // namespace rushlight::tool
