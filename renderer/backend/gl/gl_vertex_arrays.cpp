#include "renderer/backend/gl/gl_vertex_arrays.h"

#include "shaders/interop/bindings.h"

#include <cstddef>

namespace rushlight {
namespace {

struct Attribute {
    GLuint location;
    GLuint stream;
    GLint components;
    GLenum type;
    bool normalized;
    size_t offset;
};

// clang-format off
constexpr Attribute kPosition = {RL_ATTRIBUTE_POSITION, RL_STREAM_POSITION, 3, GL_FLOAT, false, offsetof(VertexPosition, position)};
constexpr Attribute kUv0      = {RL_ATTRIBUTE_UV0,   RL_STREAM_SURFACE, 2, GL_FLOAT, false, offsetof(VertexSurface, uv0)};
constexpr Attribute kFrame    = {RL_ATTRIBUTE_FRAME, RL_STREAM_SURFACE, 4, GL_SHORT, true,  offsetof(VertexSurface, frame)};
constexpr Attribute kExtra[] = {
    {RL_ATTRIBUTE_UV1,   RL_STREAM_EXTRA, 2, GL_FLOAT,          false, offsetof(VertexExtra, uv1)},
    {RL_ATTRIBUTE_COLOR, RL_STREAM_EXTRA, 4, GL_UNSIGNED_SHORT, true,  offsetof(VertexExtra, color)},
};
constexpr Attribute kOverlay[] = {
    {RL_ATTRIBUTE_POSITION, RL_STREAM_POSITION, 2, GL_FLOAT,         false, offsetof(OverlayVertex, position)},
    {RL_ATTRIBUTE_UV0,      RL_STREAM_POSITION, 2, GL_FLOAT,         false, offsetof(OverlayVertex, uv)},
    {RL_ATTRIBUTE_COLOR,    RL_STREAM_POSITION, 4, GL_UNSIGNED_BYTE, true,  offsetof(OverlayVertex, color)},
};
constexpr Attribute kInstance[] = {
    {RL_ATTRIBUTE_INSTANCE_ROW0,    RL_STREAM_INSTANCE, 4, GL_FLOAT,        false, offsetof(InstanceData, row0)},
    {RL_ATTRIBUTE_INSTANCE_ROW1,    RL_STREAM_INSTANCE, 4, GL_FLOAT,        false, offsetof(InstanceData, row1)},
    {RL_ATTRIBUTE_INSTANCE_ROW2,    RL_STREAM_INSTANCE, 4, GL_FLOAT,        false, offsetof(InstanceData, row2)},
    {RL_ATTRIBUTE_INSTANCE_INDICES, RL_STREAM_INSTANCE, 4, GL_UNSIGNED_INT, false, offsetof(InstanceData, material)},
};
constexpr Attribute kPrevious[] = {
    {RL_ATTRIBUTE_PREVIOUS_ROW0, RL_STREAM_INSTANCE, 4, GL_FLOAT, false, offsetof(MovingInstanceData, previousRow0)},
    {RL_ATTRIBUTE_PREVIOUS_ROW1, RL_STREAM_INSTANCE, 4, GL_FLOAT, false, offsetof(MovingInstanceData, previousRow1)},
    {RL_ATTRIBUTE_PREVIOUS_ROW2, RL_STREAM_INSTANCE, 4, GL_FLOAT, false, offsetof(MovingInstanceData, previousRow2)},
};
// clang-format on

constexpr const char* kLabels[] = {"none",     "position", "standard",
                                   "extended", "overlay",  "position and uv"};

}  // namespace

GlVertexArrays::~GlVertexArrays() {
    for (const Array& array : arrays_)
        if (array.name) gl_.DeleteVertexArrays(1, &array.name);
}

void GlVertexArrays::create(Array& array, VertexLayout layout, bool movingInstances) {
    gl_.CreateVertexArrays(1, &array.name);
    gl_.label(GL_VERTEX_ARRAY, array.name, kLabels[size_t(layout)]);
    const auto add = [&](const Attribute& a) {
        gl_.EnableVertexArrayAttrib(array.name, a.location);
        if (a.type == GL_UNSIGNED_INT)
            gl_.VertexArrayAttribIFormat(array.name, a.location, a.components, a.type,
                                         GLuint(a.offset));
        else
            gl_.VertexArrayAttribFormat(array.name, a.location, a.components, a.type, a.normalized,
                                        GLuint(a.offset));
        gl_.VertexArrayAttribBinding(array.name, a.location, a.stream);
        array.reads[a.stream] = true;
    };
    if (layout == VertexLayout::none) return;
    if (layout == VertexLayout::overlay) {
        for (const Attribute& a : kOverlay) add(a);
        return;
    }
    add(kPosition);
    if (layout != VertexLayout::position) add(kUv0);
    if (layout == VertexLayout::standard || layout == VertexLayout::extended) add(kFrame);
    if (layout == VertexLayout::extended)
        for (const Attribute& a : kExtra) add(a);
    for (const Attribute& a : kInstance) add(a);
    if (movingInstances)
        for (const Attribute& a : kPrevious) add(a);
    gl_.VertexArrayBindingDivisor(array.name, RL_STREAM_INSTANCE, 1);
}

void GlVertexArrays::bind(VertexLayout layout, bool movingInstances, const Streams& streams,
                          GLuint indices) {
    Array& array = arrays_[size_t(layout) * 2 + (movingInstances ? 1 : 0)];
    if (!array.name) create(array, layout, movingInstances);
    state_.bindVertexArray(array.name);
    for (uint32_t slot = 0; slot < kVertexStreams; ++slot) {
        const GlStream& stream = streams[slot];
        if (!array.reads[slot] || array.streams[slot] == stream) continue;
        array.streams[slot] = stream;
        gl_.VertexArrayVertexBuffer(array.name, slot, stream.buffer, stream.offset, stream.stride);
        state_.countChange();
    }
    if (indices && array.indices != indices) {
        array.indices = indices;
        gl_.VertexArrayElementBuffer(array.name, indices);
        state_.countChange();
    }
}

void GlVertexArrays::forgetBuffer(GLuint buffer) {
    for (Array& array : arrays_) {
        for (GlStream& stream : array.streams)
            if (stream.buffer == buffer) stream = {};
        if (array.indices == buffer) array.indices = 0;
    }
}

}  // namespace rushlight
