// Depth peeling: layers in the order of their fragments, however objects lie.
#include "panes.hpp"
#include <algorithm>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Shot peeled(Shot shot, const std::string& renderer = "light-prepass") {
    shot.renderer = renderer;
    return with(shot, {{"transparency", "peeled"}});
}

TEST(TransparencyPeeled, PanesThatCrossAgreeWithTheReference) {
    const Fan fan(7);
    References references;
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        const Shot shot = peeled(fan.shot(), name);
        const ReferencePicture& reference = references.of(shot);
        const Image picture = render_linear(test_device(), shot);
        save_when_wanted(picture, reference);
        expect_within(compare_pixels(picture, reference.linear, reference.left_out()), {.left_out = 0.25});
        const Image lists = render_linear(test_device(), with(fan.shot(), {{"transparency", "lists"}}));
        EXPECT_GT(compare_pixels(lists, reference.linear, reference.left_out()).off_share, 0.05)
            << "objects in order are enough";
    }
    expect_validation_clean(test_device());
}

// Each layer with a light buffer of its own.
TEST(TransparencyPeeled, ALightPrePassOfEachLayerAgreesWithTheReference) {
    const Fan fan(7);
    References references;
    for (const std::map<std::string, std::string>& way :
         {std::map<std::string, std::string>{{"list-shading", "compute"}},
          {{"list-shading", "fragment"}},
          {{"light-culling", "clusters"}},
          {{"model", "nv"}}}) {
        SCOPED_TRACE(way.begin()->second);
        const Shot shot = with(peeled(fan.shot()), way);
        const ReferencePicture& reference = references.of(shot);
        const Rendered lists = render_with(fan.world, shot.camera, options_of(with(shot, {{"layer-light", "lists"}})));
        const Rendered own =
            render_with(fan.world, shot.camera, options_of(with(shot, {{"layer-light", "light-buffer"}})));
        save_when_wanted(own.linear, reference);
        expect_within(compare_pixels(own.linear, reference.linear, reference.left_out()), {.left_out = 0.25});
        expect_within(compare_pixels(own.linear, lists.linear), half_float_bound);
        EXPECT_EQ(own.stats.settings.at("layer-light"), "light-buffer");
        std::vector<std::string> passes;
        for (const PassStats& pass : own.stats.passes)
            passes.push_back(pass.name);
        EXPECT_THAT(passes, Contains("blended layer 7 light"));
    }
    const Shot volumes = with(peeled(fan.shot()), {{"light-culling", "volumes"}, {"layer-light", "light-buffer"}});
    const Rendered given_way = render_with(fan.world, volumes.camera, options_of(volumes));
    EXPECT_EQ(given_way.stats.settings.at("layer-light"), "lists");
    EXPECT_THAT(given_way.stats.notes, Contains(HasSubstr("layer-light")));
    expect_validation_clean(test_device());
}

// What one layer leaves in the light buffer is not the next one's, nor the next frame's.
TEST(TransparencyPeeled, TheLightBufferIsEachLayersOwn) {
    Panes panes(4, true);
    panes.world.ambient = glm::vec3(0);
    for (const double z : {-0.8, -0.4})
        panes.add_light({.kind = LightKind::point, .intensity = 0.5f, .range = 0.6f}, {2 * z + 1.2, 0, z});
    Shot shot = with(peeled(panes.shot()), {{"layer-light", "lists"}});
    shot.width = 160, shot.height = 90;
    const Image lists = render_linear(test_device(), shot);
    shot.settings["layer-light"] = "light-buffer";
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(panes.world);
    renderer->render(shot.camera, 3);
    expect_within(compare_pixels(renderer->read("linear"), lists), half_float_bound);
    PlacedCamera aside = shot.camera;
    aside.position.x += 0.7;
    renderer->render(aside, 2);
    renderer->render(shot.camera);
    expect_within(compare_pixels(renderer->read("linear"), lists), half_float_bound);
    expect_validation_clean(test_device());
}

// Each fragment is at its sample's own depth.
TEST(TransparencyPeeled, SamplesOfPanesThatCrossAgree) {
    const Fan fan(5);
    Shot shot = peeled(with_samples(fan.shot(), 480));
    const ReferencePicture reference =
        render_reference(fan.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within_on_edges(picture, reference, {.left_out = 0.2});
    expect_validation_clean(test_device());
}

// Surfaces at one place: the world's first one is the nearest.
TEST(TransparencyPeeled, SurfacesThatCoincideAreInTheWorldsOrder) {
    const CoincidentPanes test;
    const Shot shot = test.shot();
    const glm::dvec3 right = test.in_order();
    expect_layers(middle_of(render_reference(test.world, shot.camera, 64, 36, 0, form_of(peeled(shot))).linear), right,
                  3);
    for (const std::string& name : device_renderers)
        expect_layers(middle_of(render_linear(test_device(), peeled(shot, name))), right, 3);
    expect_validation_clean(test_device());
}

TEST(TransparencyPeeled, LayersBeyondThoseAskedForAreComposedAndTold) {
    const Panes panes(15);
    Shot shot = peeled(panes.shot());
    const ReferencePicture reference = render_reference(panes.world, shot.camera, 64, 36, 0, form_of(shot));
    double sum = 0, beyond = 0;
    for (const uint32_t layers : reference.layer_count) {
        sum += layers;
        beyond += layers - std::min(layers, 4u);
    }
    const Rendered all = render_with(panes.world, shot.camera, options_of(shot));
    ASSERT_TRUE(all.stats.layers);
    EXPECT_EQ(all.stats.layers->most, 15u);
    EXPECT_EQ(all.stats.layers->exact, 15u);
    EXPECT_DOUBLE_EQ(all.stats.layers->mean, sum / (64 * 36));
    EXPECT_EQ(all.stats.layers->approximate, 0u);
    EXPECT_THAT(all.stats.notes, Not(Contains(HasSubstr("peeled"))));
    shot.settings["peeled-layers"] = "4";
    const Rendered four = render_with(panes.world, shot.camera, options_of(shot));
    EXPECT_EQ(four.stats.layers->most, 15u);
    EXPECT_EQ(four.stats.layers->exact, 4u);
    EXPECT_EQ(double(four.stats.layers->approximate), beyond);
    EXPECT_THAT(four.stats.notes, Contains(HasSubstr(std::to_string(four.stats.layers->approximate) + " fragments")));
    expect_layers(middle_of(four.linear), laid_over({0.1, 0.3, 0.2}, panes.layers), 15);
    // Panes that cross: the nearest two of three are object by object.
    const Fan fan(3);
    shot = with(peeled(fan.shot()), {{"peeled-layers", "1"}});
    const Image one = render_linear(test_device(), shot);
    shot.settings["peeled-layers"] = "3";
    EXPECT_GT(compare_pixels(one, render_linear(test_device(), shot)).off_share, 0.002);
    expect_validation_clean(test_device());
}

// A camera that comes to see more layers than there were: the picture that is read has all of them.
TEST(TransparencyPeeled, FramesFindOutHowManyLayersThereAre) {
    Panes panes(15);
    Shot shot = peeled(panes.shot());
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(panes.world);
    const PlacedCamera near = look_at({.yfov = 0.8, .znear = 0.01}, {0, 0, -0.77}, {0, 0, -3}); // before the second
    renderer->render(near);
    const std::vector<glm::dvec4> farther(panes.layers.begin(), panes.layers.begin() + 2);
    expect_layers(middle_of(renderer->read("linear")), laid_over({0.1, 0.3, 0.2}, farther), 2);
    EXPECT_EQ(renderer->stats().layers->most, 2u);
    EXPECT_EQ(renderer->stats().layers->exact, 2u);
    const Image whole = render_linear(test_device(), shot);
    renderer->render(shot.camera);
    EXPECT_EQ(renderer->read("linear").pixels, whole.pixels);
    EXPECT_EQ(renderer->stats().layers->exact, 15u);
    EXPECT_EQ(renderer->stats().layers->approximate, 0u);
    renderer->render(near, 3);
    renderer->render(shot.camera, 4); // in a row: the third has them
    EXPECT_EQ(renderer->stats().layers->exact, 15u);
    EXPECT_EQ(renderer->read("linear").pixels, whole.pixels);
    panes.world.instances[1].visible = false;
    renderer->update_world({.instances = {1}});
    renderer->render(shot.camera);
    EXPECT_EQ(renderer->read("linear").pixels, render_linear(test_device(), shot).pixels);
    expect_validation_clean(test_device());
}

TEST(TransparencyPeeled, WithoutListsLightsAreThoseOfTheObject) {
    const Stats stats = expect_the_same_in_rounds({{"transparency", "peeled"}});
    EXPECT_EQ(stats.settings.at("transparency"), "peeled");
    EXPECT_THAT(stats.notes, Contains(HasSubstr("object by object")));
}

} // namespace
} // namespace prelight
