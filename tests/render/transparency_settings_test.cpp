// Blended surfaces: ways to find their lights, and what gives way to them.
#include "panes.hpp"

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;

// A material's own shader says alpha, and gets the same sums of light.
TEST(TransparencyOfOwnMaterials, IsTheirOpaqueSelfByAlpha) {
    for (const char* name : {"light-prepass", "z-prepass"}) {
        SCOPED_TRACE(name);
        LitPane lit(find_material_shader("minnaert"));
        Shot shot = lit.shot();
        shot.renderer = name;
        if (shot.renderer == "z-prepass")
            shot.settings = {{"lights", "grid"}};
        const Image expected = expected_of(lit, shot);
        lit.pane().alpha_mode = AlphaMode::blend;
        expect_within(compare_pixels(render_linear(test_device(), shot), expected), half_float_bound);
    }
    expect_validation_clean(test_device());
}

// Lights of an object come a few a draw; the first draw alone covers what is behind.
TEST(TransparencySorted, BatchesAddUp) {
    LitPane lit;
    Shot shot = lit.shot();
    shot.settings = {{"model", "nv"}, {"transparency", "lists"}};
    lit.pane().alpha_mode = AlphaMode::blend;
    const Image lists = render_linear(test_device(), shot);
    uint64_t draws = 0;
    for (const char* lights : {"1", "3", "8"}) {
        shot.settings["transparency"] = "sorted";
        shot.settings["blended-lights"] = lights;
        const Rendered sorted = render_with(lit.world, lit.camera, options_of(shot));
        expect_within(compare_pixels(sorted.linear, lists), half_float_bound);
        EXPECT_NE(sorted.stats.draws, draws) << "fewer draws where each has more lights";
        draws = sorted.stats.draws;
    }
    expect_validation_clean(test_device());
}

TEST(TransparencyLists, GiveWayWhereTheyTakeSeveralRounds) {
    const Stats stats = expect_the_same_in_rounds({});
    EXPECT_EQ(stats.settings.at("transparency"), "sorted");
    EXPECT_THAT(stats.notes, Contains(HasSubstr("rounds of lists")));
}

TEST(TransparencySteadyFrame, MakesNothing) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    for (const char* how : {"lists", "sorted", "peeled", "k-buffer"}) {
        SCOPED_TRACE(how);
        Shot shot = lit.shot();
        shot.settings = {{"transparency", how}};
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(lit.world);
        for (int frame = 0; frame < 6; ++frame) {
            shot.camera.position += glm::dvec3(0.05, 0.02, -0.05);
            renderer->render(shot.camera);
            if (frame >= 3) { // lists find out how much room they need
                EXPECT_EQ(renderer->stats().created, CreatedObjects{}) << "frame " << frame;
            }
        }
    }
    expect_validation_clean(test_device());
}

// Two panes that cross, with one middle: object by object the world's first one is over the other on both sides. The
// reference shows what of that is wrong.
TEST(TransparencyOrder, IsOfObjectsAndNotOfFragments) {
    TestWorld test;
    const glm::dvec4 red(0.9, 0.1, 0.1, 0.5), blue(0.1, 0.1, 0.9, 0.5);
    for (const glm::dvec4& colour : {red, blue}) {
        test.add_material(unlit_material("pane", colour));
        test.scene.materials.back().double_sided = true;
        test.add(square(2), glm::rotate(placed_at(0, 0, 0), colour.r > 0.5 ? 0.5 : -0.5, glm::dvec3(0, 1, 0)));
    }
    const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 64, .height = 36};
    const Image picture = render_linear(test_device(), shot);
    const Image right = render_reference(test.world, shot.camera, 64, 36, 0, form_of(shot)).linear;
    const size_t row = 18 * 64, left = row + 24, middle_right = row + 40;
    const glm::dvec3 blue_over = laid_over(glm::dvec3(0), {red, blue}),
                     red_over = laid_over(glm::dvec3(0), {blue, red});
    expect_layers(picture.pixels[left], red_over, 2);
    expect_layers(picture.pixels[middle_right], red_over, 2);
    expect_layers(right.pixels[left], red_over, 2);
    expect_layers(right.pixels[middle_right], blue_over, 2);
    expect_validation_clean(test_device());
}

// Maps that are made light after light are gone when blended surfaces are lit.
TEST(TransparencyShadows, AreReadFromTheMapsOfAllLights) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    Shot shot = lit.shot();
    shot.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}, {"light-culling", "volumes"}};
    const Image atlas = render_linear(test_device(), shot);
    shot.settings["shadow-memory"] = "reuse";
    const auto renderer = create_renderer("light-prepass", &test_device(), options_of(shot));
    renderer->set_world(lit.world);
    renderer->render(lit.camera);
    EXPECT_EQ(renderer->read("linear").pixels, atlas.pixels);
    EXPECT_EQ(renderer->stats().settings.at("shadow-memory"), "atlas");
    EXPECT_THAT(renderer->stats().notes, Contains(HasSubstr("shadow-memory=reuse")));
    lit.pane().alpha_mode = AlphaMode::opaque;
    renderer->set_world(lit.world);
    renderer->render(lit.camera);
    EXPECT_EQ(renderer->stats().settings.at("shadow-memory"), "reuse");
    expect_validation_clean(test_device());
}

TEST(TransparencyOnSwiftShader, LayersComposeBackToFront) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    for (const char* how : {"lists", "sorted", "peeled", "k-buffer"})
        for (const char* name : {"light-prepass", "deferred", "z-prepass", "multipass"}) {
            SCOPED_TRACE(std::string(name) + " " + how);
            Panes panes(4);
            Shot shot = panes.shot();
            shot.renderer = name;
            shot.settings = {{"transparency", how}};
            expect_layers(middle_of(render_linear(*device, shot)), laid_over({0.1, 0.3, 0.2}, panes.layers), 4);
        }
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
