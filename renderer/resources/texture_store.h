#pragma once
// Images as layers of texture arrays: images of one size and encoding share an array, so that one
// binding serves many materials. Arrays are made when a frame first needs them, exactly as large as
// what waits.

#include "engine/core/jobs.h"
#include "renderer/frame/frame_input.h"
#include "renderer/rhi/device.h"

#include <vector>

namespace rushlight {

struct ImageLocation {
    TextureHandle array;
    uint32_t layer = 0;
};

class TextureStore {
public:
    static constexpr uint32_t kMaxLayers = 1024;  ///< 10 bits of MaterialData
    static constexpr uint32_t kMaxSide = 16384;

    TextureStore(Device& device, JobSystem& jobs) : device_(device), jobs_(jobs) {}
    ~TextureStore();
    TextureStore(const TextureStore&) = delete;
    TextureStore& operator=(const TextureStore&) = delete;

    Result<ImageHandle> create(const ImageDesc&);
    void destroy(ImageHandle);

    /// Uploads what waits. Returns true when any image got or lost its place: materials must look
    /// theirs up again.
    Result<bool> flush();

    /// Null for a stale handle; `array` is none before flush().
    const ImageLocation* find(ImageHandle image) const;
    bool has(ImageHandle image) const { return images_.find(image) != nullptr; }

private:
    struct Shape {
        uint32_t width = 0, height = 0;
        bool srgb = false;
        auto operator<=>(const Shape&) const = default;
    };
    struct StoredImage {
        Shape shape;
        std::string label;
        ImageLocation location;
        uint32_t arrayIndex = 0;
        std::vector<std::vector<uint8_t>> levels;  ///< until uploaded
    };
    struct Array {
        TextureHandle texture;
        uint32_t liveLayers = 0;
    };
    Result<void> uploadGroup(const Shape&, std::span<const ImageHandle>);

    Device& device_;
    JobSystem& jobs_;
    Pool<StoredImage, ImageTag> images_;
    std::vector<Array> arrays_;
    std::vector<ImageHandle> waiting_;
    bool moved_ = false;  ///< since the last flush
};

}  // namespace rushlight
