#pragma once

#include <string>
#include <string_view>

namespace rushlight {

/// A name in a message.
inline std::string quoted(std::string_view name) {
    std::string text(1, '"');
    text += name;
    text += '"';
    return text;
}

}  // namespace rushlight
