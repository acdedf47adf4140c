#pragma once
// Reads accessors: strided, normalised, sparse. Bounds are checked in 64 bits before any byte is
// read.

#include "engine/assets/gltf/gltf_document.h"
#include "engine/core/math.h"

#include <string>
#include <vector>

namespace rushlight::assets {

/// 1 to 16; InputError for an unknown type.
int componentCount(const tinygltf::Accessor& accessor);

class AccessorReader {
public:
    AccessorReader(const GltfDocument& document, uint64_t maxElements)
        : document_(document), maxElements_(maxElements) {}

    /// Checks every accessor of the file; `ranges`: also that the values keep to the declared
    /// minimum and maximum.
    void checkAll(bool ranges) const;

    size_t count(int accessor) const { return get(accessor).count; }
    const tinygltf::Accessor& get(int accessor) const {
        return document_.gltf.accessors[size_t(accessor)];
    }

    /// Element by element, converted as glTF 2.0 section 3.6.2.2 says; InputError for NaN and
    /// infinity.
    std::vector<float> floats(int accessor) const;
    std::vector<uint32_t> integers(int accessor) const;

    template <class Vec>
    std::vector<Vec> vectors(int accessor) const {
        const std::vector<float> flat = floats(accessor);
        std::vector<Vec> out(count(accessor));
        constexpr size_t n = size_t(Vec::length());
        for (size_t i = 0; i < out.size(); ++i)
            for (size_t c = 0; c < n; ++c) out[i][int(c)] = flat[i * n + c];
        return out;
    }

private:
    void check(size_t accessor) const;
    void checkSparse(size_t accessor) const;
    void checkRange(size_t accessor) const;

    const GltfDocument& document_;
    uint64_t maxElements_;
};

}  // namespace rushlight::assets
