#include "content/generator/deflate.h"

#include <algorithm>
#include <array>

namespace rushlight::content {
namespace {

constexpr int kEndOfBlock = 256;
constexpr int kLiteralCodes = 286;
constexpr size_t kBlockSymbols = 60000;

/// RFC 1951, 3.2.5: the shortest run of each length code and its number of extra bits.
constexpr std::array<uint16_t, 29> kLengthBase = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                  15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                  67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<uint8_t, 29> kLengthExtra = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                  2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
/// RFC 1951, 3.2.7: the order in which the lengths of the code length code are sent.
constexpr std::array<uint8_t, 19> kLengthOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};

class BitWriter {
public:
    explicit BitWriter(std::vector<uint8_t>& out) : out_(out) {}
    void put(uint32_t bits, int count) {
        hold_ |= uint64_t(bits) << used_;
        for (used_ += count; used_ >= 8; used_ -= 8, hold_ >>= 8) out_.push_back(uint8_t(hold_));
    }
    void finish() {
        if (used_ > 0) out_.push_back(uint8_t(hold_));
    }

private:
    std::vector<uint8_t>& out_;
    uint64_t hold_ = 0;
    int used_ = 0;
};

struct Code {
    std::vector<uint8_t> lengths;
    std::vector<uint16_t> bits;  ///< reversed: sent from the lowest bit
};

/// Lengths of a Huffman code of the used symbols. Halving the counts until the tree is low enough
/// keeps the limit at a negligible loss.
std::vector<uint8_t> codeLengths(std::vector<uint32_t> counts, int limit) {
    struct Item {
        uint64_t weight;
        int order;
    };
    const int n = int(counts.size());
    std::vector<uint8_t> lengths(counts.size(), 0);
    while (true) {
        std::vector<int> parent;
        std::vector<Item> heap;
        const auto later = [](const Item& a, const Item& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.order > b.order;
        };
        parent.assign(size_t(n), -1);
        for (int i = 0; i < n; ++i)
            if (counts[size_t(i)]) heap.push_back({counts[size_t(i)], i});
        std::make_heap(heap.begin(), heap.end(), later);
        while (heap.size() > 1) {
            uint64_t weight = 0;
            const int joined = int(parent.size());
            parent.push_back(-1);
            for (int k = 0; k < 2; ++k) {
                std::pop_heap(heap.begin(), heap.end(), later);
                weight += heap.back().weight;
                parent[size_t(heap.back().order)] = joined;
                heap.pop_back();
            }
            heap.push_back({weight, joined});
            std::push_heap(heap.begin(), heap.end(), later);
        }
        int longest = 0;
        for (int i = 0; i < n; ++i) {
            int depth = 0;
            for (int p = i; parent[size_t(p)] >= 0; p = parent[size_t(p)]) ++depth;
            lengths[size_t(i)] = uint8_t(counts[size_t(i)] ? std::max(depth, 1) : 0);
            longest = std::max(longest, depth);
        }
        if (longest <= limit) return lengths;
        for (uint32_t& c : counts)
            if (c) c = c / 2 + 1;
    }
}

Code makeCode(const std::vector<uint32_t>& counts, int limit) {
    Code code{codeLengths(counts, limit), std::vector<uint16_t>(counts.size(), 0)};
    uint32_t next = 0;
    for (int length = 1; length <= limit; ++length, next <<= 1)
        for (size_t i = 0; i < code.lengths.size(); ++i) {
            if (code.lengths[i] != length) continue;
            uint32_t reversed = 0;
            for (int b = 0; b < length; ++b) reversed |= ((next >> b) & 1u) << (length - 1 - b);
            code.bits[i] = uint16_t(reversed);
            ++next;
        }
    return code;
}

/// A literal byte, or (from 1000 on) a run of `symbol - 1000` copies of the byte before.
std::vector<uint16_t> findRuns(std::span<const uint8_t> data) {
    std::vector<uint16_t> symbols;
    symbols.reserve(data.size());
    for (size_t i = 0; i < data.size();) {
        size_t run = 0;
        if (i > 0)
            while (run < 258 && i + run < data.size() && data[i + run] == data[i - 1]) ++run;
        symbols.push_back(run >= 3 ? uint16_t(1000 + run) : data[i]);
        i += run >= 3 ? run : 1;
    }
    return symbols;
}

int lengthCode(int run) {
    int code = 28;
    while (kLengthBase[size_t(code)] > run) --code;
    return code;
}

void writeBlock(BitWriter& out, std::span<const uint16_t> symbols, bool last) {
    std::vector<uint32_t> counts(kLiteralCodes, 0);
    counts[kEndOfBlock] = 1;
    for (const uint16_t s : symbols) ++counts[size_t(s < 256 ? s : 257 + lengthCode(s - 1000))];
    const Code literals = makeCode(counts, 15);

    // One distance code, of one bit: "the byte before".
    std::vector<uint8_t> lengths = literals.lengths;
    lengths.push_back(1);
    std::vector<uint32_t> lengthCounts(19, 0);
    for (const uint8_t l : lengths) ++lengthCounts[l];
    const Code header = makeCode(lengthCounts, 7);

    out.put(last ? 1 : 0, 1);
    out.put(2, 2);
    out.put(kLiteralCodes - 257, 5);
    out.put(0, 5);
    out.put(19 - 4, 4);
    for (const uint8_t i : kLengthOrder) out.put(header.lengths[i], 3);
    for (const uint8_t l : lengths) out.put(header.bits[l], header.lengths[l]);

    for (const uint16_t s : symbols) {
        const int code = s < 256 ? s : 257 + lengthCode(s - 1000);
        out.put(literals.bits[size_t(code)], literals.lengths[size_t(code)]);
        if (s < 256) continue;
        const size_t k = size_t(code - 257);
        out.put(uint32_t(s - 1000 - kLengthBase[k]), kLengthExtra[k]);
        out.put(0, 1);
    }
    out.put(literals.bits[kEndOfBlock], literals.lengths[kEndOfBlock]);
}

}  // namespace

std::vector<uint8_t> zlibCompress(std::span<const uint8_t> data) {
    std::vector<uint8_t> out = {0x78, 0xda};
    BitWriter bits(out);
    const std::vector<uint16_t> symbols = findRuns(data);
    for (size_t i = 0; i == 0 || i < symbols.size(); i += kBlockSymbols) {
        const size_t count = std::min(kBlockSymbols, symbols.size() - i);
        writeBlock(bits, std::span(symbols).subspan(i, count), i + count == symbols.size());
    }
    bits.finish();

    uint32_t a = 1, b = 0;
    for (const uint8_t byte : data) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    for (const uint32_t part : {b >> 8, b, a >> 8, a}) out.push_back(uint8_t(part));
    return out;
}

}  // namespace rushlight::content
