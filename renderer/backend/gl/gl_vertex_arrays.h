#pragma once
// One vertex array object a vertex layout, with the buffers bound to it remembered.

#include "renderer/backend/gl/gl_state.h"

#include <array>

namespace rushlight {

struct GlStream {
    GLuint buffer = 0;
    GLintptr offset = 0;
    GLsizei stride = 0;
    bool operator==(const GlStream&) const = default;
};

class GlVertexArrays {
public:
    using Streams = std::array<GlStream, kVertexStreams>;

    GlVertexArrays(const GlFunctions& gl, GlState& state) : gl_(gl), state_(state) {}
    ~GlVertexArrays();

    /// Binds the layout's array with these buffers; of the streams those that the layout reads.
    void bind(VertexLayout layout, bool movingInstances, const Streams& streams, GLuint indices);
    void forgetBuffer(GLuint buffer);

private:
    struct Array {
        GLuint name = 0;
        std::array<bool, kVertexStreams> reads{};
        Streams streams{};
        GLuint indices = 0;
    };
    void create(Array& array, VertexLayout layout, bool movingInstances);

    const GlFunctions& gl_;
    GlState& state_;
    std::array<Array, 12> arrays_{};  ///< by layout and moving instances
};

}  // namespace rushlight
