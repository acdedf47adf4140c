#include "renderer/testing/review.h"

#include "renderer/capture/image_files.h"
#include "renderer/capture/write_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace rushlight::golden {
namespace {

namespace fs = std::filesystem;

Result<std::vector<std::string>> findEvidence(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error))
        if (at->path().filename() == kEvidenceFile)
            found.push_back(fs::absolute(at->path()).parent_path().lexically_normal().string());
    if (error) return fail(folder, "The folder could not be read (" + error.message() + ").");
    if (found.empty())
        return fail(folder,
                    "No test has left evidence here; tests do so where a frame is not as its "
                    "golden picture, "
                    "or in any case with RUSHLIGHT_EVIDENCE_ALWAYS=1.");
    std::ranges::sort(found);
    return found;
}

/// Compares the golden as it is now with what was rendered.
Result<void> compare(Review& review) {
    const auto golden = loadPicture(review.evidence.golden);
    if (!golden) return tl::unexpected(golden.error());
    const auto actual = loadPicture(review.evidence.actual);
    if (!actual) return tl::unexpected(actual.error());
    const auto comparison = comparePictures(*golden, *actual, "the golden picture", "The frame");
    review.change = Change::changed;
    if (!comparison) {
        review.problem = comparison.error().message;
        return {};
    }
    review.figures = figuresOf(*comparison, review.evidence.linear);
    if (review.figures->changedPixels == 0) review.change = Change::none;
    return {};
}

Result<Review> reviewOf(const std::string& folder) {
    auto evidence = readEvidence(folder);
    if (!evidence) return tl::unexpected(evidence.error());
    Review review{std::move(*evidence), Change::none, {}, {}};
    const auto hash = hashOfFile(review.evidence.golden);
    if (!hash) return tl::unexpected(hash.error());
    if (hash->empty()) {
        review.change = Change::added;
    } else if (auto compared = compare(review); !compared) {
        return tl::unexpected(compared.error());
    }
    if (review.change == Change::none || *hash == review.evidence.goldenHash) return review;
    review.change = Change::outdated;
    review.problem = "The golden has changed since the frame was judged; run the test again.";
    return review;
}

Result<void> markDisputed(std::vector<Review>& reviews) {
    for (size_t a = 0; a < reviews.size(); ++a)
        for (size_t b = a + 1; b < reviews.size(); ++b) {
            if (reviews[a].evidence.golden != reviews[b].evidence.golden) continue;
            const auto hashA = hashOfFile(reviews[a].evidence.actual);
            const auto hashB = hashOfFile(reviews[b].evidence.actual);
            if (!hashA || !hashB) return tl::unexpected((hashA ? hashB : hashA).error());
            if (*hashA == *hashB) continue;
            const auto dispute = [](Review& review, const Review& other) {
                review.change = Change::disputed;
                review.problem =
                    "\"" + other.evidence.name +
                    "\" has another picture for this golden; review the one to be accepted alone.";
            };
            dispute(reviews[a], reviews[b]);
            dispute(reviews[b], reviews[a]);
        }
    return {};
}

}  // namespace

const char* toText(Change change) {
    switch (change) {
        case Change::none: return "the same";
        case Change::changed: return "changed";
        case Change::added: return "new";
        case Change::outdated: return "outdated";
        case Change::disputed: return "disputed";
    }
    return "";
}

Result<std::vector<Review>> reviewEvidence(const std::string& folder) {
    const auto folders = findEvidence(folder);
    if (!folders) return tl::unexpected(folders.error());
    std::vector<Review> reviews;
    for (const std::string& found : *folders) {
        auto review = reviewOf(found);
        if (!review) return tl::unexpected(review.error());
        reviews.push_back(std::move(*review));
    }
    if (auto marked = markDisputed(reviews); !marked) return tl::unexpected(marked.error());
    return reviews;
}

Result<void> accept(const Review& review) {
    const Evidence& evidence = review.evidence;
    if (review.change == Change::none) return {};
    if (review.change == Change::outdated || review.change == Change::disputed)
        return fail(evidence.name, review.problem);
    const auto hash = hashOfFile(evidence.golden);
    if (!hash) return tl::unexpected(hash.error());
    if (*hash != evidence.goldenHash)
        return fail(evidence.golden,
                    "The golden has changed since it was reviewed; run the test again.");
    if (const auto picture = loadPicture(evidence.actual); !picture)
        return tl::unexpected(picture.error());
    const auto bytes = readFile(evidence.actual);
    if (!bytes) return tl::unexpected(bytes.error());
    return writeFile(evidence.golden, *bytes);
}

}  // namespace rushlight::golden
