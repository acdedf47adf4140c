// Any bytes as a glTF or GLB file: loading must end in a model or an Error, never in a crash.
//     cmake --preset fuzz && cmake --build build/fuzz --target gltf_fuzz
//     build/fuzz/bin/gltf_fuzz -max_total_time=60 CORPUS_FOLDER
#include "engine/assets/gltf.h"

#include <unistd.h>

#include <cstring>
#include <fstream>
#include <string>

namespace {

const std::string& folder() {
    static const std::string path = [] {
        char name[] = "/tmp/rushlight-fuzz-XXXXXX";
        if (!mkdtemp(name)) std::abort();
        return std::string(name);
    }();
    return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
    const std::string path = folder() + (binary ? "/input.glb" : "/input.gltf");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), std::streamsize(size));
    rushlight::assets::LoadOptions options;
    options.missingImages = rushlight::assets::MissingImages::replace;
    options.maxImagePixels = 1u << 20;
    options.maxElements = 1u << 20;
    options.maxNodes = 1u << 12;
    const auto model = rushlight::assets::loadModel(path, options);
    return model || !model.error().message.empty() ? 0 : -1;
}
