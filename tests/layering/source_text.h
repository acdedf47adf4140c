#pragma once
// C++ and CMake sources as the layering test looks at them.

#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

struct Include {
    std::string path;
    bool quoted = false;  ///< "path": of the project; else <path>
};
std::vector<Include> includesOf(std::string_view source);

/// Without comments, string and character literals; lines stay lines.
std::string codeOf(std::string_view source);

/// The first identifier of `code` that calls or names OpenGL: glXxx(, GL_XXX, PFNGLXXX, GLuint and
/// its like.
std::string glIdentifierIn(std::string_view code);

/// Words of a CMake file that end in `ending`, without comments.
std::vector<std::string> cmakeWords(std::string_view source, std::string_view ending);
std::string cmakeCodeOf(std::string_view source);

}  // namespace rushlight
