#include "tests/layering/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace rushlight {
namespace {

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)); }

// OpenGL 4.5 core, table 2.2
constexpr std::array<std::string_view, 16> kGlTypes = {
    "GLboolean", "GLbyte", "GLubyte",  "GLchar",     "GLshort", "GLushort",   "GLint",    "GLuint",
    "GLsizei",   "GLenum", "GLintptr", "GLbitfield", "GLfloat", "GLsizeiptr", "GLdouble", "GLsync"};

bool namesGl(std::string_view word, char before, char after) {
    if (word.starts_with("GL_") || word.starts_with("PFNGL")) return true;
    if (std::ranges::find(kGlTypes, word) != kGlTypes.end()) return true;
    const bool member = before == '.' || before == '>';
    return !member && after == '(' && word.size() > 2 && word.starts_with("gl") && isUpper(word[2]);
}

}  // namespace

std::vector<Include> includesOf(std::string_view source) {
    std::vector<Include> includes;
    for (size_t at = 0; at < source.size();) {
        const size_t end = std::min(source.find('\n', at), source.size());
        std::string_view line = source.substr(at, end - at);
        at = end + 1;
        const auto skipSpace = [&] {
            line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        };
        skipSpace();
        if (!line.starts_with('#')) continue;
        line.remove_prefix(1);
        skipSpace();
        if (!line.starts_with("include")) continue;
        line.remove_prefix(7);
        skipSpace();
        if (line.empty() || (line[0] != '"' && line[0] != '<')) continue;
        const char close = line[0] == '"' ? '"' : '>';
        const size_t last = line.find(close, 1);
        if (last != line.npos)
            includes.push_back({std::string(line.substr(1, last - 1)), close == '"'});
    }
    return includes;
}

std::string codeOf(std::string_view source) {
    std::string code;
    for (size_t i = 0; i < source.size(); ++i) {
        const std::string_view rest = source.substr(i);
        if (rest.starts_with("//")) {
            i = std::min(source.find('\n', i), source.size()) - 1;
        } else if (rest.starts_with("/*")) {
            i = std::min(source.find("*/", i + 2), source.size() - 2) + 1;
        } else if (rest.starts_with("R\"")) {
            const size_t open = std::min(source.find('(', i), source.size() - 1);
            std::string close(1, ')');
            close.append(source.substr(i + 2, open - i - 2)).append(1, '"');
            i = std::min(source.find(close, open), source.size() - close.size()) + close.size() - 1;
        } else if (source[i] == '"' || (source[i] == '\'' && (i == 0 || !isWord(source[i - 1])))) {
            const char quote = source[i];
            for (++i; i < source.size() && source[i] != quote && source[i] != '\n'; ++i)
                if (source[i] == '\\') ++i;
        } else {
            code += source[i];
        }
    }
    return code;
}

std::string glIdentifierIn(std::string_view code) {
    for (size_t i = 0; i < code.size(); ++i) {
        if (!isWord(code[i]) || (i > 0 && isWord(code[i - 1]))) continue;
        size_t end = i;
        while (end < code.size() && isWord(code[end])) ++end;
        const std::string_view word = code.substr(i, end - i);
        if (namesGl(word, i > 0 ? code[i - 1] : ' ', end < code.size() ? code[end] : ' '))
            return std::string(word);
        i = end - 1;
    }
    return {};
}

std::string cmakeCodeOf(std::string_view source) {
    std::string code;
    bool comment = false;
    for (char c : source) {
        if (c == '#') comment = true;
        if (c == '\n') comment = false;
        if (!comment) code += c;
    }
    return code;
}

std::vector<std::string> cmakeWords(std::string_view source, std::string_view ending) {
    std::vector<std::string> words;
    const std::string code = cmakeCodeOf(source);
    constexpr std::string_view kSeparators = " \t\n()\";";
    for (size_t at = 0; at < code.size();) {
        const size_t begin = std::min(code.find_first_not_of(kSeparators, at), code.size());
        at = std::min(code.find_first_of(kSeparators, begin), code.size());
        std::string word = code.substr(begin, at - begin);
        if (word.ends_with(ending)) words.push_back(std::move(word));
    }
    return words;
}

}  // namespace rushlight
