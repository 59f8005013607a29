// A k-buffer: the nearest layers of a pixel as they lie, over the weighted mean of the rest.
#include "panes.hpp"
#include <algorithm>
#include <random>
#include <shared/blended_weight.h>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Shot buffered(Shot shot, const char* layers, const std::string& renderer = "light-prepass") {
    shot.renderer = renderer;
    return with(shot, {{"transparency", "k-buffer"}, {"k-buffer-layers", layers}});
}

TEST(TransparencyKBuffer, PanesThatCrossAgreeWithTheReference) {
    const Fan fan(7);
    References references;
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        const Shot shot = buffered(fan.shot(), "7", name);
        const ReferencePicture& reference = references.of(shot);
        const Rendered drawn = render_with(fan.world, shot.camera, options_of(shot), name);
        save_when_wanted(drawn.linear, reference);
        expect_within(compare_pixels(drawn.linear, reference.linear, reference.left_out()), {.left_out = 0.25});
        EXPECT_EQ(drawn.stats.layers->most, 7u);
        EXPECT_EQ(drawn.stats.layers->approximate, 0u);
        EXPECT_THAT(drawn.stats.notes, Not(Contains(HasSubstr("k-buffer"))));
    }
    const Shot own = with(buffered(fan.shot(), "8"), {{"layer-light", "light-buffer"}});
    const ReferencePicture& reference = references.of(own);
    expect_within(compare_pixels(render_linear(test_device(), own), reference.linear, reference.left_out()),
                  {.left_out = 0.25});
    expect_validation_clean(test_device());
}

TEST(TransparencyKBuffer, SamplesOfPanesThatCrossAgree) {
    const Fan fan(5);
    const Shot shot = buffered(with_samples(fan.shot(), 480), "5");
    const ReferencePicture reference =
        render_reference(fan.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within_on_edges(picture, reference, {.left_out = 0.2});
    expect_validation_clean(test_device());
}

/// Of unlit panes, the four nearest over the weighted mean of the others (McGuire and Bavoil, equation 6).
glm::dvec3 four_over_the_mean(const Panes& panes) {
    glm::dvec3 sum(0);
    double weights = 0, left = 1;
    const size_t rest = panes.layers.size() - 4;
    for (size_t i = 0; i < rest; ++i) {
        const glm::dvec4& layer = panes.layers[i];
        const double weight = shared::blended_weight(static_cast<float>(6 - 0.15 * static_cast<double>(i)),
                                                     static_cast<float>(layer.a), 1.0f);
        sum += weight * glm::dvec3(layer);
        weights += weight;
        left *= 1 - layer.a;
    }
    const glm::dvec3 mean = (1 - left) * sum / weights + left * glm::dvec3(0.1, 0.3, 0.2);
    return laid_over(mean, {panes.layers.begin() + static_cast<std::ptrdiff_t>(rest), panes.layers.end()});
}

TEST(TransparencyKBuffer, LayersBeyondItAreComposedByTheirMeanAndTold) {
    const Panes panes(15);
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        const Shot shot = buffered(panes.shot(), "4", name);
        const Rendered drawn = render_with(panes.world, shot.camera, options_of(shot), name);
        expect_layers(middle_of(drawn.linear), four_over_the_mean(panes), 15);
        EXPECT_EQ(drawn.stats.layers->most, 15u);
        EXPECT_EQ(drawn.stats.layers->exact, 4u);
        EXPECT_GT(drawn.stats.layers->approximate, 0u);
        EXPECT_THAT(drawn.stats.notes, Contains(HasSubstr("behind the 4 nearest layers")));
    }
    expect_validation_clean(test_device());
}

// Whatever order objects are drawn in, the slots hold the same.
TEST(TransparencyKBuffer, TheOrderOfDrawsMakesNoDifference) {
    const Fan fan(6);
    const Shot shot = buffered(fan.shot(), "6");
    const Image first = render_linear(test_device(), shot);
    std::mt19937 lot(3);
    std::vector<uint32_t> order{1, 2, 3, 4, 5, 6}; // of instances; 0 is the wall
    for (int i = 0; i < 3; ++i) {
        std::shuffle(order.begin(), order.end(), lot);
        Fan other(6);
        for (size_t k = 0; k < order.size(); ++k)
            other.world.instances[k + 1] = fan.world.instances[order[k]];
        Shot shuffled = shot;
        shuffled.world = &other.world;
        EXPECT_EQ(render_linear(test_device(), shuffled).pixels, first.pixels);
    }
    expect_validation_clean(test_device());
}

TEST(TransparencyKBuffer, SurfacesThatCoincideAreOneLayer) {
    TestWorld test;
    test.add_material(unlit_material("wall", {0.1f, 0.3f, 0.2f, 1}, AlphaMode::opaque));
    test.add(square(20), placed_at(0, 0, -3));
    const glm::dvec4 red(0.9, 0.1, 0.1, 0.5), blue(0.1, 0.1, 0.9, 0.5), green(0.1, 0.9, 0.1, 0.5);
    for (const auto& [colour, z] : {std::pair(red, 0.0), {blue, 0.0}, {green, -1.0}}) {
        test.add_material(unlit_material("pane", glm::vec4(colour)));
        test.add(square(2), placed_at(0, 0, z));
    }
    const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 64, .height = 36};
    expect_layers(middle_of(render_linear(test_device(), buffered(shot, "2"))),
                  laid_over({0.1, 0.3, 0.2}, {green, blue, red}), 3);
    expect_validation_clean(test_device());
}

TEST(TransparencyKBuffer, GivesWayWhereListsTakeSeveralRounds) {
    const Stats stats = expect_the_same_in_rounds({{"transparency", "k-buffer"}, {"k-buffer-layers", "2"}});
    EXPECT_EQ(stats.settings.at("transparency"), "sorted");
    EXPECT_THAT(stats.notes, Contains(HasSubstr("sorted is taken")));
}

// The view of how many layers there are, whatever draws them.
TEST(TransparencyLayersView, IsThatOfTheReference) {
    const Fan fan(7);
    const auto reference = create_renderer("reference", nullptr, {.width = 160, .height = 90, .views = {"layers"}});
    reference->set_world(fan.world);
    reference->render(fan.shot().camera);
    const Image right = reference->read("layers");
    for (const std::string& name : device_renderers)
        for (const char* how : {"lists", "peeled", "k-buffer", "opaque"}) {
            SCOPED_TRACE(name + " " + how);
            Shot shot = with(fan.shot(), {{"transparency", how}});
            shot.renderer = name;
            const Image picture = view_of(shot, "layers");
            ASSERT_EQ(picture.pixels.size(), right.pixels.size());
            size_t off = 0, seen = 0;
            for (size_t i = 0; i < right.pixels.size(); ++i) {
                const glm::vec3 should = shot.settings["transparency"] == "opaque" ? glm::vec3(0) : right.pixels[i];
                seen += right.pixels[i] != glm::vec3(0);
                for (int c = 0; c < 3; ++c)
                    if (std::abs(picture.pixels[i][c] - should[c]) > 2 / 255.0) {
                        ++off;
                        break;
                    }
            }
            EXPECT_GT(seen, right.pixels.size() / 4);
            EXPECT_LE(off, right.pixels.size() / 100) << "pixels on edges";
        }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
