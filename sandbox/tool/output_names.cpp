#include "sandbox/tool/output_names.h"

#include <cctype>

namespace rushlight::tool {

Result<std::string> frameFileName(const std::string& pattern, uint32_t frame) {
    std::string name;
    int places = 0;
    for (size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%') {
            name += pattern[i];
            continue;
        }
        if (i + 1 < pattern.size() && pattern[i + 1] == '%') {
            name += pattern[++i];
            continue;
        }
        const bool zeros = i + 1 < pattern.size() && pattern[i + 1] == '0';
        size_t width = 0;
        while (++i < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[i])))
            width = width * 10 + size_t(pattern[i] - '0');
        if (i >= pattern.size() || pattern[i] != 'd' || width > 20) {
            places = 0;
            break;
        }
        const std::string number = std::to_string(frame);
        if (number.size() < width) name.append(width - number.size(), zeros ? '0' : ' ');
        name += number;
        ++places;
    }
    if (places == 1) return name;
    return fail(pattern,
                "A sequence is written to names with one %d or %04d for the frame's number.",
                ErrorKind::wrongUse);
}

}  // namespace rushlight::tool
