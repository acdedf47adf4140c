#include "renderer/replay/replay.h"
#include "renderer/backend/gl/gl_device.h"
#include "renderer/capture/image_files.h"
#include "renderer/replay/texel_picture.h"
#include "renderer/rhi/saved/frame_diff.h"
#include "renderer/rhi/saved/frame_file.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/options.h"
#include "sandbox/viewer/program_files.h"

#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

namespace rushlight::tool {
namespace {

struct ReplayArguments {
    std::string frame, output;
    std::vector<std::string> diff;
    ContextChoice context = ContextChoice::automatic;
    std::optional<uint32_t> until;
    bool list = false;
    bool hashes = false;
};

Result<SavedFrame> loadFrame(const std::string& path) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file) return fail(path, "The file cannot be read.");
    std::vector<std::byte> bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    bytes.resize(size_t(file.gcount()));
    return decodeFrame(std::move(bytes), path);
}

Result<int> diff(const ReplayArguments& arguments) {
    const auto a = loadFrame(arguments.diff[0]);
    if (!a) return tl::unexpected(a.error());
    const auto b = loadFrame(arguments.diff[1]);
    if (!b) return tl::unexpected(b.error());
    const std::vector<std::string> lines = diffFrames(*a, *b);
    for (const std::string& line : lines) std::printf("%s\n", line.c_str());
    return lines.empty() ? kSuccess : kComparisonFailed;
}

TexelPicture pictureFor(ImageFormat format, const ReadbackImage& image, const FrameReplay& replay,
                        bool stopped) {
    TexelPicture exact = exactPicture(image, replay.topRowFirst());
    // The end of the frame is written as capture wrote it; what is on the way, so that it can be
    // seen.
    const bool eightBit = format != ImageFormat::exr;
    if (!eightBit || (!stopped && !exact.rgba8.empty())) return exact;
    return visiblePicture(image, replay.topRowFirst());
}

/// Errors of the replay name an object of the frame; this puts the file before it.
template <class T>
Result<T> ofFile(const std::string& path, Result<T> result) {
    if (!result) result.error().object = path + ": " + result.error().object;
    return result;
}

Result<int> draw(const ReplayArguments& arguments, const SavedFrame& frame) {
    const auto context = createOffscreenContext(arguments.context, {});
    if (!context) return tl::unexpected(context.error());
    GlDeviceDesc desc;
    desc.load = (*context)->loader();
    desc.cacheDirectory = userCacheDirectory();
    const auto device = createGlDevice(desc);
    if (!device) return tl::unexpected(device.error());
    const auto replay = ofFile(arguments.frame, FrameReplay::create(**device, frame));
    if (!replay) return tl::unexpected(replay.error());
    ReplayOptions options;
    options.hashAttachments = arguments.hashes;
    options.until = arguments.until.value_or(~0u);
    const auto image = ofFile(arguments.frame, (*replay)->run(options));
    if (!image) return tl::unexpected(image.error());
    for (const AttachmentHash& line : (*replay)->hashes())
        std::printf("%s %s %016" PRIx64 "\n", line.pass.c_str(), line.image.c_str(), line.hash);
    if (arguments.output.empty()) return kSuccess;
    const auto format = imageFormatOf(arguments.output);
    const TexelPicture picture = pictureFor(*format, *image, **replay, arguments.until.has_value());
    if (auto saved = saveImage(arguments.output, PictureView(picture)); !saved)
        return tl::unexpected(saved.error());
    return kSuccess;
}

Result<int> replay(const ReplayArguments& arguments) {
    if (!arguments.diff.empty()) return diff(arguments);
    if (arguments.frame.empty())
        return fail("command line",
                    "Name a frame (.rlf), or two with --diff; see rushlight replay --help.",
                    ErrorKind::wrongUse);
    if (arguments.output.empty() && !arguments.list && !arguments.hashes)
        return fail("command line", "Say what to do: -o FILE, --list, --hashes or --diff.",
                    ErrorKind::wrongUse);
    if (!arguments.output.empty())
        if (auto format = imageFormatOf(arguments.output); !format)
            return tl::unexpected(format.error());
    const auto frame = loadFrame(arguments.frame);
    if (!frame) return tl::unexpected(frame.error());
    if (arguments.list) std::fputs(printNumbered(frame->commands, *frame).c_str(), stdout);
    if (arguments.output.empty() && !arguments.hashes) return kSuccess;
    return draw(arguments, *frame);
}

}  // namespace

void addReplay(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<ReplayArguments>();
    CLI::App* command = app.add_subcommand(
        "replay", "Draw a saved frame again, without its scene; list or compare its commands");
    CLI::Option* frame = command->add_option("FRAME", arguments->frame,
                                             "An .rlf file, of capture --save-frame");
    CLI::Option* output = command->add_option(
        "-o,--output", arguments->output,
        ".png or .jpg; .exr for frames that were captured linear");
    addContextOption(*command, arguments->context);
    command
        ->add_option("--until", arguments->until,
                     "Execute the first N commands only; the picture is the first target of the "
                     "pass in which that ends")
        ->check(CLI::Range(1u, ~0u))
        ->needs(output);
    CLI::Option* list = command->add_flag("--list", arguments->list,
                                          "Print the commands with their numbers");
    CLI::Option* hashes = command->add_flag(
        "--hashes", arguments->hashes, "Print a `pass attachment hash` line for all that is drawn");
    command
        ->add_option("--diff", arguments->diff,
                     "Two .rlf files: print what is different; exit with 1 when something is")
        ->expected(2)
        ->excludes(frame)
        ->excludes(output)
        ->excludes(list)
        ->excludes(hashes);
    command->callback(
        [&action, arguments] { action = [arguments] { return replay(*arguments); }; });
}

}  // namespace rushlight::tool
