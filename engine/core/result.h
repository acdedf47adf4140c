#pragma once

#include <tl/expected.hpp>

#include <string>

namespace rushlight {

/// What kind of failure a value describes; the command line maps it to an exit code.
enum class ErrorKind {
    badInput,   ///< a file or a value from outside is wrong (exit code 3)
    wrongUse,   ///< the API or the command line was used wrongly (exit code 2)
    noContext,  ///< no GL context could be had (exit code 4)
};

/// A failure as a value: which file or object, and a full sentence about what is wrong and what to
/// do.
struct Error {
    std::string object;
    std::string message;
    ErrorKind kind = ErrorKind::badInput;

    std::string text() const { return object.empty() ? message : object + ": " + message; }
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string object, std::string message,
                                  ErrorKind kind = ErrorKind::badInput) {
    return tl::unexpected<Error>(Error{std::move(object), std::move(message), kind});
}

}  // namespace rushlight
