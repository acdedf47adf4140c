#include "sandbox/tool/command.h"

#include <algorithm>
#include <cstdio>

namespace rushlight::tool {
namespace {

void printLine(const char* kind, std::string text) {
    std::ranges::replace(text, '\n', ' ');
    std::fprintf(stderr, "rushlight: %s: %s\n", kind, text.c_str());
}

}  // namespace

int exitCode(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::wrongUse: return 2;
        case ErrorKind::badInput: return 3;
        case ErrorKind::noContext: return 4;
    }
    return 3;
}

void printError(const Error& error) { printLine("error", error.text()); }
void printWarning(const std::string& message) { printLine("warning", message); }

}  // namespace rushlight::tool
