#include "renderer/testing/review.h"

#include "renderer/capture/write_file.h"
#include "sandbox/tool/command.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace rushlight::tool {
namespace {

using namespace golden;

struct GoldensArguments {
    std::string evidence;
    bool accept = false;
    std::vector<std::string> only;
};

void print(const Review& review, const char* done) {
    std::printf("%-40s %s", review.evidence.name.c_str(), toText(review.change));
    if (review.figures && review.change != Change::none)
        std::printf(": flip %.5f, psnr %.1f dB, %llu of %llu pixels", review.figures->flip,
                    review.figures->psnr,
                    static_cast<unsigned long long>(review.figures->changedPixels),
                    static_cast<unsigned long long>(review.figures->pixels));
    if (!review.problem.empty()) std::printf(": %s", review.problem.c_str());
    std::printf("%s\n", done);
}

/// The evidence that was named, all of it where none was.
Result<void> select(std::vector<Review>& reviews, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::none_of(reviews, [&](const Review& r) { return r.evidence.name == name; }))
            return fail("--only " + name, "There is no evidence of this name.",
                        ErrorKind::wrongUse);
    if (names.empty()) return {};
    std::erase_if(reviews, [&](const Review& r) {
        return std::ranges::find(names, r.evidence.name) == names.end();
    });
    return {};
}

Result<int> goldens(const GoldensArguments& arguments) {
    auto reviews = reviewEvidence(arguments.evidence);
    if (!reviews) return tl::unexpected(reviews.error());
    if (auto ok = select(*reviews, arguments.only); !ok) return tl::unexpected(ok.error());
    const std::string page = arguments.evidence + "/index.html";
    if (auto ok = writeFile(page, reviewPage(*reviews, arguments.evidence)); !ok)
        return tl::unexpected(ok.error());
    size_t changes = 0, refused = 0;
    for (const Review& review : *reviews) {
        const bool changesGolden = review.change != Change::none;
        const auto accepted = arguments.accept ? accept(review) : Result<void>();
        changes += changesGolden;
        refused += !accepted;
        print(review, arguments.accept && changesGolden && accepted ? ": accepted" : "");
        if (!accepted) printError(accepted.error());
    }
    std::printf("before, after and difference: %s\n", page.c_str());
    if (changes && !arguments.accept)
        std::printf(
            "nothing was changed; to make these pictures the goldens: rushlight goldens \"%s\" "
            "--accept\n",
            arguments.evidence.c_str());
    return refused ? exitCode(ErrorKind::badInput) : kSuccess;
}

}  // namespace

void addGoldens(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<GoldensArguments>();
    CLI::App* command = app.add_subcommand("goldens",
                                           "What tests left behind: how the golden pictures would "
                                           "change; and, with --accept, change them");
    command
        ->add_option("EVIDENCE", arguments->evidence,
                     "The folder where tests left it, or that of one test; gets a page, index.html")
        ->required();
    command->add_flag(
        "--accept", arguments->accept,
        "Make what was rendered the golden pictures; those that are the same are not touched");
    command->add_option("--only", arguments->only,
                        "Of these tests alone, by the names that are listed");
    command->callback(
        [&action, arguments] { action = [arguments] { return goldens(*arguments); }; });
}

}  // namespace rushlight::tool
