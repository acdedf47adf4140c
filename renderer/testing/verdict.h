#pragma once
// A frame against its golden picture: figures, limits, and what is left behind where they are not
// met.

#include "renderer/capture/compare/compare.h"
#include "renderer/testing/criteria.h"
#include "renderer/testing/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace rushlight::golden {

const char* toText(Measure measure);  ///< "flip", "psnr", "ssim", "max error", "changed pixels"

/// Two pictures of one size and kind, in numbers.
struct Figures {
    double flip = 0, psnr = 0, ssim = 1, maxError = 0;
    uint64_t changedPixels = 0;  ///< of 8 bit pictures those of other codes
    uint64_t pixels = 0;

    double of(Measure measure) const;
};
Figures figuresOf(const Comparison& comparison, bool linear);

/// Whether a value is within a criterion's limit; a value that is not a number is not.
bool meets(const Criterion& criterion, double value);

/// Where evidence goes: to `folder`/`name`. What an earlier verdict left there is replaced.
struct EvidenceOptions {
    std::string folder = {};  ///< empty: evidenceFolder()
    std::string name = {};    ///< empty: that of the golden without its extension
    bool always = false;      ///< also where the frame passes; so does RUSHLIGHT_EVIDENCE_ALWAYS=1
    bool breakdown = true;    ///< of a frame that is too far from its golden, where it can be taken
                              ///< apart
};

/// The environment's RUSHLIGHT_EVIDENCE, else `rushlight-evidence` beside the program that runs.
std::string evidenceFolder();

struct Verdict {
    bool passed = false;
    std::string golden;
    std::vector<Criterion> criteria;
    std::optional<Figures> figures;  ///< none where there is nothing to compare with
    std::string problem;             ///< then, why: a sentence
    std::string evidence;            ///< the folder that was written; empty: none
    std::string evidenceProblem;     ///< why evidence is not complete; empty: it is, or none was
                                     ///< wanted

    /// What a test says: each figure with its limit, what was left behind where, and how to accept
    /// it. Some lines.
    std::string text() const;
};

/// A golden that does not exist, or has another size or kind, is a verdict. An Error: the golden is
/// there and cannot be read (badInput), or there is no criterion, or the golden's name is not that
/// of a .png, or of an .exr for a linear frame (wrongUse).
Result<Verdict> judge(const Frame& frame, const Near& expected, const EvidenceOptions& = {});

}  // namespace rushlight::golden
