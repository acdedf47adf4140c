#include "renderer/backend/gl/programs/gl_shader_library.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>

namespace rushlight {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(uint8_t(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(uint8_t(text.back()))) text.remove_suffix(1);
    return text;
}

/// "#  include x" gives "include" and "x"; a line that is no directive gives two empty texts.
std::pair<std::string_view, std::string_view> directive(std::string_view line) {
    line = trimmed(line);
    if (line.empty() || line.front() != '#') return {};
    line = trimmed(line.substr(1));
    const size_t end = std::min(line.find_first_of(" \t\"<("), line.size());
    return {line.substr(0, end), trimmed(line.substr(end))};
}

/// Follows the one condition that includes depend on: whether GLSL or C++ reads the lines.
class LanguageCondition {
public:
    bool forGlsl() const { return std::ranges::find(levels_, false) == levels_.end(); }

    void read(std::string_view name, std::string_view rest) {
        if (name == "ifdef")
            levels_.push_back(rest != "__cplusplus");
        else if (name == "ifndef")
            levels_.push_back(rest != "GLSL");
        else if (name == "if")
            levels_.push_back(true);
        else if (name == "endif" && !levels_.empty())
            levels_.pop_back();
        else if (name == "else" && !levels_.empty())
            levels_.back() = afterElse();
        if (name == "ifdef" || name == "ifndef" || name == "if")
            opened_.push_back(std::string(name) + " " + std::string(rest));
        else if (name == "endif" && !opened_.empty())
            opened_.pop_back();
    }

private:
    bool afterElse() const {
        const std::string& opened = opened_.back();
        return opened != "ifdef GLSL" && opened != "ifndef __cplusplus";
    }
    std::vector<bool> levels_;
    std::vector<std::string> opened_;
};

bool readNumber(std::string_view& text, size_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    text.remove_prefix(size_t(end - text.data()));
    return true;
}

}  // namespace

/// Expands one source and what it includes into one text.
class ShaderExpansion {
public:
    explicit ShaderExpansion(const ShaderLibrary& library) : library_(library) {}

    Result<void> add(std::string_view name, const std::string& from) {
        const Result<std::string> text = library_.read(name);
        if (!text) return fail(from.empty() ? std::string(name) : from, text.error().message);
        const size_t number = source.files.size();
        source.files.emplace_back(name);
        open_.emplace_back(name);
        startLine(1, number);
        if (Result<void> lines = addLines(*text, name, number); !lines) return lines;
        open_.pop_back();
        return {};
    }

    ShaderSource source;

private:
    Result<void> addLines(std::string_view text, std::string_view name, size_t number) {
        LanguageCondition condition;
        for (size_t line = 1; !text.empty(); ++line) {
            const size_t end = std::min(text.find('\n'), text.size());
            const std::string_view content = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            const auto [word, rest] = directive(content);
            condition.read(word, rest);
            if (word == "include") {
                const std::string from = std::string(name) + ":" + std::to_string(line);
                if (condition.forGlsl())
                    if (Result<void> included = include(rest, from); !included) return included;
                startLine(line + 1, number);
            } else {
                source.text.append(content).push_back('\n');
            }
        }
        return {};
    }

    Result<void> include(std::string_view argument, const std::string& from) {
        const size_t end = argument.size() < 2 ? argument.npos : argument.find('"', 1);
        if (end == argument.npos || argument.front() != '"')
            return fail(from, "#include needs a name in quotes, relative to the shaders' root.");
        std::string_view name = argument.substr(1, end - 1);
        // As C++ writes it, from the project's root: headers read by both include each other so.
        if (name.starts_with("shaders/")) name.remove_prefix(8);
        if (std::ranges::find(open_, name) != open_.end()) {
            std::string chain;
            for (const std::string& file : open_) chain += file + " -> ";
            return fail(from, "The include makes a cycle: " + chain + std::string(name) + ".");
        }
        if (std::ranges::find(source.files, name) != source.files.end()) return {};
        return add(name, from);
    }

    /// From GLSL 3.30 on the number in #line is that of the line after it.
    void startLine(size_t line, size_t file) {
        source.text += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    }

    const ShaderLibrary& library_;
    std::vector<std::string> open_;
};

Result<std::string> ShaderLibrary::read(std::string_view name) const {
    if (directory_.empty()) {
        const auto shaders = embeddedShaders();
        const auto found = std::ranges::find(shaders, name, &ShaderText::name);
        if (found != shaders.end()) return std::string(found->text);
        return fail(std::string(name),
                    "There is no shader \"" + std::string(name) + "\" among those compiled in.");
    }
    const std::string path = directory_ + "/" + std::string(name);
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(std::string(name), "The shader file \"" + path + "\" cannot be read.");
    return std::string(std::istreambuf_iterator<char>(file), {});
}

Result<ShaderSource> ShaderLibrary::load(std::string_view name,
                                         std::span<const std::string> defines) const {
    ShaderExpansion expansion(*this);
    expansion.source.text = "#version 450 core\n#define GLSL 1\n";
    for (const std::string& define : defines) expansion.source.text += "#define " + define + "\n";
    return expansion.add(name, {}).map([&] { return std::move(expansion.source); });
}

std::string ShaderSource::readableLog(std::string_view log) const {
    std::string readable;
    while (!log.empty()) {
        const size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        // Mesa "0:12(5): error: ...", NVIDIA "0(12) : error ...", others "ERROR: 0:12: ...".
        std::string_view rest = line;
        for (std::string_view prefix : {"ERROR: ", "WARNING: "})
            if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
        size_t file = 0, number = 0;
        bool placed = readNumber(rest, file) && file < files.size() && !rest.empty() &&
                      (rest.front() == ':' || rest.front() == '(');
        if (placed) rest.remove_prefix(1);
        placed = placed && readNumber(rest, number);
        if (placed) {
            const size_t colon = rest.find(':');
            rest = colon == rest.npos ? rest : rest.substr(colon + 1);
            readable += files[file] + ":" + std::to_string(number) + ": ";
            line = trimmed(rest);
        }
        readable.append(line).push_back('\n');
    }
    while (!readable.empty() && (readable.back() == '\n' || readable.back() == '\0'))
        readable.pop_back();
    return readable;
}

}  // namespace rushlight
