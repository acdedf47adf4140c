// rushlight explain: what makes a pixel.
#include "sandbox/tool/command.h"
#include "sandbox/tool/explain_text.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/stats.h"

#include <charconv>
#include <memory>

namespace rushlight::tool {
namespace {

struct ExplainArguments {
    RenderOptions render;
    uvec2 pixel{0};
    std::string json;
};

uvec2 parsePixel(const std::string& text) {
    uvec2 pixel(0);
    const char* end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, pixel.x);
    if (x.ec == std::errc() && x.ptr != end && *x.ptr == ',') {
        const auto y = std::from_chars(x.ptr + 1, end, pixel.y);
        if (y.ec == std::errc() && y.ptr == end) return pixel;
    }
    throw CLI::ValidationError("PIXEL",
                               "\"" + text + "\" is no pixel; write X,Y from the top left");
}

Result<int> runExplain(const ExplainArguments& arguments) {
    const uvec2 size = arguments.render.size;
    if (!arguments.render.stats.empty())
        return fail("--stats", "explain renders many frames and writes no statistics; use capture.",
                    ErrorKind::wrongUse);
    if (arguments.pixel.x >= size.x || arguments.pixel.y >= size.y)
        return fail(
            "pixel " + std::to_string(arguments.pixel.x) + "," + std::to_string(arguments.pixel.y),
            "It is outside of the picture, which is " + std::to_string(size.x) + "x" +
                std::to_string(size.y) + "; change it or --size.",
            ErrorKind::wrongUse);
    auto setup = RenderSetup::open(arguments.render, false);
    if (!setup) return tl::unexpected(setup.error());
    const auto explained = explain((*setup)->renderer(), (*setup)->frame(), size,
                                   std::span(&arguments.pixel, 1));
    if (!explained) return tl::unexpected(explained.error());
    if (!arguments.json.empty())
        if (auto written = writeJson(arguments.json, explanationJson(explained->front(), **setup));
            !written)
            return tl::unexpected(written.error());
    printExplanation(explained->front(), **setup, size);
    return kSuccess;
}

}  // namespace

void addExplain(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<ExplainArguments>();
    CLI::App* command = app.add_subcommand(
        "explain",
        "Take a pixel apart: what is drawn, each light's share, and the way to the display");
    addRenderOptions(*command, arguments->render);
    command
        ->add_option_function<std::string>(
            "PIXEL", [arguments](const std::string& text) { arguments->pixel = parsePixel(text); },
            "X,Y from the top left")
        ->required();
    command->add_option("--json", arguments->json, "Write the explanation into this file too");
    command->callback(
        [&action, arguments] { action = [arguments] { return runExplain(*arguments); }; });
}

}  // namespace rushlight::tool
