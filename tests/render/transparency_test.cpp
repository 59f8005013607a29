// Blended surfaces: what is behind them shows through, layer by layer, in every architecture.
#include "panes.hpp"

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class Transparency : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, Transparency, testing::ValuesIn(every_blended_way()), way_name);

TEST_P(Transparency, LayersComposeBackToFront) {
    for (const size_t count : {1, 4, 15}) {
        const Panes panes(count);
        const glm::vec3 pixel = middle_of(render_linear(test_device(), in_way(panes.shot(), GetParam())));
        expect_layers(pixel, laid_over({0.1, 0.3, 0.2}, panes.layers), count);
    }
    expect_validation_clean(test_device());
}

TEST_P(Transparency, SurfacesThatCoincideAreInTheWorldsOrder) {
    const CoincidentPanes panes;
    expect_layers(middle_of(render_linear(test_device(), in_way(panes.shot(), GetParam()))), panes.in_order(), 3);
    expect_validation_clean(test_device());
}

TEST_P(Transparency, ALitPaneIsItsOpaqueSelfByAlpha) {
    LitPane lit;
    const Shot shot = in_way(lit.shot(), GetParam());
    const Image expected = expected_of(lit, shot);
    lit.pane().alpha_mode = AlphaMode::blend;
    expect_within(compare_pixels(render_linear(test_device(), shot), expected), half_float_bound);
    expect_validation_clean(test_device());
}

// Tiles and clusters look for lights no nearer than the nearest opaque surface.
TEST_P(Transparency, ALightBeforeAllOpaqueSurfacesLightsThePane) {
    Panes panes(1, true);
    panes.world.ambient = glm::vec3(0);
    const Shot shot = in_way(panes.shot(), GetParam());
    const glm::vec3 dark = middle_of(render_linear(test_device(), shot));
    panes.add_light({.kind = LightKind::point, .intensity = 1, .range = 1}, {0, 0, -0.5});
    const glm::vec3 lit = middle_of(render_linear(test_device(), shot));
    const glm::dvec4 pane = panes.layers[0];
    // I (1 − (d/r)⁴) / d² at half a metre, of which a π-th comes back; a little less beside.
    for (int c = 0; c < 3; ++c) {
        const double should = pane.a * pane[c] * (1 - 1 / 16.0) * 4 / 3.14159;
        EXPECT_GT(lit[c] - dark[c], 0.85 * should) << c;
        EXPECT_LT(lit[c] - dark[c], should) << c;
    }
    expect_validation_clean(test_device());
}

/// A closed ball before a wall: red in front, blue behind.
struct Ball : TestWorld {
    explicit Ball(bool double_sided, bool mirrored) {
        add_material(unlit_material("wall", {0.4f, 0.4f, 0.4f, 1}, AlphaMode::opaque));
        add(square(20), placed_at(0, 0, -3));
        Material& material = add_material(unlit_material("ball", {1, 1, 1, 0.5f}));
        material.double_sided = double_sided;
        Primitive ball = sphere();
        for (const glm::vec3& p : ball.positions)
            ball.colours.push_back(p.z > 0 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 0, 1, 0.5f));
        add(ball, glm::scale(placed_at(0, 0, 0), {mirrored ? -1 : 1, 1, 1}));
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(5), .width = 64, .height = 36}; }
};

TEST_P(Transparency, BackFacesComeBeforeFrontOnes) {
    for (const bool mirrored : {false, true})
        for (const bool double_sided : {false, true}) {
            SCOPED_TRACE(std::string(mirrored ? "mirrored" : "") + (double_sided ? " double-sided" : ""));
            const Ball ball(double_sided, mirrored);
            std::vector<glm::dvec4> layers{{1, 0, 0, 0.5}};
            if (double_sided)
                layers.insert(layers.begin(), {0, 0, 1, 0.25}); // factor times vertex colour
            const glm::vec3 pixel = middle_of(render_linear(test_device(), in_way(ball.shot(), GetParam())));
            expect_layers(pixel, laid_over(glm::dvec3(0.4), layers), 2);
        }
}

// Between two panes one sees the farther one; what is masked hides or lets pass what lies behind it.
TEST_P(Transparency, CamerasAmongPanesAndHolesBeforeThem) {
    Panes panes(4);
    Shot shot = in_way(panes.shot(), GetParam());
    shot.camera = look_at({.yfov = 0.8, .znear = 0.01}, {0, 0, -0.77}, {0, 0, -3}); // of −1, −0.85, −0.7 and −0.55
    const std::vector<glm::dvec4> farther(panes.layers.begin(), panes.layers.begin() + 2);
    expect_layers(middle_of(render_linear(test_device(), shot)), laid_over({0.1, 0.3, 0.2}, farther), 2);

    shot.camera =
        look_at({.kind = ProjectionKind::orthographic, .ymag = 1, .znear = 0, .zfar = 20}, {0, 0, 5}, {0, 0, 0});
    expect_layers(middle_of(render_linear(test_device(), shot)), laid_over({0.1, 0.3, 0.2}, panes.layers), 4);

    const uint32_t halves = panes.add_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
    Material masked = unlit_material("masked", {0.8f, 0.1f, 0.1f, 1}, AlphaMode::mask);
    masked.base_colour_texture = {.image = halves};
    panes.add_material(masked);
    panes.add(square(2), placed_at(0, 0, -0.77));
    const Image picture = render_linear(test_device(), shot);
    const std::vector<glm::dvec4> nearer(panes.layers.begin() + 2, panes.layers.end());
    const size_t row = size_t(picture.height / 2) * picture.width;
    expect_layers(picture.pixels[row + 8], laid_over({0.8, 0.1, 0.1}, nearer), 2);
    expect_layers(picture.pixels[row + 56], laid_over({0.1, 0.3, 0.2}, panes.layers), 4);
    expect_validation_clean(test_device());
}

std::vector<std::string> passes_of(const Shot& shot, Stats* stats = nullptr) {
    RenderOptions options = options_of(shot);
    options.views = {"final"};
    const auto renderer = create_renderer(shot.renderer, &test_device(), options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    const Stats drawn = renderer->stats();
    std::vector<std::string> names;
    for (const PassStats& pass : drawn.passes)
        names.push_back(pass.name);
    if (stats)
        *stats = drawn;
    return names;
}

TEST_P(Transparency, CostsNothingWhereNothingIsBlended) {
    Panes panes(2, true);
    const Shot shot = in_way(panes.shot(), GetParam());
    const std::vector<std::string> blended = passes_of(shot);
    EXPECT_THAT(blended, Contains("blended"));
    Shot as_opaque = shot;
    as_opaque.settings["transparency"] = "opaque";
    Stats stats;
    const std::vector<std::string> opaque = passes_of(as_opaque, &stats);
    EXPECT_THAT(opaque, Not(Contains(HasSubstr("blended"))));
    EXPECT_THAT(stats.notes, Contains(HasSubstr("alphaMode BLEND are drawn opaque")));
    const Image image = render_linear(test_device(), as_opaque);
    for (Material& material : panes.scene.materials)
        material.alpha_mode = AlphaMode::opaque;
    EXPECT_EQ(passes_of(shot, &stats), opaque);
    EXPECT_THAT(stats.notes, Not(Contains(HasSubstr("BLEND"))));
    EXPECT_EQ(render_linear(test_device(), shot).pixels, image.pixels);
}

// What is blended, where and whether at all, changes between frames.
TEST_P(Transparency, ChangesAreWhatANewRendererDraws) {
    Panes panes(4);
    const Shot shot = in_way(panes.shot(), GetParam());
    const auto kept = create_renderer(shot.renderer, &test_device(), options_of(shot));
    for (Material& material : panes.scene.materials)
        material.alpha_mode = AlphaMode::opaque;
    kept->set_world(panes.world);
    const auto expect_as_new = [&](const char* what) {
        kept->render(shot.camera, 2);
        EXPECT_EQ(kept->read("linear").pixels, render_linear(test_device(), shot).pixels) << what;
    };
    expect_as_new("opaque");
    for (uint32_t m = 1; m < 5; ++m)
        panes.scene.materials[m].alpha_mode = AlphaMode::blend;
    kept->update_world({.materials = {1, 2, 3, 4}});
    expect_as_new("blended");
    panes.scene.materials[2].base_colour.a = 0.9f;
    std::swap(panes.world.instances[1].transform, panes.world.instances[3].transform);
    kept->update_world({.instances = {1, 3}, .materials = {2}});
    expect_as_new("moved");
    for (uint32_t i = 1; i < 5; ++i)
        panes.world.instances[i].visible = false;
    kept->update_world({.instances = {1, 2, 3, 4}});
    expect_as_new("hidden");
    panes.world.instances[2].visible = true;
    kept->update_world({.instances = {2}});
    expect_as_new("one shown");
    panes.scene.materials[3].alpha_mode = panes.scene.materials[2].alpha_mode = AlphaMode::opaque;
    kept->update_world({.materials = {2, 3}});
    expect_as_new("two opaque");
    expect_validation_clean(test_device());
}

TEST_P(Transparency, SeveralSamplesAPixelAreBlendedEach) {
    const Panes panes(4);
    Shot shot = in_way(panes.shot(), GetParam());
    shot.samples = 4;
    const Image picture = render_linear(test_device(), shot);
    expect_layers(middle_of(picture), laid_over({0.1, 0.3, 0.2}, panes.layers), 4);
    expect_validation_clean(test_device());
}
} // namespace
} // namespace prelight
