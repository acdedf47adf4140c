#pragma once
// The house's rules about who may know whom, checked in the sources: includes, GL, and lists of
// files.

#include <filesystem>
#include <string>
#include <vector>

namespace rushlight {

/// Walks the project's folders under `root`. One sentence for every violation, sorted; each begins
/// with the file.
std::vector<std::string> findLayeringViolations(const std::filesystem::path& root);

}  // namespace rushlight
