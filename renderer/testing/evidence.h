#pragma once
// The folder that a verdict leaves behind:
//     evidence.json  which golden it is about, as a path from here, and what that was when the
//     frame was judged actual.png     what was rendered (.exr if linear); becomes the golden where
//     it is accepted golden.png     a copy of the golden's file error.png      the largest
//     difference of the values of every pixel, as heat heat.png       the FLIP error of every
//     pixel, as heat breakdown/     the frame taken apart

#include "renderer/testing/verdict.h"

#include <string>

namespace rushlight::golden {

inline constexpr const char* kEvidenceFile = "evidence.json";

class EvidenceWriter {
public:
    EvidenceWriter(const EvidenceOptions& options, const std::string& golden);

    const std::string& folder() const { return folder_; }

    /// `comparison`: null where there is nothing to compare with.
    Result<void> write(const Frame& frame, const Verdict& verdict, const Comparison* comparison);
    /// Does nothing where the frame cannot be taken apart.
    Result<void> takeApart(const Frame& frame);
    /// Removes what an earlier verdict left, and nothing else.
    Result<void> clear();

private:
    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::string folder_;
};

/// evidence.json, read. Paths are absolute.
struct Evidence {
    std::string folder, name;
    std::string golden, actual;  ///< files
    std::string goldenHash;  ///< of the golden's bytes when the frame was judged; empty: there was
                             ///< none
    bool linear = false;
    bool passed = false;
};
Result<Evidence> readEvidence(const std::string& folder);

/// 32 hexadecimal digits for the bytes of a file; empty where there is none.
Result<std::string> hashOfFile(const std::string& path);
Result<std::vector<std::byte>> readFile(const std::string& path);

}  // namespace rushlight::golden
