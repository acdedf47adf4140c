// rushlight diagnose: why a frame is black, white or empty.
#include "renderer/answers/diagnose.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/render_setup.h"
#include "sandbox/tool/stats.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace rushlight::tool {
namespace {

using nlohmann::ordered_json;

struct DiagnoseArguments {
    RenderOptions render;
    std::string json;
};

ordered_json describe(const Diagnosis& diagnosis) {
    const FrameLook& look = diagnosis.look;
    ordered_json json = {{"version", 1},
                         {"frame", look.name()},
                         {"drawn", look.drawn},
                         {"brightest_code", look.brightest},
                         {"typical_luminance", look.typical},
                         {"findings", ordered_json::array()}};
    for (const Finding& finding : diagnosis.findings)
        json["findings"].push_back({{"cause", toText(finding.cause)},
                                    {"score", finding.score},
                                    {"evidence", finding.evidence},
                                    {"suggestion", finding.suggestion}});
    return json;
}

void print(const Diagnosis& diagnosis) {
    const FrameLook& look = diagnosis.look;
    if (diagnosis.isFine()) {
        std::printf(
            "The frame is fine: objects cover %.1f %% of it, and one pixel in a hundred is "
            "brighter "
            "than %d of 255.\n",
            double(look.drawn) * 100, look.brightest);
        return;
    }
    const bool refused = look.drawn == 0 && diagnosis.findings[0].score == 1;
    std::printf("The frame is %s. What may be the cause, the surest first:\n",
                refused ? "not drawn" : look.name());
    int rank = 0;
    for (const Finding& finding : diagnosis.findings)
        std::printf("\n%d. %s (%.2f)\n   %s\n   -> %s\n", ++rank, toText(finding.cause),
                    double(finding.score), finding.evidence.c_str(), finding.suggestion.c_str());
}

Result<int> runDiagnose(const DiagnoseArguments& arguments) {
    if (!arguments.render.stats.empty())
        return fail("--stats",
                    "diagnose renders many frames and writes no statistics; use capture.",
                    ErrorKind::wrongUse);
    auto setup = RenderSetup::open(arguments.render, false);
    if (!setup) return tl::unexpected(setup.error());
    const Diagnosis diagnosis = diagnose((*setup)->renderer(), (*setup)->frame(),
                                         arguments.render.size);
    if (!arguments.json.empty())
        if (auto written = writeJson(arguments.json, describe(diagnosis)); !written)
            return tl::unexpected(written.error());
    print(diagnosis);
    return diagnosis.isFine() ? kSuccess : kCauseFound;
}

}  // namespace

void addDiagnose(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<DiagnoseArguments>();
    CLI::App* command = app.add_subcommand(
        "diagnose", "Say why a frame is black, white or empty; exit code 1 when a cause is found");
    addRenderOptions(*command, arguments->render);
    command->add_option("--json", arguments->json, "Write the findings into this file too");
    command->callback(
        [&action, arguments] { action = [arguments] { return runDiagnose(*arguments); }; });
}

}  // namespace rushlight::tool
