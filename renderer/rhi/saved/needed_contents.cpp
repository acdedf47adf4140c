#include "renderer/rhi/saved/needed_contents.h"

namespace rushlight {
namespace {

class Walker {
public:
    explicit Walker(const ResourceLookup& resources) : resources_(resources) {}

    std::map<TextureHandle, std::vector<bool>> needed;

    void operator()(const BeginPass& c) {
        if (c.toFrameTarget) return;
        for (uint32_t i = 0; i < c.colorCount; ++i)
            use(c.colors[i].texture, c.colors[i].mipLevel, c.colors[i].layer,
                c.colors[i].load == LoadOp::keep);
        use(c.depth.texture, 0, c.depth.layer, c.depth.load == LoadOp::keep);
    }
    void operator()(const BindTexture& c) {
        Images* images = find(c.texture);
        if (!images) return;
        for (size_t i = 0; i < images->written.size(); ++i)
            if (!images->written[i]) needed[c.texture][i] = true;
    }
    void operator()(const Readback& c) { use(c.texture, c.mipLevel, c.layer, true); }
    void operator()(const DeclareImage& c) { find(c.texture); }
    template <class Other>
    void operator()(const Other&) {}

private:
    struct Images {
        uint32_t layers = 0;
        std::vector<bool> written;
    };
    Images* find(TextureHandle texture) {
        const auto known = images_.find(texture);
        if (known != images_.end()) return &known->second;
        const auto desc = resources_.describe(texture);
        if (!desc) return nullptr;
        const size_t count = size_t(desc->layers) * desc->mipLevels;
        needed[texture].resize(count);
        return &(images_[texture] = {desc->layers, std::vector<bool>(count)});
    }
    void use(TextureHandle texture, uint32_t mipLevel, uint32_t layer, bool reads) {
        Images* images = find(texture);
        const size_t at = images ? size_t(mipLevel) * images->layers + layer : 0;
        if (!images || at >= images->written.size()) return;
        if (reads && !images->written[at]) needed[texture][at] = true;
        images->written[at] = true;
    }

    const ResourceLookup& resources_;
    std::map<TextureHandle, Images> images_;
};

}  // namespace

std::map<TextureHandle, std::vector<bool>> neededContents(const CommandBuffer& commands,
                                                          const ResourceLookup& resources) {
    Walker walker(resources);
    visitCommands(commands, walker);
    return std::move(walker.needed);
}

}  // namespace rushlight
