#include "renderer/plan/frame_plan.h"

#include "engine/core/hash.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace rushlight {
namespace {

// A pooled texture that no frame has used for this long is given back.
constexpr uint32_t kFramesToKeepUnused = 8;

}  // namespace

bool sameShape(const PlanImage& a, const PlanImage& b) {
    return a.format == b.format && a.width == b.width && a.height == b.height &&
           a.layers == b.layers && a.array == b.array;
}

Result<TextureHandle> createTexture(Device& device, const PlanImage& image) {
    TextureDesc desc;
    desc.label = image.name;
    desc.kind = image.layers > 1 || image.array ? TextureKind::texture2dArray
                                                : TextureKind::texture2d;
    desc.format = image.format;
    desc.width = image.width;
    desc.height = image.height;
    desc.layers = image.layers;
    return device.createTexture(desc);
}

PassBuilder& PassBuilder::color(ImageId image, LoadOp load, const vec4& clear, uint32_t layer) {
    if (!image) return *this;
    FramePlan::Pass& pass = plan_.openPass();
    RL_CHECK(pass.colorCount < kMaxColorAttachments, "a pass has too many colour targets");
    pass.colors[pass.colorCount++] = {image, load, clear, layer};
    return *this;
}

PassBuilder& PassBuilder::depth(ImageId image, LoadOp load, uint32_t layer) {
    plan_.openPass().depth = {image, load, layer, false};
    return *this;
}

PassBuilder& PassBuilder::depthTest(ImageId image, uint32_t layer) {
    plan_.openPass().depth = {image, LoadOp::keep, layer, true};
    return *this;
}

PassBuilder& PassBuilder::frameTarget(uint32_t width, uint32_t height) {
    FramePlan::Pass& pass = plan_.openPass();
    pass.toFrameTarget = true;
    pass.frameWidth = width;
    pass.frameHeight = height;
    return *this;
}

PassBuilder& PassBuilder::sample(uint32_t slot, ImageId image, SamplerHandle sampler) {
    if (image) plan_.bind({FramePlan::Binding::sampled, {}, slot, image, {}, sampler, {}});
    return *this;
}

PassBuilder& PassBuilder::texture(uint32_t slot, TextureHandle texture, SamplerHandle sampler) {
    if (texture) plan_.bind({FramePlan::Binding::outside, {}, slot, {}, texture, sampler, {}});
    return *this;
}

PassBuilder& PassBuilder::uniforms(uint32_t slot, const BufferRange& range) {
    if (range.size) plan_.bind({FramePlan::Binding::uniforms, {}, slot, {}, {}, {}, range});
    return *this;
}

PassBuilder& PassBuilder::texels(uint32_t slot, Format format, const BufferRange& range) {
    if (range.size) plan_.bind({FramePlan::Binding::texels, format, slot, {}, {}, {}, range});
    return *this;
}

void PassBuilder::fullscreen(PipelineHandle pipeline) {
    record<PipelineHandle>(pipeline, [](const PipelineHandle& drawn, CommandBuffer& commands) {
        commands.push(SetPipeline{drawn});
        commands.push(Draw{3, 1, 0});
    });
}

FramePlan::~FramePlan() {
    for (const PooledTexture& pooled : pool_) device_.destroy(pooled.texture);
}

void FramePlan::begin() {
    passes_.clear();
    images_.clear();
    bindings_.clear();
    payloads_.clear();
    kept_.clear();
    wanted_.clear();
    published_.clear();
}

ImageId FramePlan::createImage(const PlanImage& desc) {
    Image image;
    image.desc = desc;
    images_.push_back(image);
    return {uint32_t(images_.size() - 1)};
}

ImageId FramePlan::importImage(const PlanImage& desc, TextureHandle texture) {
    const ImageId id = createImage(desc);
    images_.back().imported = true;
    images_.back().texture = texture;
    return id;
}

void FramePlan::requestImage(ImageId image) { images_[image.value].requested = true; }

void FramePlan::want(const char* name) {
    RL_CHECK(wanted_.size() < kMaxWanted, "too many images are wanted by name");
    wanted_.push_back(name);
}

bool FramePlan::wants(std::string_view name) const {
    return std::ranges::find(wanted_, name) != wanted_.end();
}

void FramePlan::publish(const char* name, ImageId image) {
    published_.push_back({name, image});
    size_t& sealedAt = images_[image.value].sealedAt;
    if (wants(name)) sealedAt = std::min(sealedAt, passes_.size());
}

ImageId FramePlan::find(std::string_view name) const {
    const auto found = std::ranges::find(published_, name, &Published::name);
    return found == published_.end() ? ImageId{} : found->image;
}

bool FramePlan::writesSealed(size_t index) const {
    const Pass& pass = passes_[index];
    const auto sealed = [&](ImageId image) { return images_[image.value].sealedAt <= index; };
    for (uint32_t c = 0; c < pass.colorCount; ++c)
        if (sealed(pass.colors[c].image)) return true;
    return pass.depth.image && !pass.depth.readOnly && sealed(pass.depth.image);
}

PassBuilder FramePlan::addPass(const char* name) {
    Pass& pass = passes_.emplace_back();
    pass.name = name;
    pass.firstBinding = bindings_.size();
    return PassBuilder(*this);
}

void FramePlan::bind(const Binding& binding) {
    bindings_.push_back(binding);
    ++openPass().bindingCount;
}

void FramePlan::setRecord(const void* payload, size_t size, void (*function)(), Caller caller) {
    Pass& pass = openPass();
    RL_CHECK(!pass.caller, "a pass is recorded twice");
    pass.payload = payloads_.size();
    payloads_.resize(payloads_.size() + CommandBuffer::padded(size));
    std::memcpy(payloads_.data() + pass.payload, payload, size);
    pass.function = function;
    pass.caller = caller;
}

Result<void> FramePlan::compile(uint64_t orderSeed) {
    if (auto ordered = checkOrder(); !ordered) return ordered;
    dropUnneeded();
    if (orderSeed) shuffle(orderSeed);
    return allocate();
}

// Every read, and every target whose old content is kept, must have been written by an earlier pass
// or imported.
Result<void> FramePlan::checkOrder() {
    std::vector<bool>& written = writtenScratch_;
    written.assign(images_.size(), false);
    for (uint32_t i = 0; i < images_.size(); ++i) written[i] = images_[i].imported;
    for (const Pass& pass : passes_) {
        const auto require = [&](ImageId image) -> Result<void> {
            if (written[image.value]) return {};
            return fail(std::string("pass '") + pass.name + "'",
                        std::string("reads the image '") + images_[image.value].desc.name +
                            "', which no earlier pass writes.",
                        ErrorKind::wrongUse);
        };
        for (const Binding& binding : bindingsOf(pass))
            if (binding.kind == Binding::sampled)
                if (auto ok = require(binding.image); !ok) return ok;
        for (uint32_t i = 0; i < pass.colorCount; ++i) {
            if (pass.colors[i].load == LoadOp::keep)
                if (auto ok = require(pass.colors[i].image); !ok) return ok;
            written[pass.colors[i].image.value] = true;
        }
        if (pass.depth.image) {
            if (pass.depth.load == LoadOp::keep || pass.depth.readOnly)
                if (auto ok = require(pass.depth.image); !ok) return ok;
            written[pass.depth.image.value] = true;
        }
    }
    return {};
}

void FramePlan::dropUnneeded() {
    std::vector<bool>& wanted = writtenScratch_;
    wanted.assign(images_.size(), false);
    for (uint32_t i = 0; i < images_.size(); ++i)
        wanted[i] = images_[i].imported || images_[i].requested;
    for (size_t i = passes_.size(); i-- > 0;) {
        Pass& pass = passes_[i];
        pass.needed = pass.toFrameTarget;
        for (uint32_t c = 0; c < pass.colorCount; ++c)
            pass.needed |= wanted[pass.colors[c].image.value];
        if (pass.depth.image && !pass.depth.readOnly) pass.needed |= wanted[pass.depth.image.value];
        pass.needed = pass.needed && !writesSealed(i);
        if (!pass.needed) continue;
        for (const Binding& binding : bindingsOf(pass))
            if (binding.kind == Binding::sampled) wanted[binding.image.value] = true;
        for (uint32_t c = 0; c < pass.colorCount; ++c)
            if (pass.colors[c].load == LoadOp::keep) wanted[pass.colors[c].image.value] = true;
        if (pass.depth.image && (pass.depth.load == LoadOp::keep || pass.depth.readOnly))
            wanted[pass.depth.image.value] = true;
    }
    for (uint32_t i = 0; i < passes_.size(); ++i)
        if (passes_[i].needed) kept_.push_back(i);
}

// Two passes may change places where neither writes what the other touches. Layers of one image are
// written apart.
bool FramePlan::mustFollow(const Pass& later, const Pass& earlier) const {
    if (later.toFrameTarget && earlier.toFrameTarget) return true;
    const auto touches = [&](const Pass& pass, ImageId image, uint32_t layer) {
        for (uint32_t c = 0; c < pass.colorCount; ++c)
            if (pass.colors[c].image == image && pass.colors[c].layer == layer) return true;
        if (pass.depth.image == image && pass.depth.layer == layer) return true;
        return std::ranges::any_of(bindingsOf(pass), [&](const Binding& b) {
            return b.kind == Binding::sampled && b.image == image;
        });
    };
    const auto writesWhatIsTouched = [&](const Pass& writer, const Pass& other) {
        for (uint32_t c = 0; c < writer.colorCount; ++c)
            if (touches(other, writer.colors[c].image, writer.colors[c].layer)) return true;
        return writer.depth.image && !writer.depth.readOnly &&
               touches(other, writer.depth.image, writer.depth.layer);
    };
    return writesWhatIsTouched(later, earlier) || writesWhatIsTouched(earlier, later);
}

void FramePlan::shuffle(uint64_t seed) {
    std::vector<uint32_t> left(std::exchange(kept_, {}));
    while (!left.empty()) {
        std::vector<size_t> ready;
        for (size_t i = 0; i < left.size(); ++i) {
            const auto earlier = std::span(left).first(i);
            if (std::ranges::none_of(earlier, [&](uint32_t pass) {
                    return mustFollow(passes_[left[i]], passes_[pass]);
                }))
                ready.push_back(i);
        }
        seed = mixBits(seed + 1);
        const size_t chosen = ready[seed % ready.size()];
        kept_.push_back(left[chosen]);
        left.erase(left.begin() + std::ptrdiff_t(chosen));
    }
}

Result<void> FramePlan::allocate() {
    for (Image& image : images_) image.firstPass = ~0u;
    for (uint32_t k = 0; k < kept_.size(); ++k) {
        const Pass& pass = passes_[kept_[k]];
        const auto touch = [&](ImageId id) {
            if (!id) return;
            Image& image = images_[id.value];
            image.firstPass = std::min(image.firstPass, k);
            image.lastPass = k;
        };
        for (uint32_t c = 0; c < pass.colorCount; ++c) touch(pass.colors[c].image);
        for (const Binding& binding : bindingsOf(pass)) touch(binding.image);
        touch(pass.depth.image);
    }
    for (PooledTexture& pooled : pool_) {
        pooled.inUse = false;
        ++pooled.unusedFrames;
    }
    for (uint32_t k = 0; k < kept_.size(); ++k) {
        for (Image& image : images_) {
            if (image.imported || image.firstPass != k) continue;
            if (auto texture = acquire(image); !texture) return tl::unexpected(texture.error());
        }
        for (Image& image : images_)
            if (image.poolSlot >= 0 && image.lastPass == k && !image.requested)
                pool_[size_t(image.poolSlot)].inUse = false;
    }
    std::erase_if(pool_, [&](const PooledTexture& pooled) {
        const bool stale = pooled.unusedFrames > kFramesToKeepUnused;
        if (stale) device_.destroy(pooled.texture);
        return stale;
    });
    return {};
}

Result<TextureHandle> FramePlan::acquire(Image& image) {
    for (size_t i = 0; i < pool_.size(); ++i) {
        if (pool_[i].inUse || !sameShape(pool_[i].desc, image.desc)) continue;
        pool_[i].inUse = true;
        pool_[i].unusedFrames = 0;
        image.poolSlot = int(i);
        return image.texture = pool_[i].texture;
    }
    auto texture = createTexture(device_, image.desc);
    if (!texture) return texture;
    image.poolSlot = int(pool_.size());
    pool_.push_back({image.desc, *texture, true, 0});
    return image.texture = *texture;
}

uint32_t FramePlan::passBytesPerPixel(uint32_t kept) const {
    const Pass& pass = passes_[kept_[kept]];
    uint32_t bytes = pass.toFrameTarget ? 4 : 0;
    for (uint32_t i = 0; i < pass.colorCount; ++i)
        bytes += bytesPerTexel(images_[pass.colors[i].image.value].desc.format);
    if (pass.depth.image && !pass.depth.readOnly)
        bytes += bytesPerTexel(images_[pass.depth.image.value].desc.format);
    return bytes;
}

void FramePlan::recordPass(uint32_t kept, CommandBuffer& commands) const {
    const Pass& pass = passes_[kept_[kept]];
    BeginPass begin;
    std::strncpy(begin.name, pass.name, sizeof begin.name - 1);
    begin.passIndex = kept;
    begin.colorCount = pass.colorCount;
    begin.toFrameTarget = pass.toFrameTarget;
    begin.width = pass.frameWidth;
    begin.height = pass.frameHeight;
    for (uint32_t i = 0; i < pass.colorCount; ++i) {
        const Color& color = pass.colors[i];
        const Image& image = images_[color.image.value];
        begin.colors[i].texture = image.texture;
        begin.colors[i].layer = uint16_t(color.layer);
        begin.colors[i].load = color.load;
        begin.colors[i].clear = color.clear;
        begin.width = image.desc.width;
        begin.height = image.desc.height;
    }
    if (pass.depth.image) {
        const Image& image = images_[pass.depth.image.value];
        begin.depth.texture = image.texture;
        begin.depth.layer = uint16_t(pass.depth.layer);
        begin.depth.load = pass.depth.load;
        begin.depth.readOnly = pass.depth.readOnly;
        begin.width = image.desc.width;
        begin.height = image.desc.height;
    }
    commands.push(begin);
    declareImages(pass, commands);
    recordBindings(pass, commands);
    if (pass.caller) pass.caller(pass.function, payloads_.data() + pass.payload, commands);
    commands.push(EndPass{kept});
}

void FramePlan::declareImages(const Pass& pass, CommandBuffer& commands) const {
    const auto declare = [&](ImageId id, bool write) {
        const Image& image = images_[id.value];
        DeclareImage command{image.texture, write, {}};
        std::strncpy(command.name, image.desc.name, sizeof command.name - 1);
        commands.push(command);
    };
    for (const Binding& binding : bindingsOf(pass))
        if (binding.kind == Binding::sampled) declare(binding.image, false);
    for (uint32_t i = 0; i < pass.colorCount; ++i) declare(pass.colors[i].image, true);
    if (pass.depth.image && !pass.depth.readOnly) declare(pass.depth.image, true);
}

void FramePlan::recordBindings(const Pass& pass, CommandBuffer& commands) const {
    for (const Binding& b : bindingsOf(pass)) switch (b.kind) {
            case Binding::sampled:
                commands.push(BindTexture{b.slot, images_[b.image.value].texture, b.sampler});
                break;
            case Binding::outside: commands.push(BindTexture{b.slot, b.texture, b.sampler}); break;
            case Binding::uniforms: commands.push(BindUniforms{b.slot, 0, b.range}); break;
            case Binding::texels:
                commands.push(BindTexelBuffer{b.slot, b.format, {}, b.range});
                break;
        }
}

void FramePlan::record(JobSystem& jobs, CommandBuffer& out) {
    if (recordings_.size() < kept_.size()) recordings_.resize(kept_.size());
    jobs.forRanges(uint32_t(kept_.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t k = begin; k < end; ++k) {
            recordings_[k].clear();
            recordPass(k, recordings_[k]);
        }
    });
    for (uint32_t k = 0; k < kept_.size(); ++k) out.append(recordings_[k]);
}

}  // namespace rushlight
