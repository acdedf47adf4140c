#include "renderer/plan/frame_plan.h"

#include "tests/support/memory_device.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class FramePlanTest : public testing::Test {
protected:
    MemoryDevice device;
    FramePlan plan{device};
    SerialJobs jobs;

    ImageId image(const char* name, Format format = Format::rgba8) {
        return plan.createImage({name, format, 64, 32});
    }
    void pass(const char* name, std::initializer_list<ImageId> reads,
              std::initializer_list<ImageId> writes, LoadOp load = LoadOp::discard) {
        std::vector<PassTargets::Color> colors;
        for (ImageId write : writes) colors.push_back({write, load});
        PassTargets targets;
        targets.colors = colors;
        targets.reads = {reads.begin(), reads.size()};
        add(name, targets);
    }
    void present(const char* name, std::initializer_list<ImageId> reads) {
        PassTargets targets;
        targets.reads = {reads.begin(), reads.size()};
        targets.toFrameTarget = true;
        targets.frameWidth = 64;
        targets.frameHeight = 32;
        add(name, targets);
    }
    void add(const char* name, const PassTargets& targets) {
        plan.addPass(
            name, targets, 0, +[](const int&, PassContext&) {});
    }
    std::vector<std::string> keptPasses() const {
        std::vector<std::string> names;
        for (uint32_t i = 0; i < plan.keptPassCount(); ++i) names.push_back(plan.passName(i));
        return names;
    }
};
using Names = std::vector<std::string>;

TEST_F(FramePlanTest, ReadingWhatNobodyWroteIsAnErrorThatNamesBoth) {
    plan.begin();
    present("tonemap", {image("radiance")});
    const auto compiled = plan.compile();
    ASSERT_FALSE(compiled);
    EXPECT_EQ(compiled.error().kind, ErrorKind::wrongUse);
    EXPECT_NE(compiled.error().text().find("tonemap"), std::string::npos);
    EXPECT_NE(compiled.error().text().find("radiance"), std::string::npos);
}

TEST_F(FramePlanTest, ALaterWriterIsTooLate) {
    plan.begin();
    const ImageId radiance = image("radiance");
    present("tonemap", {radiance});
    pass("lighting", {}, {radiance});
    EXPECT_FALSE(plan.compile());
}

TEST_F(FramePlanTest, KeepingATargetNeedsAnEarlierWriterToo) {
    plan.begin();
    pass("forward", {}, {image("radiance")}, LoadOp::keep);
    const auto compiled = plan.compile();
    ASSERT_FALSE(compiled);
    EXPECT_NE(compiled.error().text().find("forward"), std::string::npos);

    plan.begin();
    PassTargets targets;
    targets.depth = {image("depth", Format::depth32f), LoadOp::keep, 0, true};
    targets.toFrameTarget = true;
    add("overlay", targets);
    EXPECT_FALSE(plan.compile());
}

TEST_F(FramePlanTest, PassesThatNobodyNeedsAreDropped) {
    plan.begin();
    const ImageId a = image("a"), b = image("b"), unused = image("unused"), chain = image("chain");
    pass("makes a", {}, {a});
    pass("makes chain", {a}, {chain});
    pass("makes unused", {chain}, {unused});
    pass("makes b", {a}, {b});
    present("shows b", {b});
    ASSERT_TRUE(plan.compile());
    EXPECT_EQ(keptPasses(), (Names{"makes a", "makes b", "shows b"}));
    EXPECT_FALSE(plan.texture(unused)) << "what is dropped gets no memory";
}

TEST_F(FramePlanTest, RequestedAndImportedImagesAreNeeded) {
    const auto owned = device.createTexture({"owned", TextureKind::texture2d, Format::r32f, 1, 1});
    plan.begin();
    const ImageId captured = image("captured"), dropped = image("dropped");
    const ImageId kept = plan.importImage({"kept", Format::r32f, 1, 1}, *owned);
    pass("captures", {}, {captured});
    pass("drops", {}, {dropped});
    pass("keeps", {}, {kept});
    plan.requestImage(captured);
    ASSERT_TRUE(plan.compile());
    EXPECT_EQ(keptPasses(), (Names{"captures", "keeps"}));
    EXPECT_EQ(plan.texture(kept), *owned);
}

TEST_F(FramePlanTest, ImportedImagesCanBeReadAtOnceAndOutliveThePlan) {
    const auto owned = device.createTexture({"owned", TextureKind::texture2d, Format::r32f, 1, 1});
    for (int frame = 0; frame < 20; ++frame) {
        plan.begin();
        present("reads", {plan.importImage({"last frame", Format::r32f, 1, 1}, *owned)});
        ASSERT_TRUE(plan.compile());
    }
    EXPECT_TRUE(device.textures.contains(*owned));
}

TEST_F(FramePlanTest, ImagesWhoseLivesDoNotOverlapShareATexture) {
    plan.begin();
    std::vector<ImageId> chain;
    for (const char* name : {"0", "1", "2", "3", "4", "5"}) chain.push_back(image(name));
    pass("first", {}, {chain[0]});
    for (size_t i = 1; i < chain.size(); ++i) pass("next", {chain[i - 1]}, {chain[i]});
    present("last", {chain.back()});
    ASSERT_TRUE(plan.compile());
    EXPECT_EQ(device.textures.size(), 2u);
    for (size_t i = 1; i < chain.size(); ++i)
        EXPECT_NE(plan.texture(chain[i]), plan.texture(chain[i - 1])) << "read while written";
}

// Random plans: two images that some pass needs at the same time, or between their first and last
// uses, never share.
TEST_F(FramePlanTest, LivingImagesNeverShareATexture) {
    Random generator(1);
    const auto random = [&](uint32_t end) { return generator.below(end); };
    for (int trial = 0; trial < 200; ++trial) {
        plan.begin();
        std::vector<ImageId> images;
        struct Use {
            size_t first, last;
        };
        std::vector<Use> uses;
        std::vector<std::vector<size_t>> reads;
        const size_t count = 3 + random(10);
        for (size_t p = 0; p < count; ++p) {
            images.push_back(image("image", random(3) ? Format::rgba8 : Format::r32f));
            uses.push_back({p, p});
            std::vector<ImageId> read;
            for (size_t r = 0; p > 0 && r < 2; ++r) {
                const size_t from = random(uint32_t(p));
                read.push_back(images[from]);
                uses[from].last = p;
            }
            PassTargets targets;
            const PassTargets::Color color{images[p]};
            targets.colors = {&color, 1};
            targets.reads = read;
            targets.toFrameTarget = false;
            add("pass", targets);
        }
        // Everything is needed: a last pass reads what nobody read.
        std::vector<ImageId> last;
        for (size_t i = 0; i < count; ++i)
            if (uses[i].last == i && last.size() < FramePlan::kMaxReads) {
                last.push_back(images[i]);
                uses[i].last = count;
            }
        PassTargets end;
        end.reads = last;
        end.toFrameTarget = true;
        add("end", end);
        ASSERT_TRUE(plan.compile());
        ASSERT_EQ(plan.keptPassCount(), count + 1);
        for (size_t a = 0; a < count; ++a)
            for (size_t b = a + 1; b < count; ++b)
                if (uses[b].first <= uses[a].last) {
                    ASSERT_NE(plan.texture(images[a]), plan.texture(images[b])) << trial;
                }
    }
}

TEST_F(FramePlanTest, ARequestedImageIsNotGivenToAnother) {
    plan.begin();
    const ImageId a = image("a"), b = image("b"), c = image("c");
    pass("makes a", {}, {a});
    pass("makes b", {a}, {b});
    pass("makes c", {b}, {c});
    present("shows c", {c});
    plan.requestImage(a);
    ASSERT_TRUE(plan.compile());
    EXPECT_NE(plan.texture(c), plan.texture(a));
    EXPECT_NE(plan.texture(b), plan.texture(a));
}

TEST_F(FramePlanTest, FramesReuseTexturesAndGiveUnusedOnesBack) {
    const auto frame = [&](Format format) {
        plan.begin();
        const ImageId a = image("a", format);
        pass("makes a", {}, {a});
        present("shows a", {a});
        ASSERT_TRUE(plan.compile());
    };
    for (int i = 0; i < 5; ++i) frame(Format::rgba8);
    EXPECT_EQ(device.textures.size(), 1u);
    for (int i = 0; i < 20; ++i) frame(Format::r32f);
    ASSERT_EQ(device.textures.size(), 1u);
    EXPECT_EQ(device.textures.begin()->second.format, Format::r32f);
}

TEST_F(FramePlanTest, PassesAreRecordedOnceInOrderWithTheirPayloads) {
    plan.begin();
    const ImageId a = image("a");
    const auto record = +[](const uint32_t& vertices, PassContext& context) {
        context.commands.push(Draw{0, vertices, 1});
    };
    const PassTargets::Color color{a};
    PassTargets first;
    first.colors = {&color, 1};
    plan.addPass("first", first, uint32_t(11), record);
    PassTargets second;
    second.reads = {&a, 1};
    second.toFrameTarget = true;
    plan.addPass("second", second, uint32_t(22), record);
    ASSERT_TRUE(plan.compile());
    CommandBuffer out;
    plan.record(jobs, out);
    const std::string text = print(out);
    const size_t begin1 = text.find("first"), draw1 = text.find("11"), begin2 = text.find("second"),
                 draw2 = text.find("22");
    ASSERT_NE(draw2, std::string::npos) << text;
    EXPECT_TRUE(begin1 < draw1 && draw1 < begin2 && begin2 < draw2) << text;
}

TEST_F(FramePlanTest, TouchingAnUndeclaredImageStopsTheProgram) {
    plan.begin();
    const ImageId a = image("a");
    pass("makes a", {}, {a});
    PassTargets targets;
    targets.toFrameTarget = true;
    plan.addPass(
        "thief", targets, a, +[](const ImageId& id, PassContext& context) { context.texture(id); });
    ASSERT_TRUE(plan.compile());
    CommandBuffer out;
    EXPECT_DEATH(plan.record(jobs, out), "did not declare");
}

}  // namespace
}  // namespace rushlight
