// Any bytes as an RLF file, with hashes that fit: it must be refused, or be listed, compared and
// executed with no harm.
//     cmake --preset fuzz && cmake --build build/fuzz --target frame_file_fuzz
//     build/fuzz/bin/frame_file_fuzz -max_total_time=60 CORPUS_FOLDER     (rushlight capture
//     --save-frame makes a corpus)
#include "renderer/backend/null/null_device.h"
#include "renderer/replay/replay.h"
#include "renderer/rhi/saved/frame_diff.h"
#include "renderer/rhi/saved/frame_file.h"
#include "tests/support/gl/sealed_frame.h"

namespace {

// The null device gives readbacks of the size that a texture claims.
constexpr uint64_t kLargestImage = 1u << 24;

bool isSmall(const rushlight::SavedFrame& frame) {
    for (const rushlight::SavedTexture& texture : frame.textures)
        if (rushlight::imageBytes(texture.desc, 0) > kLargestImage) return false;
    return uint64_t(frame.target.width) * frame.target.height * 4 <= kLargestImage;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    std::vector<std::byte> file(bytes.begin(), bytes.end());
    rushlight::sealFrame(file);
    const auto frame = rushlight::decodeFrame(std::move(file), "fuzz.rlf");
    if (!frame) return frame.error().message.empty() ? -1 : 0;
    rushlight::printNumbered(frame->commands, *frame);
    rushlight::diffFrames(*frame, *frame);
    if (!isSmall(*frame)) return 0;
    const auto device = rushlight::createNullDevice();
    const auto replay = rushlight::FrameReplay::create(*device, *frame);
    if (!replay) return 0;
    (void)(*replay)->run({.until = 5});
    (void)(*replay)->run({.hashAttachments = true});
    return 0;
}
