#include "engine/assets/gltf/gltf_accessor.h"

#include "engine/assets/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rushlight::assets {
namespace {

/// Where the elements of an accessor lie. `data` is null for an accessor of zeros.
struct Layout {
    const uint8_t* data = nullptr;
    size_t count = 0;
    size_t stride = 0;
    int componentType = 0;
    int components = 0;
    size_t columnRows = 0;    ///< components of a matrix column
    size_t columnStride = 0;  ///< bytes from one matrix column to the next
};

size_t sizeOf(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
        default: return 4;
    }
}

size_t rowsOf(int type, int components) {
    switch (type) {
        case TINYGLTF_TYPE_MAT2: return 2;
        case TINYGLTF_TYPE_MAT3: return 3;
        case TINYGLTF_TYPE_MAT4: return 4;
        default: return size_t(components);
    }
}

/// Matrix columns begin at multiples of four bytes (glTF 2.0, section 3.6.2.4).
Layout packedLayout(int componentType, int type, int components) {
    Layout layout;
    layout.componentType = componentType;
    layout.components = components;
    layout.columnRows = rowsOf(type, components);
    layout.columnStride = layout.columnRows * sizeOf(componentType);
    const size_t columns = size_t(components) / layout.columnRows;
    if (columns > 1) layout.columnStride = (layout.columnStride + 3) / 4 * 4;
    layout.stride = layout.columnStride * columns;
    return layout;
}

template <class T>
T load(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

float loadFloat(const uint8_t* at, int componentType, bool normalized) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            const float value = float(load<int8_t>(at));
            return normalized ? std::max(value / 127.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return normalized ? float(*at) / 255.0f : float(*at);
        case TINYGLTF_COMPONENT_TYPE_SHORT: {
            const float value = float(load<int16_t>(at));
            return normalized ? std::max(value / 32767.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            const float value = float(load<uint16_t>(at));
            return normalized ? value / 65535.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return float(load<uint32_t>(at));
        default: return load<float>(at);
    }
}

uint32_t loadInteger(const uint8_t* at, int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *at;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<uint16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return load<uint32_t>(at);
        default: refuse("an integer accessor has a signed or floating component type.");
    }
}

template <class Out, class Load>
void readElements(const Layout& layout, Out* out, const Load& loadOne) {
    const size_t size = sizeOf(layout.componentType);
    const size_t components = size_t(layout.components);
    for (size_t i = 0; i < layout.count; ++i)
        for (size_t c = 0; c < components; ++c) {
            const size_t column = c / layout.columnRows, row = c % layout.columnRows;
            const uint8_t* at = layout.data + i * layout.stride + column * layout.columnStride +
                                row * size;
            out[i * components + c] = loadOne(at);
        }
}

Layout baseLayout(const GltfDocument& document, const tinygltf::Accessor& accessor) {
    Layout layout = packedLayout(accessor.componentType, accessor.type, componentCount(accessor));
    layout.count = accessor.count;
    if (accessor.bufferView < 0) return layout;
    const auto& view = document.gltf.bufferViews[size_t(accessor.bufferView)];
    if (view.byteStride != 0) layout.stride = view.byteStride;
    layout.data = document.viewBytes(accessor.bufferView).data() + accessor.byteOffset;
    return layout;
}

Layout sparseIndexLayout(const GltfDocument& document, const tinygltf::Accessor& accessor) {
    Layout layout = packedLayout(accessor.sparse.indices.componentType, TINYGLTF_TYPE_SCALAR, 1);
    layout.count = size_t(accessor.sparse.count);
    layout.data = document.viewBytes(accessor.sparse.indices.bufferView).data() +
                  accessor.sparse.indices.byteOffset;
    return layout;
}

Layout sparseValueLayout(const GltfDocument& document, const tinygltf::Accessor& accessor) {
    Layout layout = packedLayout(accessor.componentType, accessor.type, componentCount(accessor));
    layout.count = size_t(accessor.sparse.count);
    layout.data = document.viewBytes(accessor.sparse.values.bufferView).data() +
                  accessor.sparse.values.byteOffset;
    return layout;
}

template <class Out, class Load>
std::vector<Out> readAccessor(const GltfDocument& document, const tinygltf::Accessor& accessor,
                              const Load& loadOne) {
    const Layout base = baseLayout(document, accessor);
    const size_t components = size_t(base.components);
    std::vector<Out> out(base.count * components);
    if (base.data) readElements(base, out.data(), loadOne);
    if (!accessor.sparse.isSparse) return out;
    const Layout indices = sparseIndexLayout(document, accessor);
    const Layout values = sparseValueLayout(document, accessor);
    std::vector<Out> replaced(values.count * components);
    readElements(values, replaced.data(), loadOne);
    for (size_t i = 0; i < indices.count; ++i) {
        const uint32_t element = loadInteger(indices.data + i * indices.stride,
                                             indices.componentType);
        std::copy_n(&replaced[i * components], components, &out[element * components]);
    }
    return out;
}

/// Whether `count` elements from `offset` on fit; never overflows for counts below 2^32 and strides
/// below 2^16.
void checkFits(const std::string& what, const GltfDocument& document, int view, uint64_t offset,
               const Layout& layout) {
    const size_t componentSize = sizeOf(layout.componentType);
    const auto& bufferView = document.gltf.bufferViews[size_t(view)];
    if ((offset + bufferView.byteOffset) % componentSize != 0 || offset % componentSize != 0)
        refuse(what + ": it begins at byte " + std::to_string(offset) + " of a view at byte " +
               std::to_string(bufferView.byteOffset) + ", which is not a multiple of its " +
               std::to_string(componentSize) + "-byte components.");
    const size_t columns = size_t(layout.components) / layout.columnRows;
    const size_t last = layout.columnStride * (columns - 1) + layout.columnRows * componentSize;
    const uint64_t needed = offset + uint64_t(layout.stride) * (uint64_t(layout.count) - 1) + last;
    if (needed > bufferView.byteLength)
        refuse(what + ": it needs " + std::to_string(needed) + " bytes of buffer view " +
               std::to_string(view) + ", which has " + std::to_string(bufferView.byteLength) + ".");
}

}  // namespace

int componentCount(const tinygltf::Accessor& accessor) {
    const int count = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    if (count < 1) refuse("an accessor has an unknown type.");
    return count;
}

void AccessorReader::check(size_t index) const {
    const tinygltf::Accessor& accessor = document_.gltf.accessors[index];
    const std::string what = numbered("accessor", index, accessor.name);
    if (accessor.count > maxElements_)
        refuse(what + ": it has " + std::to_string(accessor.count) + " elements; the limit is " +
               std::to_string(maxElements_) + ".");
    const Layout layout = baseLayout(document_, accessor);
    if (accessor.bufferView >= 0) {
        const size_t stride = document_.gltf.bufferViews[size_t(accessor.bufferView)].byteStride;
        const size_t packed = packedLayout(accessor.componentType, accessor.type, layout.components)
                                  .stride;
        if (stride != 0 && stride < packed)
            refuse(what + ": its elements are " + std::to_string(packed) +
                   " bytes but the byteStride of the view is " + std::to_string(stride) + ".");
        if (stride % sizeOf(accessor.componentType) != 0)
            refuse(what + ": the byteStride " + std::to_string(stride) +
                   " is not a multiple of its component size.");
        checkFits(what, document_, accessor.bufferView, accessor.byteOffset, layout);
    }
    if (accessor.sparse.isSparse) checkSparse(index);
}

void AccessorReader::checkSparse(size_t index) const {
    const tinygltf::Accessor& accessor = document_.gltf.accessors[index];
    const auto& sparse = accessor.sparse;
    const std::string what = numbered("accessor", index, accessor.name) + ": its sparse ";
    if (sparse.count < 1 || size_t(sparse.count) > accessor.count)
        refuse(what + "count " + std::to_string(sparse.count) + " is not from 1 to " +
               std::to_string(accessor.count) + ".");
    const Layout indices = sparseIndexLayout(document_, accessor);
    checkFits(what + "indices", document_, sparse.indices.bufferView,
              uint64_t(sparse.indices.byteOffset), indices);
    checkFits(what + "values", document_, sparse.values.bufferView,
              uint64_t(sparse.values.byteOffset), sparseValueLayout(document_, accessor));
    int64_t last = -1;
    for (size_t i = 0; i < indices.count; ++i) {
        const int64_t element = loadInteger(indices.data + i * indices.stride,
                                            indices.componentType);
        if (element <= last || element >= int64_t(accessor.count))
            refuse(what + "index " + std::to_string(i) + " is " + std::to_string(element) +
                   " after " + std::to_string(last) + "; they must increase and be below " +
                   std::to_string(accessor.count) + ".");
        last = element;
    }
}

/// Exporters round what they declare, and bounds are computed here anyway: only strict loading
/// insists.
void AccessorReader::checkRange(size_t index) const {
    const tinygltf::Accessor& accessor = document_.gltf.accessors[index];
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) floats(int(index));  // finite
    if (accessor.minValues.empty() && accessor.maxValues.empty()) return;
    const size_t components = size_t(componentCount(accessor));
    const bool exact = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    const std::vector<float> values = exact ? std::vector<float>()
                                            : readAccessor<float>(
                                                  document_, accessor, [&](const uint8_t* at) {
                                                      return loadFloat(at, accessor.componentType,
                                                                       false);
                                                  });
    for (size_t i = 0; i < values.size(); ++i) {
        const size_t c = i % components;
        const bool low = !accessor.minValues.empty() && values[i] < float(accessor.minValues[c]);
        const bool high = !accessor.maxValues.empty() && values[i] > float(accessor.maxValues[c]);
        if (low || high)
            refuse(numbered("accessor", index, accessor.name) + ": element " +
                   std::to_string(i / components) + " is " + std::to_string(values[i]) + ", " +
                   (low ? "below the declared minimum." : "above the declared maximum."));
    }
}

void AccessorReader::checkAll(bool ranges) const {
    for (size_t i = 0; i < document_.gltf.accessors.size(); ++i) {
        check(i);
        if (ranges) checkRange(i);
    }
}

std::vector<float> AccessorReader::floats(int accessor) const {
    const tinygltf::Accessor& source = get(accessor);
    std::vector<float> values = readAccessor<float>(document_, source, [&](const uint8_t* at) {
        return loadFloat(at, source.componentType, source.normalized);
    });
    for (size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            refuse(numbered("accessor", size_t(accessor), source.name) + ": element " +
                   std::to_string(i / size_t(componentCount(source))) + " is not finite.");
    return values;
}

std::vector<uint32_t> AccessorReader::integers(int accessor) const {
    const tinygltf::Accessor& source = get(accessor);
    return readAccessor<uint32_t>(document_, source, [&](const uint8_t* at) {
        return loadInteger(at, source.componentType);
    });
}

}  // namespace rushlight::assets
