#include "engine/assets/image.h"

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace rushlight::assets {
namespace {

/// Writes pixels with OpenImageIO and reads the file's bytes back.
template <class T>
std::vector<uint8_t> encode(const std::string& extension, int width, int height, int channels,
                            OIIO::TypeDesc type, const std::vector<T>& pixels) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const auto path = std::filesystem::temp_directory_path() /
                      (std::string("rushlight_image_") + info->name() + "." + extension);
    auto out = OIIO::ImageOutput::create(path.string());
    OIIO::ImageSpec spec(width, height, channels, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("Compression", extension == "webp" ? "lossless" : "");
    EXPECT_TRUE(out && out->open(path.string(), spec) && out->write_image(type, pixels.data()) &&
                out->close());
    std::ifstream stream(path, std::ios::binary);
    std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove(path);
    return bytes;
}

TEST(AssetsImage, PngKeepsStraightAlpha) {
    const auto bytes = encode<uint8_t>("png", 2, 1, 4, OIIO::TypeDesc::UINT8,
                                       {200, 100, 50, 0, 10, 20, 30, 128});
    const auto image = decodeImage("a.png", bytes);
    ASSERT_TRUE(image.has_value()) << image.error().text();
    EXPECT_EQ(image->pixels, (std::vector<uint8_t>{200, 100, 50, 0, 10, 20, 30, 128}));
}

TEST(AssetsImage, GreyAndSixteenBitBecomeRgba8) {
    const auto grey = decodeImage("g",
                                  encode<uint8_t>("png", 2, 1, 1, OIIO::TypeDesc::UINT8, {7, 9}));
    ASSERT_TRUE(grey.has_value()) << grey.error().text();
    EXPECT_EQ(grey->pixels, (std::vector<uint8_t>{7, 7, 7, 255, 9, 9, 9, 255}));
    const auto both = decodeImage("ga",
                                  encode<uint8_t>("png", 1, 1, 2, OIIO::TypeDesc::UINT8, {70, 40}));
    ASSERT_TRUE(both.has_value()) << both.error().text();
    EXPECT_EQ(both->pixels, (std::vector<uint8_t>{70, 70, 70, 40}));
    const auto wide = decodeImage(
        "w", encode<uint16_t>("png", 1, 1, 3, OIIO::TypeDesc::UINT16, {65535, 0, 32896}));
    ASSERT_TRUE(wide.has_value()) << wide.error().text();
    EXPECT_EQ(wide->pixels, (std::vector<uint8_t>{255, 0, 128, 255}));
}

TEST(AssetsImage, JpegAndWebp) {
    const std::vector<uint8_t> flat(16 * 16 * 3, 120);
    for (const char* extension : {"jpg", "webp"}) {
        const auto image = decodeImage(
            extension, encode<uint8_t>(extension, 16, 16, 3, OIIO::TypeDesc::UINT8, flat));
        ASSERT_TRUE(image.has_value()) << image.error().text();
        EXPECT_EQ(image->width, 16u);
        EXPECT_NEAR(image->pixels[0], 120, 2);
        EXPECT_EQ(image->pixels[3], 255);
    }
}

TEST(AssetsImage, TruncatedFilesAreRefusedByName) {
    std::vector<uint8_t> noise(64 * 64 * 3);
    for (size_t i = 0; i < noise.size(); ++i) noise[i] = uint8_t(i * 2654435761u >> 13);
    for (const char* extension : {"png", "jpg", "webp"}) {
        auto bytes = encode<uint8_t>(extension, 64, 64, 3, OIIO::TypeDesc::UINT8, noise);
        ASSERT_TRUE(decodeImage("whole", bytes).has_value()) << extension;
        bytes.resize(bytes.size() / 2);
        const auto image = decodeImage("half", bytes);
        ASSERT_FALSE(image.has_value()) << extension;
        EXPECT_EQ(image.error().object, "image 'half'");
    }
}

TEST(AssetsImage, RefusesWhatIsTooLargeOrNoImage) {
    const auto bytes = encode<uint8_t>("png", 8, 4, 1, OIIO::TypeDesc::UINT8,
                                       std::vector<uint8_t>(32));
    EXPECT_FALSE(decodeImage("a", bytes, {.maxSide = 7}).has_value());
    EXPECT_FALSE(decodeImage("a", bytes, {.maxPixels = 31}).has_value());
    EXPECT_TRUE(decodeImage("a", bytes, {.maxSide = 8, .maxPixels = 32}).has_value());
    EXPECT_FALSE(decodeImage("a", {}).has_value());
    const std::vector<uint8_t> text{'h', 'e', 'l', 'l', 'o'};
    EXPECT_FALSE(decodeImage("a", text).has_value());
}

void writeBytes(const std::filesystem::path& path, const std::vector<uint8_t>& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

TEST(AssetsImage, HdrIsFiniteAndNotNegative) {
    const auto path = std::filesystem::temp_directory_path() / "rushlight_environment_test.exr";
    writeBytes(path, encode<float>("exr", 2, 1, 3, OIIO::TypeDesc::FLOAT, {1, 20, 3, -4, 0, 0.5f}));
    const auto image = loadHdr(path);
    ASSERT_TRUE(image.has_value()) << image.error().text();
    EXPECT_EQ(image->pixels[0], vec3(1, 20, 3));
    EXPECT_EQ(image->pixels[1], vec3(0, 0, 0.5f));
    const float inf = std::numeric_limits<float>::infinity();
    writeBytes(path, encode<float>("exr", 1, 1, 3, OIIO::TypeDesc::FLOAT, {1, inf, 3}));
    const auto broken = loadHdr(path);
    ASSERT_FALSE(broken.has_value());
    EXPECT_NE(broken.error().message.find("not finite"), std::string::npos);
    std::filesystem::remove(path);
    EXPECT_FALSE(loadHdr(path).has_value());
}

}  // namespace
}  // namespace rushlight::assets
