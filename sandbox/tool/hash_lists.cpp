#include "sandbox/tool/hash_lists.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>
#include <vector>

namespace rushlight::tool {
namespace {

constexpr size_t kDigits = 16;

struct HashLine {
    std::string image;  ///< pass and attachment
    std::string hash;

    bool operator==(const HashLine&) const = default;
};

Result<std::vector<HashLine>> readHashes(const std::string& path) {
    std::ifstream file(path);
    if (!file)
        return fail(path,
                    "The file could not be read (" + std::generic_category().message(errno) + ").");
    std::vector<HashLine> lines;
    for (std::string text; std::getline(file, text);) {
        const size_t space = text.rfind(' ');
        const bool good = space != std::string::npos && space > 0 &&
                          text.size() == space + 1 + kDigits &&
                          text.find_first_not_of("0123456789abcdef", space + 1) ==
                              std::string::npos;
        if (!good)
            return fail(path, "Line " + std::to_string(lines.size() + 1) +
                                  " is no \"pass attachment hash\", as --hashes prints them.");
        lines.push_back({text.substr(0, space), text.substr(space + 1)});
    }
    if (lines.empty()) return fail(path, "The list has no lines; --hashes prints one an image.");
    return lines;
}

std::string at(const std::vector<HashLine>& lines, size_t i) {
    return i < lines.size() ? lines[i].image : std::string("nothing more");
}

}  // namespace

Result<bool> compareHashLists(const std::string& a, const std::string& b) {
    const auto first = readHashes(a);
    if (!first) return tl::unexpected(first.error());
    const auto second = readHashes(b);
    if (!second) return tl::unexpected(second.error());
    const auto differs = std::ranges::mismatch(*first, *second);
    const auto line = size_t(differs.in1 - first->begin());
    if (line == first->size() && line == second->size()) {
        std::printf("all %zu images are equal\n", line);
        return true;
    }
    if (at(*first, line) != at(*second, line)) {
        std::printf("line %zu: %s has %s, %s has %s\n", line + 1, a.c_str(),
                    at(*first, line).c_str(), b.c_str(), at(*second, line).c_str());
        return false;
    }
    size_t different = 0;
    for (size_t i = line; i < std::min(first->size(), second->size()); ++i)
        different += (*first)[i] != (*second)[i];
    std::printf("line %zu: %s is the first that differs (%s, %s); %zu of %zu do\n", line + 1,
                at(*first, line).c_str(), (*first)[line].hash.c_str(), (*second)[line].hash.c_str(),
                different, first->size());
    return false;
}

}  // namespace rushlight::tool
