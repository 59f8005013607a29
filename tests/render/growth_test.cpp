// How a frame's work grows with lights and pixels: counts, which no other work on the machine changes.
#include "against_reference.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

/// A frame of the baseline scene.
Stats frame_of(uint32_t lights, uint32_t width, uint32_t height) {
    const Scene scene = make_scene("lights", lights, 1);
    const World world = resolve(scene);
    const RenderOptions options{.width = width, .height = height, .count_pairs = true, .settings = {}, .views = {}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(world);
    renderer->render(world.cameras.at(0)); // lists find out how much room they need
    renderer->set_lights(world.lights);    // all records are written again
    renderer->render(world.cameras.at(0));
    return renderer->stats();
}

/// Passes by name, without the number of the round that more lights than one holds need.
std::set<std::string> kinds_of(const Stats& stats) {
    std::set<std::string> kinds;
    for (const PassStats& pass : stats.passes)
        kinds.insert(pass.name.substr(0, pass.name.find_last_not_of(" 0123456789") + 1));
    return kinds;
}

double ratio(uint64_t a, uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); }

TEST(Growth, WithLights) {
    const Stats one = frame_of(1, 320, 180);
    Stats before = one;
    uint32_t lights_before = 1;
    for (const uint32_t lights : {16u, 256u, 4096u, 65536u}) {
        SCOPED_TRACE(lights);
        const Stats stats = frame_of(lights, 320, 180);
        EXPECT_EQ(kinds_of(stats), kinds_of(one)) << "the same passes, however many lights";
        EXPECT_LE(stats.passes.size(), one.passes.size() * std::max(1u, lights / 16384)) << "and one round for so many";
        EXPECT_EQ(stats.draws, one.draws);
        EXPECT_EQ(stats.triangles_drawn, one.triangles_drawn);
        EXPECT_EQ(stats.attachment_bytes, one.attachment_bytes);
        // What the host writes: a record of each light, and its place in the order.
        const double record = ratio(stats.frame_bytes - before.frame_bytes, lights - lights_before);
        EXPECT_GE(record, 64);
        EXPECT_LE(record, 80);
        // What tiles of 8 pixels evaluate beyond what contributes, in a picture as small as this.
        EXPECT_LT(ratio(stats.pairs_evaluated, stats.pairs_contributing), 3.6);
        if (before.pairs_evaluated > 0) { // pairs as lights, for each is as large as the others
            EXPECT_LT(ratio(stats.pairs_evaluated, before.pairs_evaluated), 1.1 * ratio(lights, lights_before));
        }
        before = stats;
        lights_before = lights;
    }
    // The device's memory: lists and records, which no pixel is multiplied with.
    EXPECT_LT(before.device_bytes - one.device_bytes, 65536u * 2048u);
    expect_validation_clean(test_device());
}

TEST(Growth, WithPixels) {
    Stats before = frame_of(64, 160, 90);
    const Stats first = before;
    for (const uint32_t scale : {2u, 4u, 8u}) {
        SCOPED_TRACE(scale);
        const Stats stats = frame_of(64, 160 * scale, 90 * scale);
        EXPECT_EQ(kinds_of(stats), kinds_of(first));
        EXPECT_EQ(stats.passes.size(), first.passes.size());
        // Indices of triangles that cover a pixel: more where there are more pixels, but never as many times.
        EXPECT_LT(ratio(stats.frame_bytes, before.frame_bytes), 2);
        // Four times the pixels: images and pairs four times, and no more than what fills tiles at the picture's edges.
        EXPECT_NEAR(ratio(stats.attachment_bytes, before.attachment_bytes), 4, 0.25);
        EXPECT_NEAR(ratio(stats.pairs_contributing, before.pairs_contributing), 4, 0.25);
        EXPECT_LT(ratio(stats.pairs_evaluated, before.pairs_evaluated), 4.25);
        EXPECT_EQ(stats.lights, first.lights);
        before = stats;
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
