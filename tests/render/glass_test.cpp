// The built-in scene `glass` against the reference: where sorting objects is right, and what it costs where it is not.
#include "against_reference.hpp"
#include <algorithm>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

/// Objects that objects in order cannot be right for: docs/transparency.md.
bool out_of_order(const std::string& name) {
    return name == "crossing pane" || name == "long pane" || name == "bottle beside the long pane";
}

struct GlassScene : testing::TestWithParam<std::string> {
    static inline const Scene scene = make_scene("glass", 16, 1);

    static World world_of(bool all) {
        World world = resolve(scene);
        for (Instance& instance : world.instances)
            instance.visible = all || !out_of_order(scene.nodes[instance.node].name);
        return world;
    }
    static Shot shot_of(const World& world) {
        return {.world = &world, .camera = find_camera(world, "front"), .width = 240, .height = 135};
    }
};

INSTANTIATE_TEST_SUITE_P(All, GlassScene, testing::ValuesIn(device_renderers), [](const auto& each) {
    std::string name = each.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(GlassScene, IsWrongOnlyWhereObjectsCannotBeInOrder) {
    const World all = world_of(true), ordered = world_of(false);
    Shot shot = shot_of(all), without = shot_of(ordered);
    shot.renderer = without.renderer = GetParam();
    static References references_of_all, references_of_ordered;
    const ReferencePicture &whole = references_of_all.of(shot), &rest = references_of_ordered.of(without);
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, whole);

    std::vector<uint8_t> others = whole.left_out(); // but for what only the objects out of order show
    size_t behind = 0;
    for (size_t i = 0; i < others.size(); ++i) {
        const bool covered = whole.linear.pixels[i] != rest.linear.pixels[i];
        behind += covered;
        others[i] = others[i] || covered;
    }
    EXPECT_GT(behind, others.size() / 20);
    expect_within(compare_pixels(picture, whole.linear, others), {.left_out = 0.6});
    expect_within(compare_pixels(render_linear(test_device(), without), rest.linear, rest.left_out()),
                  {.left_out = 0.4});
    // What the order costs: docs/transparency.md.
    const Comparison cost = compare_pixels(picture, whole.linear, whole.left_out());
    expect_within(cost, {.psnr = 28, .off_share = 0.05, .block = 50, .left_out = 0.4});
    EXPECT_GT(cost.off_share, 0.01);
    expect_validation_clean(test_device());
}

// Layer by layer all of it is right.
TEST_P(GlassScene, PeeledAgreesWithTheReference) {
    const World world = world_of(true);
    Shot shot = shot_of(world);
    shot.renderer = GetParam();
    shot.settings = {{"transparency", "peeled"}};
    if (shot.renderer == "light-prepass")
        shot.settings["layer-light"] = "lists";
    static References references;
    const ReferencePicture& reference = references.of(shot);
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within(compare_pixels(picture, reference.linear, reference.left_out()), {.left_out = 0.4});
    if (shot.renderer == "light-prepass") { // and each layer with a light pre-pass of its own
        shot.settings["layer-light"] = "light-buffer";
        expect_within(compare_pixels(render_linear(test_device(), shot), reference.linear, reference.left_out()),
                      {.left_out = 0.4});
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
