// PNG files as they are written: the same pixels come back, by a decoder that is not ours.
#include <cstring>
#include <gmock/gmock.h>
#include <image/png_filter.hpp>
#include <image/png_reader.hpp>
#include <image/png_writer.hpp>
#include <random>
#include <string>

namespace prelight {
namespace {

std::span<const uint8_t> bytes_of(const std::vector<std::byte>& file) {
    return {reinterpret_cast<const uint8_t*>(file.data()), file.size()};
}

/// Soft with some noise, so that each filter is the best one somewhere, and a part that is one colour.
std::vector<uint8_t> picture(uint32_t width, uint32_t height, uint32_t channels) {
    std::vector<uint8_t> pixels;
    std::mt19937 random(7);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t c = 0; c < channels; ++c)
                pixels.push_back(static_cast<uint8_t>(y % 7 == 3   ? random()
                                                      : y % 7 == 5 ? 90
                                                                   : 3 * x + (c + 1) * y + random() % (1 + y % 3)));
    return pixels;
}

std::vector<uint8_t> rgba_of(const std::vector<uint8_t>& pixels, uint32_t channels) {
    std::vector<uint8_t> rgba;
    for (size_t i = 0; i < pixels.size(); i += channels) {
        const bool grey = channels < 3, alpha = channels % 2 == 0;
        for (size_t c = 0; c < 3; ++c)
            rgba.push_back(pixels[i + (grey ? 0 : c)]);
        rgba.push_back(alpha ? pixels[i + channels - 1] : 255);
    }
    return rgba;
}

TEST(PngWriter, GivesThePixelsBack) {
    // 700 × 400 is filtered in several bands.
    const std::pair<uint32_t, uint32_t> sizes[]{{1, 1}, {1, 9}, {9, 1}, {17, 13}, {700, 400}};
    for (const auto& [width, height] : sizes)
        for (uint32_t channels = 1; channels <= 4; ++channels) {
            SCOPED_TRACE(testing::Message() << width << "x" << height << ", " << channels << " channels");
            const std::vector<uint8_t> pixels = picture(width, height, channels);
            const std::vector<std::byte> file = encode_png(width, height, channels, pixels);
            PngReader reader(bytes_of(file));
            ASSERT_EQ(reader.width(), width);
            ASSERT_EQ(reader.height(), height);
            std::vector<uint8_t> back(size_t(width) * height * 4);
            for (uint32_t y = 0; y < height; ++y)
                reader.read_row(&back[size_t(y) * width * 4]);
            EXPECT_TRUE(back == rgba_of(pixels, channels));
        }
}

TEST(PngWriter, WritesHeaderDataAndEnd) {
    const std::vector<std::byte> file = encode_png(8, 8, 3, picture(8, 8, 3));
    std::vector<std::string> chunks;
    for (size_t at = 8; at + 8 <= file.size();) {
        uint32_t length = 0;
        for (size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<uint32_t>(file[at + i]);
        chunks.emplace_back(reinterpret_cast<const char*>(&file[at + 4]), 4);
        at += length + 12;
        if (chunks.back() == "IEND") {
            EXPECT_EQ(at, file.size());
        }
    }
    EXPECT_THAT(chunks, testing::ElementsAre("IHDR", "IDAT", "IEND"));
    EXPECT_THROW(encode_png(8, 8, 3, picture(8, 7, 3)), std::invalid_argument);
    EXPECT_THROW(encode_png(8, 8, 5, picture(8, 8, 5)), std::invalid_argument);
    EXPECT_THROW(encode_png(0, 8, 3, {}), std::invalid_argument);
}

/// What the filters are for: rows alike, slopes and noise each by a filter of its own.
TEST(PngWriter, FiltersEachRowByWhatLeavesLeast) {
    const std::vector<uint8_t> above{10, 200, 30, 90, 60, 250, 120, 8}, zeros(8);
    const auto filtered = [](const std::vector<uint8_t>& row, const std::vector<uint8_t>& over) {
        std::vector<uint8_t> out(row.size() + 1);
        PngRowFilter filter(1);
        filter(row, over, out);
        return out;
    };
    EXPECT_THAT(filtered({1, 255, 1, 0, 255, 1, 0, 1}, above), testing::ElementsAre(0, 1, 255, 1, 0, 255, 1, 0, 1));
    EXPECT_THAT(filtered({50, 51, 52, 53, 54, 55, 56, 57}, zeros), testing::ElementsAre(1, 50, 1, 1, 1, 1, 1, 1, 1));
    EXPECT_THAT(filtered(above, above), testing::ElementsAre(2, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(filtered({5, 102, 66, 78, 69, 159, 139, 73}, above), testing::ElementsAre(3, 0, 0, 0, 0, 0, 0, 0, 0));
    // First as on the left, from the middle on as above.
    EXPECT_THAT(filtered({200, 200, 200, 200, 200, 90, 200, 90}, {40, 40, 90, 40, 200, 90, 200, 90}),
                testing::ElementsAre(4, 160, 0, 0, 0, 0, 0, 0, 0));
}

} // namespace
} // namespace prelight
