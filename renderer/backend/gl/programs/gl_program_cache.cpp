#include "renderer/backend/gl/programs/gl_program_cache.h"

#include "engine/core/hash.h"

#include <atomic>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

namespace rushlight {
namespace {

/// What a cache file begins with; the driver's binary follows.
struct FileHeader {
    char magic[8] = {'R', 'L', 'P', 'R', 'O', 'G', '0', '1'};
    uint64_t key = 0;
    uint64_t payloadHash = 0;
    uint32_t payloadSize = 0;
    uint32_t binaryFormat = 0;
};

/// A name no other process or device writes to at the same time.
std::string temporaryName(const std::string& path) {
    static const uint32_t process = std::random_device{}();
    static std::atomic<uint32_t> count = 0;
    return path + "." + std::to_string(process) + "." + std::to_string(++count) + ".tmp";
}

}  // namespace

GlProgramCache::GlProgramCache(const GlFunctions& gl, std::string directory)
    : gl_(gl), directory_(std::move(directory)) {
    if (directory_.empty()) return;
    GLint formats = 0;
    gl_.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    std::error_code error;
    std::filesystem::create_directories(directory_, error);
    if (formats == 0 || error) directory_.clear();
    for (GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION})
        if (const GLubyte* text = gl_.GetString(name))
            driver_ = hashText(reinterpret_cast<const char*>(text), driver_);
}

std::string GlProgramCache::path(uint64_t sources) const {
    char name[40];
    std::snprintf(name, sizeof name, "/program-%016llx.bin",
                  static_cast<unsigned long long>(mixBits(sources) ^ driver_));
    return directory_ + name;
}

bool GlProgramCache::load(GLuint program, uint64_t sources) const {
    if (!enabled()) return false;
    std::ifstream file(path(sources), std::ios::binary);
    if (!file) return false;
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    const FileHeader expected;
    FileHeader header;
    if (bytes.size() < sizeof header) return false;
    std::memcpy(&header, bytes.data(), sizeof header);
    const char* payload = bytes.data() + sizeof header;
    const size_t size = bytes.size() - sizeof header;
    if (std::memcmp(header.magic, expected.magic, sizeof header.magic) != 0 ||
        header.key != (sources ^ driver_) || header.payloadSize != size ||
        header.payloadHash != hashBytes(payload, size))
        return false;
    gl_.ProgramBinary(program, header.binaryFormat, payload, GLsizei(size));
    GLint linked = GL_FALSE;
    gl_.GetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked == GL_TRUE;
}

void GlProgramCache::store(GLuint program, uint64_t sources) const {
    if (!enabled()) return;
    GLint size = 0;
    gl_.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    if (size <= 0) return;
    std::vector<char> payload(static_cast<size_t>(size));
    GLsizei written = 0;
    GLenum format = 0;
    gl_.GetProgramBinary(program, size, &written, &format, payload.data());
    if (written <= 0) return;
    FileHeader header;
    header.key = sources ^ driver_;
    header.payloadSize = uint32_t(written);
    header.payloadHash = hashBytes(payload.data(), size_t(written));
    header.binaryFormat = format;

    const std::string final = path(sources);
    const std::string temporary = temporaryName(final);
    std::ofstream file(temporary, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    file.write(payload.data(), written);
    file.close();
    // A rename is atomic: a reader sees the old file, the new one, or none.
    std::error_code error;
    if (file) std::filesystem::rename(temporary, final, error);
    if (!file || error) std::filesystem::remove(temporary, error);
}

}  // namespace rushlight
