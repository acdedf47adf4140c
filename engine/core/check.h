#pragma once

namespace rushlight {

/// Prints file, line, condition and reason on standard error and aborts. For bugs in our own code
/// only.
[[noreturn]] void checkFailed(const char* file, int line, const char* condition,
                              const char* reason);

}  // namespace rushlight

/// Stops the program when our own code is wrong. Never for input: that gets an Error value.
#define RL_CHECK(condition, reason) \
    ((condition) ? void(0) : ::rushlight::checkFailed(__FILE__, __LINE__, #condition, reason))
