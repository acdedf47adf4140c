#include "content/generator/png_writer.h"

#include "content/generator/deflate.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace rushlight::content {
namespace {

void putBigEndian(std::vector<uint8_t>& out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(uint8_t(value >> shift));
}

uint32_t crc32(std::span<const uint8_t> data) {
    uint32_t crc = 0xffffffffu;
    for (const uint8_t byte : data) {
        crc ^= byte;
        for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

void putChunk(std::vector<uint8_t>& out, std::string_view type, std::span<const uint8_t> data) {
    putBigEndian(out, uint32_t(data.size()));
    const size_t begin = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), data.begin(), data.end());
    putBigEndian(out, crc32(std::span(out).subspan(begin)));
}

int paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int dl = std::abs(guess - left), du = std::abs(guess - up), dc = std::abs(guess - corner);
    return dl <= du && dl <= dc ? left : du <= dc ? up : corner;
}

/// The five filters of the specification (9.2); the one with the smallest sum of absolute residuals
/// wins.
void putFilteredRow(std::vector<uint8_t>& out, const Picture& p, int y) {
    const size_t stride = size_t(p.width) * size_t(p.channels);
    const uint8_t* row = p.bytes.data() + size_t(y) * stride;
    const uint8_t* above = y > 0 ? row - stride : nullptr;
    std::array<std::vector<uint8_t>, 5> tries;
    std::array<long, 5> cost{};
    for (int f = 0; f < 5; ++f) {
        tries[size_t(f)].resize(stride);
        for (size_t x = 0; x < stride; ++x) {
            const bool first = x < size_t(p.channels);
            const int left = first ? 0 : row[x - size_t(p.channels)];
            const int up = above ? above[x] : 0;
            const int corner = above && !first ? above[x - size_t(p.channels)] : 0;
            const std::array<int, 5> guess = {0, left, up, (left + up) / 2,
                                              paeth(left, up, corner)};
            const auto residual = uint8_t(row[x] - guess[size_t(f)]);
            tries[size_t(f)][x] = residual;
            cost[size_t(f)] += residual < 128 ? residual : 256 - residual;
        }
    }
    size_t best = 0;
    for (size_t f = 1; f < 5; ++f)
        if (cost[f] < cost[best]) best = f;
    out.push_back(uint8_t(best));
    out.insert(out.end(), tries[best].begin(), tries[best].end());
}

}  // namespace

std::vector<uint8_t> encodePng(const Picture& picture) {
    std::vector<uint8_t> out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<uint8_t> header;
    putBigEndian(header, uint32_t(picture.width));
    putBigEndian(header, uint32_t(picture.height));
    const uint8_t colorType = picture.channels == 1 ? 0 : picture.channels == 3 ? 2 : 6;
    header.insert(header.end(), {8, colorType, 0, 0, 0});
    putChunk(out, "IHDR", header);
    std::vector<uint8_t> rows;
    for (int y = 0; y < picture.height; ++y) putFilteredRow(rows, picture, y);
    putChunk(out, "IDAT", zlibCompress(rows));
    putChunk(out, "IEND", {});
    return out;
}

void writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    file.close();
    if (file) return;
    std::fprintf(stderr,
                 "rushlight-content: error: %s: the file could not be written; check that "
                 "the folder exists and has room.\n",
                 path.string().c_str());
    std::exit(3);
}

}  // namespace rushlight::content
