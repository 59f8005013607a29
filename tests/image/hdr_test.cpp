#include "temporary_folder.hpp"
#include <cstdint>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/image.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;

std::string bytes(std::initializer_list<int> values) {
    std::string out;
    for (const int value : values)
        out.push_back(static_cast<char>(value));
    return out;
}

Image load(const std::string& content) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "a.hdr", std::ios::binary) << content;
    return load_hdr(folder.path / "a.hdr");
}

std::string error_of(const std::string& content) {
    try {
        load(content);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

const std::string head = "#?RADIANCE\n# comment\nFORMAT=32-bit_rle_rgbe\n\n";

TEST(Hdr, FlatPixelsAreMantissaTimesPowerOfTwo) {
    const Image image = load(head + "-Y 1 +X 3\n" + bytes({128, 64, 0, 129, 255, 255, 255, 137, 9, 9, 9, 0}));
    EXPECT_EQ(image.at(0, 0), glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(image.at(1, 0), glm::vec3(510));
    EXPECT_EQ(image.at(2, 0), glm::vec3(0));
}

TEST(Hdr, RunsOfBothKindsAreTakenApart) {
    // Ten pixels: red in a run, green pixel by pixel, blue in two runs.
    const std::string row =
        bytes({2, 2, 0, 10, 138, 128, 10, 0, 16, 32, 48, 64, 80, 96, 112, 128, 144, 132, 64, 134, 32, 138, 129});
    const Image image = load(head + "-Y 2 +X 10\n" + row + row);
    for (uint32_t y = 0; y < 2; ++y)
        for (uint32_t x = 0; x < 10; ++x)
            EXPECT_EQ(image.at(x, y), glm::vec3(1, x / 8.0f, x < 4 ? 0.5f : 0.25f)) << x;
    // The older way: 1 1 1 N repeats the pixel before.
    const Image old = load(head + "-Y 1 +X 7\n" + bytes({128, 0, 0, 129, 1, 1, 1, 5, 0, 128, 0, 129}));
    EXPECT_EQ(old.at(5, 0), glm::vec3(1, 0, 0));
    EXPECT_EQ(old.at(6, 0), glm::vec3(0, 1, 0));
}

TEST(Hdr, ExposureOfTheHeaderIsDividedOut) {
    const Image image = load("#?RGBE\nEXPOSURE=2\nEXPOSURE= 4.0\n\n-Y 1 +X 1\n" + bytes({128, 128, 128, 132}));
    EXPECT_EQ(image.at(0, 0), glm::vec3(1));
}

TEST(Hdr, WhatIsWrongIsSaidInOneLine) {
    EXPECT_THAT(error_of("\x89PNG"), HasSubstr("a.hdr: not a Radiance picture"));
    EXPECT_THAT(error_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd"),
                HasSubstr("its pixels are not RGBE"));
    EXPECT_THAT(error_of("#?RADIANCE\nEXPOSURE=no\n\n-Y 1 +X 1\nabcd"), HasSubstr("EXPOSURE is no number above 0"));
    for (const char* size :
         {"+Y 1 +X 1", "-Y 0 +X 1", "-Y 1 +X 99999", "-Y 60000 +X 60000", "-Y 1", "-Y 1 +X 1 ", "-Y -3 +X 1"})
        EXPECT_THAT(error_of(head + size + "\nabcd"), HasSubstr("a size as this is not read")) << size;
    EXPECT_THAT(error_of(head + "-Y 1 +X 2\nabcdef"), HasSubstr("ends too early"));
    EXPECT_THAT(error_of(head + "-Y 8192 +X 16384\nabcd"), HasSubstr("ends too early")); // before its memory is taken
    EXPECT_THAT(error_of(head + "-Y 1 +X 10\n" + bytes({2, 2, 0, 11, 138, 128})), HasSubstr("a row is not as wide"));
    EXPECT_THAT(error_of(head + "-Y 1 +X 10\n" + bytes({2, 2, 0, 10, 139, 128})), HasSubstr("a row is not as wide"));
    EXPECT_THAT(error_of(head + "-Y 1 +X 10\n" + bytes({2, 2, 0, 10, 0})), HasSubstr("a row is not as wide"));
    EXPECT_THAT(error_of(head + "-Y 1 +X 3\n" + bytes({5, 0, 0, 129, 1, 1, 1, 200})),
                HasSubstr("a row is not as wide"));
    EXPECT_THROW(load_hdr("/no/such/file.hdr"), Error);
}

} // namespace
} // namespace prelight
