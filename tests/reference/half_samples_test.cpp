// ReferenceForm::half_samples against closed forms.
#include "panes.hpp"
#include <prelight/error.hpp>

namespace prelight {
namespace {

constexpr glm::vec3 behind_panes{0.9f, 0.3f, 0.1f};
const ReferenceForm in_halves{
    .transparency = ReferenceForm::Transparency::layers, .half_samples = true, .samples = {.count = 4}};

/// A wall with panes before it, whose left edges lie at a place between pixels 12 and 13, columns from the left.
struct PanesBefore : TestWorld {
    explicit PanesBefore(const std::vector<Pane>& panes, double left = 12) {
        add_material(unlit(behind_panes));
        add(square(30));
        for (const Pane& pane : panes) {
            add_material(blended(pane.colour, pane.alpha));
            add(square(4), glm::translate(glm::dmat4(1), {left - columns / 2.0 + 4, 0, pane.z}));
        }
    }
};

glm::vec3 pixel_of(const Image& picture, uint32_t x) { return picture.at(x, rows / 2); }

TEST(ReferenceHalfSamples, OneLayerIsAsWithAllOfThem) {
    const Pane pane{{0.2f, 0.7f, 0.4f}, 0.3f, 1};
    const PanesBefore window({pane});
    const ReferencePicture picture = in_metres(window, in_halves);
    expect_colour(pixel_of(picture.linear, 14), laid_over(behind_panes, {pane}), "pane");
    expect_colour(pixel_of(picture.linear, 8), behind_panes, "wall");
    EXPECT_EQ(picture.layer_count[rows / 2 * columns + 14], 1u);
    EXPECT_EQ(picture.layer_count[rows / 2 * columns + 8], 0u);
}

// Sample 1 lies at 0.875 of a pixel, sample 2 at 0.125, one in each half.
TEST(ReferenceHalfSamples, AnEdgeHasOneOfThem) {
    const Pane pane{{0.2f, 0.7f, 0.4f}, 0.3f, 1};
    const glm::dvec3 wall = behind_panes, covered = laid_over(wall, {pane});
    for (const auto& [left, share] : {std::pair(12.05, 1.0), {12.3, 0.5}, {12.8, 0.5}, {12.95, 0.0}})
        expect_colour(pixel_of(in_metres(PanesBefore({pane}, left), in_halves).linear, 12),
                      glm::mix(wall, covered, share), std::to_string(left));
}

TEST(ReferenceHalfSamples, TheNearestLayerThatCoversEnoughIsShown) {
    const Pane far{{0.2f, 0.7f, 0.4f}, 0.3f, 1}, near{{0.1f, 0.2f, 0.9f}, 0.6f, 2}, faint{{1, 1, 1}, 0.06f, 3};
    for (const auto& panes : {std::vector{far, near, faint}, {faint, near, far}})
        expect_colour(pixel_of(in_metres(PanesBefore(panes), in_halves).linear, 14), laid_over(behind_panes, {near}),
                      "near");
    expect_colour(pixel_of(in_metres(PanesBefore({faint}), in_halves).linear, 14), behind_panes, "faint");
}

TEST(ReferenceHalfSamples, NothingBehindIsBlack) {
    TestWorld test;
    test.add_material(blended({0.2f, 0.7f, 0.4f}, 0.5f));
    test.add(square(4));
    expect_colour(pixel_of(in_metres(test, in_halves).linear, 12), {0.1, 0.35, 0.2}, "pane");
}

TEST(ReferenceHalfSamples, AreMixedBeforeToneMapping) {
    TestWorld test;
    Material lamp = blended({0, 0, 0}, 0.25f);
    lamp.unlit = false;
    lamp.emissive = glm::vec3(2);
    lamp.metallic = 0;
    test.add_material(lamp);
    test.add(square(4));
    const ReferencePicture picture = in_metres(test, in_halves);
    const float shown = pixel_of(picture.display(Tonemap::pbr_neutral), 12).r;
    EXPECT_NEAR(shown, srgb_encode(display_light(pixel_of(picture.linear, 12), Tonemap::pbr_neutral).r), 1e-5);
}

TEST(ReferenceHalfSamples, NeedFourSamples) {
    ReferenceForm form = in_halves;
    form.samples.count = 2;
    EXPECT_THROW(in_metres(PanesBefore({}), form), Error);
}

} // namespace
} // namespace prelight
