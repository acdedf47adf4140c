#include "engine/assets/gltf/gltf_file.h"

#include "engine/assets/input_error.h"

#include <array>
#include <cstring>
#include <fstream>
#include <system_error>

namespace rushlight::assets {
namespace {

constexpr uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr uint32_t kBinChunk = 0x004e4942;   // "BIN\0"

uint32_t readU32(const uint8_t* bytes) {
    return uint32_t(bytes[0]) | uint32_t(bytes[1]) << 8 | uint32_t(bytes[2]) << 16 |
           uint32_t(bytes[3]) << 24;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::array<int8_t, 256> makeBase64Table() {
    std::array<int8_t, 256> table;
    table.fill(-1);
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < 64; ++i) table[size_t(uint8_t(digits[i]))] = int8_t(i);
    return table;
}

Bytes decodeBase64(std::string_view text) {
    static const std::array<int8_t, 256> table = makeBase64Table();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    require(text.size() % 4 != 1, "a data: URI ends within a base64 digit group.");
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int bitCount = 0;
    for (char c : text) {
        const int8_t digit = table[uint8_t(c)];
        if (digit < 0) refuse("a data: URI holds a character that is no base64 digit.");
        bits = bits << 6 | uint32_t(digit);
        bitCount += 6;
        if (bitCount < 8) continue;
        bitCount -= 8;
        bytes.push_back(uint8_t(bits >> bitCount));
    }
    return bytes;
}

/// glTF 2.0, section 4.4.3: each chunk is length, type, data, and a multiple of four bytes long.
void readChunks(GltfContainer& file) {
    const uint64_t end = file.bytes.size();
    uint64_t at = 12;
    for (int chunk = 0; at < end; ++chunk) {
        if (end - at < 8)
            refuse("the GLB ends within the header of chunk " + std::to_string(chunk) + ".");
        const uint32_t length = readU32(&file.bytes[at]);
        const uint32_t type = readU32(&file.bytes[at + 4]);
        at += 8;
        if (length > end - at)
            refuse("GLB chunk " + std::to_string(chunk) + " says it is " + std::to_string(length) +
                   " bytes long but only " + std::to_string(end - at) + " bytes follow.");
        if (length % 4 != 0)
            refuse("GLB chunk " + std::to_string(chunk) + " is " + std::to_string(length) +
                   " bytes long, which is not a multiple of four.");
        const uint8_t* data = file.bytes.data() + at;
        if (chunk == 0) {
            require(type == kJsonChunk, "the first chunk of the GLB is not JSON.");
            file.json = {reinterpret_cast<const char*>(data), length};
        } else if (type == kJsonChunk || (type == kBinChunk && chunk != 1)) {
            refuse("GLB chunk " + std::to_string(chunk) + " repeats a JSON or BIN chunk.");
        } else if (type == kBinChunk) {
            file.bin = {data, length};
            file.hasBin = true;
        }
        at += length;
    }
    require(!file.json.empty(), "the GLB has no JSON chunk.");
}

void readBinaryHeader(const GltfContainer& file) {
    require(file.bytes.size() >= 12, "the GLB header is cut short.");
    const uint32_t version = readU32(&file.bytes[4]);
    if (version != 2)
        refuse("it is a GLB container of version " + std::to_string(version) +
               "; only version 2 can be read.");
    const uint32_t length = readU32(&file.bytes[8]);
    if (length != file.bytes.size())
        refuse("the GLB header says " + std::to_string(length) + " bytes but the file has " +
               std::to_string(file.bytes.size()) + ".");
}

}  // namespace

Bytes readFile(const std::filesystem::path& path, uint64_t maxBytes) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (error || !std::filesystem::exists(status))
        refuse("the file " + path.string() + " does not exist or cannot be looked at.");
    if (!std::filesystem::is_regular_file(status)) refuse(path.string() + " is not a file.");
    const uint64_t size = std::filesystem::file_size(path, error);
    if (error) refuse("the size of " + path.string() + " cannot be had.");
    if (size > maxBytes)
        refuse(path.string() + " is " + std::to_string(size) + " bytes long; the limit is " +
               std::to_string(maxBytes) + ".");
    std::ifstream stream(path, std::ios::binary);
    Bytes bytes(size);
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size)))
        refuse(path.string() + " cannot be read.");
    return bytes;
}

GltfContainer readContainer(const std::filesystem::path& path, uint64_t maxBytes) {
    GltfContainer file;
    file.bytes = readFile(path, maxBytes);
    require(!file.bytes.empty(), "the file is empty.");
    file.binary = file.bytes.size() >= 4 && readU32(file.bytes.data()) == kMagic;
    if (file.binary) {
        readBinaryHeader(file);
        readChunks(file);
        return file;
    }
    if (path.extension() == ".glb") refuse("it does not begin with the GLB magic 'glTF'.");
    file.json = {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
    return file;
}

std::filesystem::path resolveUri(const std::filesystem::path& folder,
                                 const std::string& decodedUri) {
    require(!decodedUri.empty(), "a URI is empty.");
    const size_t colon = decodedUri.find(':');
    if (colon != std::string::npos && colon < decodedUri.find('/'))
        refuse("the URI '" + decodedUri +
               "' has a scheme; only relative paths and data: are read.");
    if (decodedUri.find('\0') != std::string::npos) refuse("a URI holds a zero byte.");
    const std::filesystem::path relative(decodedUri);
    if (relative.is_absolute() || decodedUri[0] == '\\')
        refuse("the URI '" + decodedUri +
               "' is an absolute path; only files beside the glTF are read.");
    std::error_code error;
    const auto base = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
    const auto target = std::filesystem::weakly_canonical(base / relative, error);
    const auto fromBase = target.lexically_relative(base);
    if (error || fromBase.empty() || *fromBase.begin() == "..")
        refuse("the URI '" + decodedUri + "' leads out of the folder of the glTF file.");
    return target;
}

std::string decodePercent(const std::string& uri) {
    std::string out;
    for (size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            out += uri[i];
            continue;
        }
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
        if (high < 0 || low < 0) refuse("the URI '" + uri + "' has a malformed % escape.");
        out += char(high * 16 + low);
        i += 2;
    }
    return out;
}

bool isDataUri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

Bytes decodeDataUri(std::string_view uri, std::string& mimeType) {
    const size_t comma = uri.find(',');
    require(comma != std::string_view::npos, "a data: URI has no comma.");
    const std::string_view header = uri.substr(5, comma - 5);
    const size_t semicolon = header.find(';');
    mimeType = std::string(header.substr(0, semicolon));
    const size_t base64 = header.rfind(";base64");
    if (base64 != std::string_view::npos && base64 + 7 == header.size())
        return decodeBase64(uri.substr(comma + 1));
    const std::string text = decodePercent(std::string(uri.substr(comma + 1)));
    return Bytes(text.begin(), text.end());
}

}  // namespace rushlight::assets
