#include "sandbox/tool/words.h"

#include <cctype>
#include <fstream>

namespace rushlight::tool {
namespace {

Result<void> addWords(const std::string& path, std::vector<std::string>& words) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with('#')) continue;
        bool inWord = false, quoted = false;
        for (const char c : line) {
            const bool separates = !quoted && std::isspace(static_cast<unsigned char>(c));
            if (!separates && !inWord) words.emplace_back();
            inWord = !separates;
            if (c == '"')
                quoted = !quoted;
            else if (inWord)
                words.back() += c;
        }
        if (quoted)
            return fail(path, "A quotation mark is not closed: " + line, ErrorKind::wrongUse);
    }
    if (!file.eof()) return fail("@" + path, "The file of options could not be read.");
    return {};
}

}  // namespace

Result<std::vector<std::string>> commandWords(int count, char** arguments) {
    std::vector<std::string> words;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (!word.starts_with('@')) {
            words.push_back(word);
        } else if (auto added = addWords(word.substr(1), words); !added) {
            return tl::unexpected(added.error());
        }
    }
    return words;
}

}  // namespace rushlight::tool
