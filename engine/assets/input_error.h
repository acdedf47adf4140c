#pragma once

#include <string>
#include <utility>

namespace rushlight::assets {

/// Bad input found deep inside a reader. Thrown within engine/assets only: the public functions
/// turn it into a Result.
struct InputError {
    std::string message;
};

[[noreturn]] inline void refuse(std::string message) { throw InputError{std::move(message)}; }

inline void require(bool condition, const char* message) {
    if (!condition) refuse(message);
}

/// How a message names an object of an array: "mesh 3 'roof'".
inline std::string numbered(const char* kind, size_t index, const std::string& name = {}) {
    std::string text = std::string(kind) + " " + std::to_string(index);
    return name.empty() ? text : text + " '" + name + "'";
}

}  // namespace rushlight::assets
