#pragma once
// Shader sources by name, with includes resolved. Touches no GL.

#include "engine/core/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

struct ShaderText {
    std::string_view name;  ///< relative to shaders/, e.g. "passes/gbuffer.vert"
    std::string_view text;
};

/// The shaders compiled into the library (generated, see embed_shaders.cmake).
std::span<const ShaderText> embeddedShaders();

/// What the driver is given, and the names behind its "file numbers".
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< by the number in #line

    /// A driver's log with "file:line: message" in place of "number:line(column): message".
    std::string readableLog(std::string_view log) const;
};

class ShaderLibrary {
public:
    /// Reads from `directory`, or what is compiled in when that is empty.
    explicit ShaderLibrary(std::string directory) : directory_(std::move(directory)) {}

    /// `#version 450 core`, `#define GLSL 1`, the defines, then the file. `#include "name"` is
    /// resolved from the root, each file once; those between `#ifndef GLSL` (or `#ifdef
    /// __cplusplus`) and its end are C++'s and dropped. Other conditions are not evaluated, so a
    /// GLSL include belongs outside of them.
    Result<ShaderSource> load(std::string_view name, std::span<const std::string> defines) const;

private:
    Result<std::string> read(std::string_view name) const;

    std::string directory_;
    friend class ShaderExpansion;
};

}  // namespace rushlight
