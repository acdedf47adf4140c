#include "renderer/capture/image_files.h"
#include "renderer/capture/write_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

class ImageFiles : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  ("rushlight-" + std::to_string(getpid()) + "-" + test->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string at(const char* name) const { return folder_ / name; }

    fs::path folder_;
};

struct Image8 {
    uint32_t width, height;
    std::vector<uint8_t> rgba8;
    std::vector<float> rgba32f;
};

Image8 gradient(uint32_t width, uint32_t height, bool opaque) {
    Image8 image{width, height, {}, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t value : {x * 3, y * 5, x ^ y, opaque ? 255 : 100 + x})
                image.rgba8.push_back(uint8_t(value));
    return image;
}

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(ImageFiles, PngComesBackExactly) {
    const Image8 image = gradient(37, 21, true);
    ASSERT_TRUE(saveImage(at("a.png"), PictureView(image)));
    const auto loaded = loadPicture(at("a.png"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ(loaded->width, 37u);
    EXPECT_EQ(loaded->height, 21u);
    EXPECT_FALSE(loaded->linear);
    ASSERT_EQ(loaded->rgba.size(), image.rgba8.size());
    for (size_t i = 0; i < image.rgba8.size(); ++i)
        ASSERT_EQ(std::lround(loaded->rgba[i] * 255), image.rgba8[i]) << i;
}

TEST_F(ImageFiles, PngKeepsStraightAlphaAndLoadsPremultiplied) {
    const Image8 image = gradient(8, 8, false);
    ASSERT_TRUE(saveImage(at("a.png"), PictureView(image)));
    const auto loaded = loadPicture(at("a.png"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    for (size_t i = 0; i < image.rgba8.size(); i += 4) {
        const float alpha = float(image.rgba8[i + 3]) / 255;
        ASSERT_FLOAT_EQ(loaded->rgba[i + 3], alpha);
        ASSERT_NEAR(loaded->rgba[i], float(image.rgba8[i]) / 255 * alpha, 1e-6);
    }
}

// Two pixels of grey and alpha: 100, 51 and 200, 255.
TEST_F(ImageFiles, GreyWithAlphaKeepsBoth) {
    constexpr unsigned char kPng[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x04, 0x00, 0x00,
        0x00, 0x5e, 0x2b, 0xb7, 0x01, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9c, 0x63, 0x48, 0x31, 0x3e, 0xf1, 0x1f, 0x00, 0x04, 0xbd, 0x02, 0x5f, 0x9d, 0x0c,
        0x59, 0xed, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    std::ofstream(at("grey.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(kPng), sizeof kPng);
    const auto picture = loadPicture(at("grey.png"));
    ASSERT_TRUE(picture) << picture.error().text();
    const float expected[] = {100, 100, 100, 51, 200, 200, 200, 255};
    ASSERT_EQ(picture->rgba.size(), 8u);
    for (size_t i = 0; i < 8; ++i) {
        const float alpha = expected[i | 3] / 255;
        EXPECT_NEAR(picture->rgba[i], i % 4 == 3 ? alpha : expected[i] / 255 * alpha, 1e-4f) << i;
    }
}

TEST_F(ImageFiles, OpaquePngHasNoAlphaChannel) {
    // Byte 25 of a PNG is its colour type: 2 RGB, 6 RGBA (PNG specification, 11.2.2).
    for (const bool opaque : {true, false}) {
        ASSERT_TRUE(saveImage(at("a.png"), PictureView(gradient(4, 4, opaque))));
        EXPECT_EQ(contents(at("a.png")).at(25), opaque ? 2 : 6);
    }
}

TEST_F(ImageFiles, OpaqueExrHasNoAlphaChannel) {
    for (const float alpha : {1.0f, 0.5f}) {
        const Image8 image{2, 1, {}, {0.25f, 3, 1, 1, 0.5f, 0.25f, 0.125f, alpha}};
        ASSERT_TRUE(saveImage(at("a.exr"), PictureView(image)));
        EXPECT_EQ(loadPicture(at("a.exr"))->rgba, image.rgba32f);
        // OpenEXR's list of channels: each name, a zero and 16 bytes.
        const std::string file = contents(at("a.exr"));
        const auto channels = file.find(std::string("chlist\0", 7));
        ASSERT_NE(channels, std::string::npos);
        EXPECT_EQ(file[channels + 11], alpha < 1 ? 'A' : 'B');
    }
}

TEST_F(ImageFiles, EffortChangesTheSizeAndNoPixel) {
    Image8 display = gradient(64, 64, false), linear{64, 64, {}, {}};
    for (uint8_t value : display.rgba8) linear.rgba32f.push_back(float(value) / 16);
    for (const auto& [name, image] : {std::pair("a.png", &display), std::pair("a.exr", &linear)}) {
        size_t last = SIZE_MAX;
        std::vector<float> pixels;
        for (const EncodeEffort effort :
             {EncodeEffort::none, EncodeEffort::fast, EncodeEffort::small}) {
            ASSERT_TRUE(saveImage(at(name), PictureView(*image), effort));
            const size_t size = contents(at(name)).size();
            EXPECT_LE(size, last) << name << " " << int(effort);
            EXPECT_EQ(size > 64u * 64 * 4, effort == EncodeEffort::none) << name;
            last = size;
            const auto loaded = loadPicture(at(name));
            if (pixels.empty()) pixels = loaded->rgba;
            EXPECT_EQ(loaded->rgba, pixels);
        }
    }
}

TEST_F(ImageFiles, ExrKeepsRangeAndPremultipliedAlpha) {
    const Image8 image{2, 1, {}, {0.25f, 1000, -2, 0.5f, 65504, 0, 1, 0}};
    ASSERT_TRUE(saveImage(at("a.exr"), PictureView(image)));
    const auto loaded = loadPicture(at("a.exr"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_TRUE(loaded->linear);
    EXPECT_EQ(loaded->rgba, image.rgba32f);
}

TEST_F(ImageFiles, ExrTurnsToFloatsWhenAHalfIsTooSmall) {
    const Image8 image{1, 1, {}, {1e6f, 0.1f, 0, 1}};
    ASSERT_TRUE(saveImage(at("a.exr"), PictureView(image)));
    EXPECT_EQ(loadPicture(at("a.exr"))->rgba, image.rgba32f);
}

TEST_F(ImageFiles, JpegIsCloseAndOverBlack) {
    Image8 image{16, 16, {}, {}};
    for (int i = 0; i < 256; ++i) image.rgba8.insert(image.rgba8.end(), {200, 100, 50, 128});
    ASSERT_TRUE(saveImage(at("a.jpg"), PictureView(image)));
    const auto loaded = loadPicture(at("a.jpg"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_NEAR(loaded->rgba[0] * 255, 100, 3);
    EXPECT_NEAR(loaded->rgba[1] * 255, 50, 3);
    EXPECT_EQ(loaded->rgba[3], 1);
}

TEST_F(ImageFiles, EqualPicturesGiveEqualBytesAtAnyTime) {
    const Image8 image = gradient(64, 64, true);
    const Image8 floats{2, 1, {}, {0, 1, 2, 1, 3, 4, 5, 1}};
    const auto png = encodeImage("a", ImageFormat::png, PictureView(image));
    const auto jpeg = encodeImage("a", ImageFormat::jpeg, PictureView(image));
    const auto exr = encodeImage("a", ImageFormat::exr, PictureView(floats));
    ASSERT_TRUE(png && jpeg && exr);
    sleep(1);  // dates in files have seconds
    EXPECT_EQ(*png, *encodeImage("b", ImageFormat::png, PictureView(image)));
    EXPECT_EQ(*jpeg, *encodeImage("b", ImageFormat::jpeg, PictureView(image)));
    EXPECT_EQ(*exr, *encodeImage("b", ImageFormat::exr, PictureView(floats)));
}

TEST_F(ImageFiles, AWrongExtensionOrKindIsWrongUse) {
    const Image8 image = gradient(4, 4, true);
    const auto extension = saveImage(at("a.bmp"), PictureView(image));
    ASSERT_FALSE(extension);
    EXPECT_EQ(extension.error().kind, ErrorKind::wrongUse);
    const auto kind = saveImage(at("a.exr"), PictureView(image));
    ASSERT_FALSE(kind);
    EXPECT_EQ(kind.error().kind, ErrorKind::wrongUse);
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(ImageFiles, AFailureKeepsTheOldFileAndLeavesNoOther) {
    ASSERT_TRUE(writeFile(at("sub/a.txt"), "old"));
    EXPECT_FALSE(writeFile(at("sub"), "new"));
    const auto nowhere = writeFile(at("sub/a.txt/b.txt"), "new");
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().message.find("could not be written"), std::string::npos);
    EXPECT_EQ(contents(at("sub/a.txt")), "old");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder_), {}), 2);
}

TEST_F(ImageFiles, AFullDiskIsAnErrorAndTheDeviceStays) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const auto full = writeFile("/dev/full", "text");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.find("No space left"), std::string::npos);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(ImageFiles, ALinkIsFollowed) {
    ASSERT_TRUE(writeFile(at("real.txt"), "old"));
    fs::create_symlink("real.txt", at("link.txt"));
    ASSERT_TRUE(writeFile(at("link.txt"), "new"));
    EXPECT_TRUE(fs::is_symlink(at("link.txt")));
    EXPECT_EQ(contents(at("real.txt")), "new");
}

TEST_F(ImageFiles, DamagedAndMissingFilesAreErrors) {
    ASSERT_TRUE(saveImage(at("a.png"), PictureView(gradient(64, 64, true))));
    const std::string whole = contents(at("a.png"));
    ASSERT_TRUE(writeFile(at("half.png"), whole.substr(0, whole.size() / 2)));
    ASSERT_TRUE(writeFile(at("text.png"), "hello"));
    for (const char* name : {"half.png", "text.png", "missing.png"}) {
        const auto loaded = loadPicture(at(name));
        ASSERT_FALSE(loaded) << name;
        EXPECT_EQ(loaded.error().kind, ErrorKind::badInput);
        EXPECT_EQ(loaded.error().message.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace rushlight
