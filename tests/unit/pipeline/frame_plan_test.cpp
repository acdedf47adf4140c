#include "renderer/plan/frame_plan.h"

#include "tests/support/memory_device.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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
        PassBuilder pass = plan.addPass(name);
        for (ImageId write : writes) pass.color(write, load);
        for (ImageId read : reads) pass.sample(0, read, {});
    }
    void present(const char* name, std::initializer_list<ImageId> reads) {
        PassBuilder pass = plan.addPass(name);
        pass.frameTarget(64, 32);
        for (ImageId read : reads) pass.sample(0, read, {});
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
    plan.addPass("overlay").frameTarget(64, 32).depthTest(image("depth", Format::depth32f));
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
            PassBuilder pass = plan.addPass("pass");
            pass.color(images[p]);
            for (ImageId from : read) pass.sample(0, from, {});
        }
        // Everything is needed: a last pass reads what nobody read.
        std::vector<ImageId> last;
        for (size_t i = 0; i < count; ++i)
            if (uses[i].last == i) {
                last.push_back(images[i]);
                uses[i].last = count;
            }
        PassBuilder end = plan.addPass("end");
        end.frameTarget(64, 32);
        for (ImageId image : last) end.sample(0, image, {});
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
    const auto record = +[](const uint32_t& vertices, CommandBuffer& commands) {
        commands.push(Draw{0, vertices, 1});
    };
    plan.addPass("first").color(a).record(uint32_t(11), record);
    plan.addPass("second").frameTarget(64, 32).sample(3, a, {}).record(uint32_t(22), record);
    ASSERT_TRUE(plan.compile());
    CommandBuffer out;
    plan.record(jobs, out);
    const std::string text = print(out);
    const size_t begin1 = text.find("first"), draw1 = text.find("11"), begin2 = text.find("second"),
                 draw2 = text.find("22");
    ASSERT_NE(draw2, std::string::npos) << text;
    EXPECT_TRUE(begin1 < draw1 && draw1 < begin2 && begin2 < draw2) << text;
}

// The call that declares makes the binding.
TEST_F(FramePlanTest, WhatIsDeclaredIsBound) {
    const auto owned = device.createTexture({"owned", TextureKind::texture2d, Format::r32f, 1, 1});
    plan.begin();
    const ImageId a = image("a");
    pass("makes a", {}, {a});
    PassBuilder reader = plan.addPass("reads a");
    reader.frameTarget(64, 32).sample(5, a, {}).texture(6, *owned, {});
    reader.sample(7, {}, {}).texels(8, Format::r32ui, {}).uniforms(2, {});
    ASSERT_TRUE(plan.compile());
    CommandBuffer out;
    plan.record(jobs, out);
    const std::string text = print(out);
    EXPECT_NE(text.find("BindTexture 5 "), std::string::npos) << text;
    EXPECT_NE(text.find("BindTexture 6 "), std::string::npos) << text;
    EXPECT_EQ(text.find("BindTexture 7 "), std::string::npos) << "a null image is ignored";
    EXPECT_EQ(text.find("BindTexelBuffer"), std::string::npos) << "and an empty range";
    EXPECT_EQ(text.find("BindUniforms"), std::string::npos);
}

TEST_F(FramePlanTest, AWantedImageIsKeptAsItWasPublished) {
    plan.begin();
    plan.want("lit");
    EXPECT_TRUE(plan.wants("lit"));
    EXPECT_FALSE(plan.wants("fog"));
    const ImageId radiance = image("radiance"), fog = image("fog");
    pass("lighting", {}, {radiance});
    plan.publish("lit", radiance);
    pass("fog", {}, {fog});
    pass("fog over it", {fog}, {radiance}, LoadOp::keep);
    plan.publish("foggy", radiance);
    present("shows it", {plan.find("lit")});
    ASSERT_TRUE(plan.compile());
    EXPECT_EQ(keptPasses(), (Names{"lighting", "shows it"}));
    EXPECT_FALSE(plan.find("nobody's"));

    plan.begin();
    EXPECT_FALSE(plan.wants("lit")) << "of the frame before";
}

TEST_F(FramePlanTest, AnOrderByASeedKeepsWhatDependsInOrder) {
    std::set<Names> orders;
    for (uint64_t seed = 0; seed < 200; ++seed) {
        plan.begin();
        const ImageId map = plan.createImage({"map", Format::depth32f, 64, 64, 2});
        const ImageId a = image("a"), b = image("b"), sum = image("sum");
        plan.addPass("map.0").depth(map, LoadOp::clear, 0);
        plan.addPass("map.1").depth(map, LoadOp::clear, 1);
        pass("a", {map}, {a});
        pass("b", {}, {b});
        pass("sum", {a}, {sum});
        pass("more", {b}, {sum}, LoadOp::keep);
        pass("b again", {}, {b});
        present("shows", {sum, b});
        present("over it", {});
        ASSERT_TRUE(plan.compile(seed));
        const Names order = keptPasses();
        ASSERT_EQ(order.size(), 9u);
        const auto place = [&](const char* name) {
            return std::ranges::find(order, name) - order.begin();
        };
        EXPECT_LT(std::max(place("map.0"), place("map.1")), place("a"));
        EXPECT_LT(place("a"), place("sum"));
        EXPECT_LT(place("sum"), place("more")) << "it adds to it";
        EXPECT_LT(place("b"), place("more"));
        EXPECT_LT(place("more"), place("b again")) << "it is read before";
        EXPECT_EQ(place("shows"), 7) << "it reads both";
        EXPECT_EQ(place("over it"), 8) << "both draw into the frame";
        orders.insert(order);
    }
    EXPECT_EQ(orders.size(), 10u) << "all that there are";
}

}  // namespace
}  // namespace rushlight
