#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace rushlight {

struct Ended {
    int code = -1;
    std::string output, errors;
};

inline std::string readAll(FILE* pipe) {
    std::string text;
    char buffer[4096];
    while (const size_t count = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, count);
    return text;
}

/// Runs the tool; `folder` gets its standard error for a moment. `before`: of the shell's, as
/// "ulimit -t 9;".
inline Ended runTool(const std::string& folder, const std::string& arguments,
                     const std::string& before = {}) {
    Ended result;
    const std::string errors = folder + "/errors.txt";
    FILE* pipe = popen((before + " " RUSHLIGHT_TOOL " " + arguments + " 2>" + errors).c_str(), "r");
    if (!pipe) return result;
    result.output = readAll(pipe);
    result.code = WEXITSTATUS(pclose(pipe));
    if (FILE* file = std::fopen(errors.c_str(), "r")) {
        result.errors = readAll(file);
        std::fclose(file);
    }
    return result;
}

}  // namespace rushlight
