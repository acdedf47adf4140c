#pragma once

#include <string_view>

namespace rushlight {

enum class LogLevel { debug, info, warning, error };

/// Where the libraries send what they have to say. They never print on their own.
/// May be called from any thread that the host lets the library use.
struct LogSink {
    void (*write)(void* user, LogLevel level, std::string_view message) = nullptr;
    void* user = nullptr;

    void operator()(LogLevel level, std::string_view message) const {
        if (write) write(user, level, message);
    }
};

}  // namespace rushlight
