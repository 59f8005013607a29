#include "against_reference.hpp"
#include "stage.hpp"
#include <glm/gtc/matrix_transform.hpp>
#include <resident/trim_draws.hpp>

namespace prelight {
namespace {

/// Forty spheres in a row, some beside the picture: enough for several threads.
struct Row {
    Primitive primitive = sphere(96);
    std::vector<resident::Draw> draws;
    std::vector<resident::VisibleDraw> visible;
    std::vector<shared::ObjectData> objects;
    resident::TrimView view{
        .clip_from_world = glm::scale(glm::mat4(1), {0.1f, 0.1f, 0.1f}), .width = 640, .height = 360};

    Row() {
        const uint32_t count = static_cast<uint32_t>(primitive.indices.size());
        for (uint32_t i = 0; i < 40; ++i) {
            resident::Draw& draw = draws.emplace_back(resident::Draw{.index_count = count, .primitive = &primitive});
            std::tie(draw.own_low, draw.own_high) = resident::box_of(primitive.positions);
            shared::ObjectData& object = objects.emplace_back();
            for (int r = 0; r < 3; ++r)
                object.world_row[r][r] = 1;
            object.world_row[0][3] = 0.7f * static_cast<float>(i) - 16;
            object.world_row[2][3] = 5;
            visible.push_back({.draw = i, .index_count = count});
        }
    }
};

TEST(TrimDraws, OneAfterTheOtherHoweverManyThreads) {
    Row row;
    const size_t whole = row.primitive.indices.size();
    std::vector<uint32_t> room(40 * whole), expected(whole);
    double helpers_ms = 0;
    const size_t used = resident::trim_draws(row.visible, row.objects, row.draws, row.view, room, helpers_ms);
    resident::IndexTrimmer trimmer(row.view);
    size_t at = 0, empty = 0;
    for (size_t d = 0; d < row.draws.size(); ++d) {
        const size_t count = trimmer.trim(row.draws[d], row.objects[d], expected.data());
        ASSERT_TRUE(row.visible[d].trimmed);
        ASSERT_EQ(row.visible[d].first_index, at);
        ASSERT_EQ(row.visible[d].index_count, count);
        EXPECT_TRUE(std::equal(room.begin() + static_cast<ptrdiff_t>(at),
                               room.begin() + static_cast<ptrdiff_t>(at + count), expected.begin()));
        at += count;
        empty += count == 0;
    }
    EXPECT_EQ(used, at);
    EXPECT_GT(empty, 5u) << "beside the picture";
    EXPECT_LT(empty, 20u);
}

TEST(TrimDraws, WhatDoesNotFitStaysWhole) {
    Row row;
    const size_t whole = row.primitive.indices.size();
    std::vector<uint32_t> room(4 * whole);
    double helpers_ms = 0;
    const size_t used = resident::trim_draws(row.visible, row.objects, row.draws, row.view, room, helpers_ms);
    EXPECT_LE(used, room.size());
    EXPECT_GT(2 * used, room.size());
    size_t untouched = 0;
    for (const resident::VisibleDraw& one : row.visible)
        if (!one.trimmed) {
            EXPECT_EQ(one.index_count, whole);
            EXPECT_EQ(one.first_index, 0u);
            ++untouched;
        }
    EXPECT_GT(untouched, 5u);
}

} // namespace
} // namespace prelight
