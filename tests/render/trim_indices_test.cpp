#include <array>
#include <gtest/gtest.h>
#include <resident/trim_indices.hpp>

namespace prelight {
namespace {

/// Object space is clip space of a picture of 100 × 100 pixels: x and y in pixels from its corner.
class OneTriangle : public testing::Test {
protected:
    static bool kept(std::array<glm::vec2, 3> corners, bool mirrored = false, bool double_sided = false) {
        Primitive primitive;
        for (const glm::vec2& corner : corners)
            primitive.positions.emplace_back(corner.x / 50 - 1, corner.y / 50 - 1, 0.5f);
        primitive.indices = {0, 1, 2};
        return trim(primitive, glm::mat4(1), mirrored, double_sided);
    }
    static bool trim(const Primitive& primitive, const glm::mat4& clip, bool mirrored = false,
                     bool double_sided = false) {
        shared::ObjectData object{};
        for (int r = 0; r < 3; ++r)
            object.world_row[r][r] = 1;
        resident::IndexTrimmer trimmer({.clip_from_world = clip, .width = 100, .height = 100, .subpixel_bits = 8});
        resident::Draw draw{
            .index_count = 3, .mirrored = mirrored, .double_sided = double_sided, .primitive = &primitive};
        std::tie(draw.own_low, draw.own_high) = resident::box_of(primitive.positions);
        uint32_t out[3] = {};
        const size_t count = trimmer.trim(draw, object, out);
        EXPECT_TRUE(count == 0 || (count == 3 && out[0] == 0 && out[1] == 1 && out[2] == 2));
        return count == 3;
    }
};

TEST_F(OneTriangle, FacingByWindingAndMirroring) {
    const std::array<glm::vec2, 3> front{{{20, 20}, {20, 60}, {60, 20}}}, back{{{20, 20}, {60, 20}, {20, 60}}};
    EXPECT_TRUE(kept(front));
    EXPECT_FALSE(kept(back));
    EXPECT_FALSE(kept(front, true));
    EXPECT_TRUE(kept(back, true));
    EXPECT_TRUE(kept(back, false, true));
    EXPECT_TRUE(kept(front, true, true));
}

TEST_F(OneTriangle, OffThePicture) {
    EXPECT_FALSE(kept({{{-30, 20}, {-30, 60}, {-1, 20}}}));
    EXPECT_FALSE(kept({{{110, 20}, {110, 60}, {150, 20}}}));
    EXPECT_FALSE(kept({{{20, -60}, {20, -1}, {60, -60}}}));
    EXPECT_FALSE(kept({{{20, 101}, {20, 160}, {60, 101}}}));
    EXPECT_TRUE(kept({{{-30, 20}, {-30, 60}, {2, 20}}}));
    EXPECT_TRUE(kept({{{-90, -90}, {-90, 400}, {400, -90}}})) << "all corners outside, the picture inside";
}

TEST_F(OneTriangle, NoSampleCovered) {
    EXPECT_FALSE(kept({{{20.6f, 20.1f}, {20.6f, 24}, {21.4f, 20.1f}}})) << "between two columns of centres";
    EXPECT_FALSE(kept({{{20.1f, 20.6f}, {20.1f, 21.4f}, {24, 20.6f}}})) << "between two rows";
    EXPECT_FALSE(kept({{{20.0f, 20.0f}, {20.0f, 20.8f}, {20.8f, 20.0f}}})) << "the centre is beyond the long side";
    EXPECT_TRUE(kept({{{20.0f, 20.0f}, {20.0f, 21.1f}, {21.1f, 20.0f}}})) << "the centre lies inside";
    EXPECT_TRUE(kept({{{20.0f, 20.0f}, {20.0f, 20.995f}, {20.995f, 20.0f}}})) << "too near to tell";
    EXPECT_TRUE(kept({{{20.502f, 20.1f}, {20.502f, 24}, {21.4f, 20.1f}}})) << "too near to tell";
}

TEST_F(OneTriangle, BehindTheCameraIsKept) {
    glm::mat4 clip(1);
    clip[2][3] = 1; // w = z
    clip[3][3] = 0;
    Primitive primitive;
    primitive.positions = {{-0.2f, -0.2f, 0.5f}, {-0.2f, 0.2f, 0.5f}, {0.2f, -0.2f, -0.5f}};
    primitive.indices = {0, 1, 2};
    EXPECT_TRUE(trim(primitive, clip));
    primitive.positions = {{2, -0.2f, 0.5f}, {2, 0.2f, 0.5f}, {3, -0.2f, -0.5f}};
    EXPECT_FALSE(trim(primitive, clip)) << "right of the picture, whatever w is";
}

} // namespace
} // namespace prelight
