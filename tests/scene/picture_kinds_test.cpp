// Every kind of PNG and JPEG is decoded to the right values, or refused in one line.
#include "pictures.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scene/images/decode.hpp>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using Stored = JpegForm::Stored;

namespace {

Bytes decoded(const Bytes& file) {
    images::inspect(file);
    return images::decode(file).rgba;
}
Bytes decoded(const RawPng& png) { return decoded(png.bytes()); }

std::string reason(const Bytes& file) {
    try {
        decoded(file);
    } catch (const DecodeError& error) {
        return error.what();
    }
    return "none";
}

Bytes ramp(size_t count, uint8_t step = 1) {
    Bytes out(count);
    for (size_t i = 0; i < count; ++i)
        out[i] = uint8_t(i * step + 3);
    return out;
}

/// The picture's texels one by one within `tolerance`.
void expect_texels_near(const Bytes& rgba, const Bytes& right, int tolerance) {
    ASSERT_EQ(rgba.size(), right.size());
    for (size_t i = 0; i < rgba.size(); ++i)
        ASSERT_NEAR(rgba[i], right[i], tolerance) << i;
}

TEST(PngKinds, EightBitsAsTheyAre) {
    const Bytes row = ramp(8);
    EXPECT_EQ(decoded({.width = 2, .lines = unfiltered({row})}), row);
    EXPECT_THAT(decoded({.width = 2, .colour = 2, .lines = unfiltered({{1, 2, 3, 4, 5, 6}})}),
                ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
    EXPECT_THAT(decoded({.width = 2, .colour = 0, .lines = unfiltered({{7, 200}})}),
                ElementsAre(7, 7, 7, 255, 200, 200, 200, 255));
    EXPECT_THAT(decoded({.width = 2, .colour = 4, .lines = unfiltered({{7, 1, 200, 128}})}),
                ElementsAre(7, 7, 7, 1, 200, 200, 200, 128));
}

TEST(PngKinds, EveryFilterOfItsLines) {
    // Each line takes from its left neighbour or the line above what the filter says; all become 10 20 30.
    EXPECT_THAT(decoded({.width = 3, .height = 5, .colour = 0, .lines = {0, 10, 20, 30, 1, 10, 10, 10, 2, 0,
                                                                         0, 0,  3,  5,  5, 5,  4,  0,  0, 0}}),
                ElementsAreArray([] {
                    Bytes right;
                    for (int y = 0; y < 5; ++y)
                        for (const uint8_t v : {10, 20, 30})
                            right.insert(right.end(), {v, v, v, 255});
                    return right;
                }()));
}

TEST(PngKinds, SixteenBitsAreRoundedToTheNearest) {
    // 0x0080 is 0.498 of a step, 0x0081 0.502; 0xfe80 is 253.51 of 255.
    EXPECT_THAT(
        decoded(
            {.width = 4, .bits = 16, .colour = 0, .lines = unfiltered({{0, 0x80, 0, 0x81, 0xfe, 0x80, 0xff, 0xff}})}),
        ElementsAre(0, 0, 0, 255, 1, 1, 1, 255, 254, 254, 254, 255, 255, 255, 255, 255));
    EXPECT_THAT(decoded({.width = 1,
                         .bits = 16,
                         .colour = 6,
                         .lines = unfiltered({{0x12, 0x12, 0x34, 0x34, 0x56, 0x56, 0x78, 0x78}})}),
                ElementsAre(0x12, 0x34, 0x56, 0x78));
}

TEST(PngKinds, FewBitsAreSpreadOverAll) {
    EXPECT_THAT(decoded({.width = 8, .bits = 1, .colour = 0, .lines = unfiltered({{0b01000000}})})[4], 255);
    const Bytes two = decoded({.width = 4, .bits = 2, .colour = 0, .lines = unfiltered({{0b00011011}})});
    EXPECT_THAT((Bytes{two[0], two[4], two[8], two[12]}), ElementsAre(0, 85, 170, 255));
    const Bytes four = decoded({.width = 2, .bits = 4, .colour = 0, .lines = unfiltered({{0x5f}})});
    EXPECT_THAT((Bytes{four[0], four[4]}), ElementsAre(0x55, 255));
}

TEST(PngKinds, TransparentColours) {
    EXPECT_THAT(decoded({.width = 2, .colour = 0, .chunks = {{"tRNS", {0, 9}}}, .lines = unfiltered({{9, 8}})}),
                ElementsAre(9, 9, 9, 0, 8, 8, 8, 255));
    EXPECT_THAT(decoded({.width = 2,
                         .colour = 2,
                         .chunks = {{"tRNS", {0, 1, 0, 2, 0, 3}}},
                         .lines = unfiltered({{1, 2, 3, 1, 2, 4}})}),
                ElementsAre(1, 2, 3, 0, 1, 2, 4, 255));
    // All 16 bits are compared, not the 8 that are kept.
    EXPECT_THAT(
        decoded(
            {.width = 2, .bits = 16, .colour = 0, .chunks = {{"tRNS", {1, 2}}}, .lines = unfiltered({{1, 2, 1, 3}})}),
        ElementsAre(1, 1, 1, 0, 1, 1, 1, 255));
    EXPECT_THAT(
        decoded({.width = 2, .bits = 4, .colour = 0, .chunks = {{"tRNS", {0, 5}}}, .lines = unfiltered({{0x5a}})}),
        ElementsAre(85, 85, 85, 0, 170, 170, 170, 255));
    // With an alpha channel there is none by the standard: it is passed over.
    EXPECT_THAT(decoded({.width = 1, .colour = 4, .chunks = {{"tRNS", {0, 7}}}, .lines = unfiltered({{7, 20}})}),
                ElementsAre(7, 7, 7, 20));
}

TEST(PngKinds, Palettes) {
    const std::pair<std::string, Bytes> colours{"PLTE", {1, 2, 3, 4, 5, 6}};
    EXPECT_THAT(decoded({.width = 2, .colour = 3, .chunks = {colours, {"tRNS", {77}}}, .lines = unfiltered({{0, 1}})}),
                ElementsAre(1, 2, 3, 77, 4, 5, 6, 255));
    EXPECT_THAT(decoded({.width = 2, .bits = 1, .colour = 3, .chunks = {colours}, .lines = unfiltered({{0b10000000}})}),
                ElementsAre(4, 5, 6, 255, 1, 2, 3, 255));
    // Beyond its end there is opaque black, as libpng has it.
    EXPECT_THAT(decoded({.width = 3, .colour = 3, .chunks = {colours}, .lines = unfiltered({{1, 2, 255}})}),
                ElementsAre(4, 5, 6, 255, 0, 0, 0, 255, 0, 0, 0, 255));
    EXPECT_THAT(reason(RawPng{.width = 2, .colour = 3, .lines = unfiltered({{0, 1}})}.bytes()),
                HasSubstr("missing PLTE"));
}

TEST(PngKinds, GammaAndColourProfilesAreNotApplied) {
    // glTF: colour space information in pictures is ignored.
    const Bytes gamma{0, 1, 0x86, 0xa0}; // 1.0: linear
    Bytes profile{'p', 0, 0};            // no profile at all: it is not even unpacked
    profile.resize(200, 0x5a);
    for (const auto& chunk : std::vector<std::pair<std::string, Bytes>>{{"gAMA", gamma},
                                                                        {"iCCP", profile},
                                                                        {"sRGB", {0}},
                                                                        {"cHRM", Bytes(32, 1)},
                                                                        {"sBIT", {3, 3, 3, 3}},
                                                                        {"bKGD", {0, 9, 0, 9, 0, 9}},
                                                                        {"tEXt", ramp(50)},
                                                                        {"zTXt", ramp(50)},
                                                                        {"eXIf", ramp(30)},
                                                                        {"pHYs", Bytes(9, 1)},
                                                                        {"acTL", Bytes(8, 1)},
                                                                        {"prVt", ramp(9)}}) {
        EXPECT_EQ(decoded({.width = 1, .chunks = {chunk}, .lines = unfiltered({{100, 150, 200, 128}})}),
                  (Bytes{100, 150, 200, 128}))
            << chunk.first;
        EXPECT_EQ(
            decoded({.width = 1, .chunks = {chunk, chunk}, .lines = unfiltered({{1, 2, 3, 4}}), .truthful = false}),
            (Bytes{1, 2, 3, 4}))
            << chunk.first << " twice and damaged";
    }
    EXPECT_THAT(reason(RawPng{.chunks = {{"ABCD", {1}}}, .lines = unfiltered({ramp(4)})}.bytes()),
                HasSubstr("unknown kind that matters"));
}

TEST(PngKinds, Interlaced) {
    // Adam7 of 3 × 3: passes of 1×1, 0, 0, 1×1 (2, 0), 2×1 (0, 2), 1×2 (1, 0), 3×1 (0, 1).
    const auto place = [](uint8_t bytes_each) {
        RawPng png{.width = 3, .height = 3, .bits = uint8_t(8 * bytes_each), .colour = 0, .interlaced = true};
        const std::vector<std::vector<uint8_t>> lines{{0}, {2}, {6, 8}, {1}, {7}, {3, 4, 5}};
        for (const auto& line : lines) {
            png.lines.push_back(0);
            for (const uint8_t v : line)
                png.lines.insert(png.lines.end(), bytes_each, uint8_t(10 * v));
        }
        return png;
    };
    for (const uint8_t bytes_each : {1, 2}) {
        const Bytes rgba = decoded(place(bytes_each));
        ASSERT_EQ(rgba.size(), 36u);
        for (size_t i = 0; i < 9; ++i)
            EXPECT_EQ(rgba[4 * i], 10 * i) << int(bytes_each) << " bytes, texel " << i;
        const Bytes half = images::decode(place(bytes_each).bytes(), 1, images::Texels::values).rgba;
        EXPECT_THAT(half, ElementsAre(40, 40, 40, 255)); // the mean of 0, 10 … 80
    }
}

TEST(PngKinds, WhatIsCutOrDamagedIsRefused) {
    const Bytes whole = png(7, 5, ramp(7 * 5 * 4, 37));
    ASSERT_EQ(decoded(whole), ramp(7 * 5 * 4, 37));
    for (size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(reason(Bytes(whole.begin(), whole.begin() + ptrdiff_t(length))), "none") << length;
    for (size_t at = 41; at + 12 < whole.size(); ++at) { // within the packed data and their checksums
        Bytes bad = whole;
        bad[at] ^= 0x10;
        EXPECT_THAT(reason(bad), HasSubstr("PNG")) << at;
    }
    EXPECT_THAT(reason(RawPng{.width = 2, .height = 2, .lines = unfiltered({ramp(8)})}.bytes()),
                HasSubstr("does not decode"));
    // More lines than it says are not looked at.
    EXPECT_EQ(decoded({.width = 2, .lines = unfiltered({ramp(8), ramp(8)})}), ramp(8));
}

TEST(JpegKinds, GreyColourAndProgressive) {
    const Bytes grey(64, 90), colour = solid(8, 8, {200, 100, 50});
    expect_texels_near(decoded(jpeg_of(8, 8, grey, {.stored = Stored::grey})), solid(8, 8, {90, 90, 90, 255}), 1);
    for (const bool progressive : {false, true})
        for (const bool arithmetic : {false, true}) {
            JpegForm form{.progressive = progressive, .arithmetic = arithmetic};
            expect_texels_near(decoded(jpeg_of(8, 8, colour, form)), solid(8, 8, {200, 100, 50, 255}), 2);
            // RGB that is not YCbCr says so by Adobe's marker or by the components' names.
            form.stored = Stored::rgb;
            form.jfif_marker = false;
            for (const bool marker : {false, true}) {
                form.adobe_marker = marker;
                expect_texels_near(decoded(jpeg_of(8, 8, colour, form)), solid(8, 8, {200, 100, 50, 255}), 2);
            }
        }
}

TEST(JpegKinds, InksBecomeColours) {
    // C, M, Y, K of 35, 195, 215, 0: red 220, green 60, blue 40; with a quarter of black all a quarter darker.
    for (const auto& [inks, right] : {std::pair(Bytes{35, 195, 215, 0}, Bytes{220, 60, 40, 255}),
                                      {Bytes{35, 195, 215, 64}, Bytes{165, 45, 30, 255}},
                                      {Bytes{0, 0, 0, 255}, Bytes{0, 0, 0, 255}},
                                      {Bytes{0, 0, 0, 0}, Bytes{255, 255, 255, 255}}}) {
        Bytes inverted = inks;
        for (uint8_t& v : inverted)
            v = uint8_t(255 - v);
        const Bytes colours = solid(8, 8, right);
        for (const bool progressive : {false, true}) {
            const JpegForm form{.stored = Stored::cmyk, .progressive = progressive};
            expect_texels_near(decoded(jpeg_of(8, 8, solid(8, 8, inks), form)), colours, 2);
            JpegForm adobe{.stored = Stored::cmyk, .adobe_marker = true, .progressive = progressive};
            expect_texels_near(decoded(jpeg_of(8, 8, solid(8, 8, inverted), adobe)), colours, 2);
            adobe.stored = Stored::ycck;
            expect_texels_near(decoded(jpeg_of(8, 8, solid(8, 8, inverted), adobe)), colours, 3);
        }
        EXPECT_THAT(reason(jpeg_of(8, 8, solid(8, 8, inverted), {.stored = Stored::ycck})),
                    HasSubstr("does not say whether its four components are CMYK or YCCK"));
    }
}

TEST(JpegKinds, OrientationOfExifIsNotApplied) {
    // Big-endian TIFF: one entry, Orientation = 6 (turned by 90°).
    const Bytes exif{'E', 'x',  'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1,
                     1,   0x12, 0,   3,   0, 0, 0,   1,   0, 6,  0, 0, 0, 0, 0, 0};
    Bytes rgb;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            rgb.insert(rgb.end(), 3, uint8_t(x < 8 ? 20 : 220));
    const images::Cost size = images::inspect(jpeg_of(16, 8, rgb, {.exif = exif}));
    EXPECT_EQ(size.width, 16u);
    EXPECT_EQ(size.height, 8u);
    const Bytes rgba = decoded(jpeg_of(16, 8, rgb, {.exif = exif}));
    EXPECT_NEAR(rgba[0], 20, 2);
    EXPECT_NEAR(rgba[15 * 4], 220, 2);
}

TEST(JpegKinds, WhatIsCutOrOfAnotherKindIsRefused) {
    for (const JpegForm& form : {JpegForm{}, JpegForm{.progressive = true}, JpegForm{.arithmetic = true}}) {
        const Bytes whole = jpeg_of(24, 16, ramp(24 * 16 * 3, 7), form);
        ASSERT_EQ(reason(whole), "none");
        for (size_t length = 3; length < whole.size(); length += 5)
            EXPECT_THAT(reason(Bytes(whole.begin(), whole.begin() + ptrdiff_t(length))),
                        HasSubstr("does not decode (JPEG: "))
                << length;
    }
    Bytes twelve = jpeg_of(8, 8, solid(8, 8, {1, 2, 3}), {});
    const Bytes frame{0xff, 0xc0};
    const auto at = std::search(twelve.begin(), twelve.end(), frame.begin(), frame.end());
    ASSERT_NE(at, twelve.end());
    at[4] = 12;
    EXPECT_THAT(reason(twelve), HasSubstr("Unsupported JPEG data precision 12"));
    at[4] = 8;
    at[1] = 0xc3; // lossless
    EXPECT_THAT(reason(twelve), HasSubstr("Unsupported JPEG process"));
    // Bytes after its end, and rubbish between segments, are no damage.
    Bytes tail = jpeg_of(8, 8, solid(8, 8, {9, 9, 9}), {});
    tail.insert(tail.end(), {1, 2, 3});
    EXPECT_EQ(reason(tail), "none");
    tail.insert(tail.begin() + 20, {0, 0});
    EXPECT_EQ(reason(tail), "none");
}

TEST(WebpKinds, ExactColoursAndAlpha) {
    const Bytes pixels = ramp(6 * 4 * 4, 11);
    Bytes opaque = pixels;
    for (size_t i = 3; i < opaque.size(); i += 4)
        opaque[i] = 255;
    EXPECT_EQ(decoded(webp_lossless(6, 4, opaque)), opaque);
    const Bytes whole = webp_lossless(6, 4, pixels);
    for (size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(reason(Bytes(whole.begin(), whole.begin() + ptrdiff_t(length))), "none") << length;
}

TEST(ScaledPicture, ColoursAreAveragedInLinearLight) {
    // Half black, half white: 0.5 of the light is code 188, not 128. Alpha is plain.
    const TextureImage image{"name", 2, 2, {0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0}};
    const TextureImage half = images::scaled_down(image, 1, images::Texels::colour);
    EXPECT_EQ(half.name, "name");
    EXPECT_THAT(half.rgba, ElementsAre(188, 188, 188, 128));
    EXPECT_THAT(images::scaled_down(image, 1, images::Texels::values).rgba, ElementsAre(128, 128, 128, 128));
    for (int code = 0; code < 256; ++code) { // what is even stays as it is
        const auto v = uint8_t(code);
        for (const images::Texels kind : {images::Texels::colour, images::Texels::values})
            EXPECT_EQ(images::scaled_down({{}, 2, 2, solid(2, 2, {v, v, v, v})}, 1, kind).rgba, (Bytes{v, v, v, v}));
    }
}

TEST(ScaledPicture, NormalsKeepTheirLength) {
    // 45° to the left and to the right: straight up, at full length.
    const TextureImage image{{}, 2, 1, {218, 128, 218, 255, 37, 128, 218, 255}};
    const Bytes up = images::scaled_down(image, 1, images::Texels::normals).rgba;
    EXPECT_NEAR(up[0], 127.5, 0.6);
    EXPECT_NEAR(up[1], 127.5, 0.6);
    EXPECT_EQ(up[2], 255);
    const TextureImage opposite{{}, 2, 1, {255, 128, 128, 255, 0, 127, 127, 255}}; // no direction is left
    EXPECT_EQ(images::scaled_down(opposite, 1, images::Texels::normals).rgba.size(), 4u);
}

TEST(ScaledPicture, OddSidesAndManyHalvings) {
    Bytes row;
    for (const uint8_t v : {10, 20, 30, 40, 80})
        row.insert(row.end(), {v, v, v, 255});
    const TextureImage line{{}, 5, 1, row};
    const Bytes half = images::scaled_down(line, 1, images::Texels::values).rgba;
    ASSERT_EQ(half.size(), 8u);
    EXPECT_EQ(half[0], 15);
    EXPECT_EQ(half[4], 50); // the last texel takes three
    EXPECT_EQ(images::scaled_down(line, 2, images::Texels::values).rgba[0], 36);
    EXPECT_EQ(images::scaled_down(line, 9, images::Texels::values).rgba[0], 36);
    // Rows that come one by one out of a file give the same as the whole picture.
    const Bytes pixels = ramp(13 * 11 * 4, 29);
    for (const Bytes& file : {png(13, 11, pixels), webp_lossless(13, 11, pixels)}) {
        const TextureImage whole = images::decode(file);
        for (const uint32_t halvings : {1, 2, 3, 4})
            for (const auto kind : {images::Texels::colour, images::Texels::normals, images::Texels::values}) {
                const TextureImage direct = images::decode(file, halvings, kind),
                                   after = images::scaled_down(whole, halvings, kind);
                EXPECT_EQ(direct.width, std::max(13u >> halvings, 1u));
                EXPECT_EQ(direct.height, std::max(11u >> halvings, 1u));
                EXPECT_EQ(direct.rgba, after.rgba);
            }
    }
}

} // namespace
