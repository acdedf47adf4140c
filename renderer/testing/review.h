#pragma once
// Evidence that tests left behind, looked at again: what would change in the goldens, and the
// change itself, where asked for.

#include "renderer/testing/evidence.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rushlight::golden {

enum class Change : uint8_t {
    none,      ///< the golden has these pixels
    changed,   ///< it would have others
    added,     ///< it would be new
    outdated,  ///< the golden is not what the frame was judged by, nor what was rendered
    disputed,  ///< another test has another picture for the same golden
};
const char* toText(Change change);

struct Review {
    Evidence evidence;
    Change change = Change::none;
    std::optional<Figures> figures;  ///< the golden against what was rendered; none where they
                                     ///< cannot be compared
    std::string problem;             ///< a sentence where something is to be said
};

/// All evidence in a folder and below, by name. Errors: there is none (badInput), or a file of it
/// cannot be read.
Result<std::vector<Review>> reviewEvidence(const std::string& folder);

/// Makes what was rendered the golden, whole or not at all. Does nothing for Change::none; an Error
/// for what is outdated or disputed, and where the golden has changed since the review.
Result<void> accept(const Review& review);

/// A page in `folder`, which holds the evidence, with the pictures before, after and their
/// difference.
std::string reviewPage(std::span<const Review> reviews, const std::string& folder);

}  // namespace rushlight::golden
