#pragma once
// A page in a real browser without a display: Debian's chromium, which ./tests/run installs.

#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <string>

namespace rushlight {

/// Empty where there is none.
inline std::string browser() {
    FILE* pipe = popen("command -v chromium", "r");
    if (!pipe) return {};
    std::string path = readAll(pipe);
    pclose(pipe);
    while (!path.empty() && path.back() == '\n') path.pop_back();
    return path;
}

inline constexpr const char* kNoBrowser = "chromium is not installed; ./tests/run installs it";

/// The page's document after its scripts ran.
inline std::string documentOf(const std::string& page) {
    const TemporaryDirectory profile;
    const std::string command =
        "timeout 150 " + browser() +
        " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
        " --disable-background-networking --disable-component-update --disable-sync"
        " --window-size=1280,900 --virtual-time-budget=20000 --user-data-dir=" +
        profile.path() + " --dump-dom 'file://" + page + "' 2>/dev/null";
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {};
    std::string text = readAll(pipe);
    pclose(pipe);
    return text;
}

/// Of the page's first element, <html>; empty where it has none of this name.
inline std::string attributeOf(const std::string& document, const std::string& name) {
    const std::string head = document.substr(0, document.find("<head"));
    const size_t at = head.find(" " + name + "=\"");
    if (at == head.npos) return {};
    const size_t begin = at + name.size() + 3;
    return head.substr(begin, head.find('"', begin) - begin);
}

}  // namespace rushlight
