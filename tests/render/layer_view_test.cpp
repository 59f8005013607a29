// --view layer=N: one blended surface of each pixel, against the reference's own layers.
#include "panes.hpp"
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;

std::unique_ptr<Renderer> drawn_with(const Shot& shot, const std::vector<std::string>& views) {
    RenderOptions options = options_of(shot);
    options.views = views;
    auto renderer = create_renderer(shot.renderer, shot.renderer == "reference" ? nullptr : &test_device(), options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer;
}

/// Of the pixels that count: how many there are, how many are not black, and how many differ by more than 2/255.
struct Differences {
    size_t counted = 0, lit = 0, off = 0;
};
Differences differences(const Image& shown, const Image& right, const std::vector<uint8_t>& left_out) {
    Differences out;
    for (size_t i = 0; i < shown.pixels.size(); ++i) {
        if (left_out[i])
            continue;
        const glm::vec3 apart = glm::abs(shown.pixels[i] - right.pixels[i]);
        ++out.counted;
        out.lit += right.pixels[i] != glm::vec3(0);
        out.off += std::max({apart.r, apart.g, apart.b}) > 2.0f / 255;
    }
    return out;
}

// Panes that cross lie in another order on either side.
TEST(LayerView, AgreesWithTheReference) {
    const std::vector<std::string> views{"layer=1", "layer=2", "layer=3"};
    const Fan fan(4);
    for (const uint32_t samples : {1u, 4u})
        for (const std::string& name : device_renderers) {
            Shot shot = fan.shot();
            shot.width = 96;
            shot.height = 54;
            shot.samples = samples;
            shot.renderer = name;
            const std::vector<uint8_t> left_out =
                render_reference(fan.world, shot.camera, shot.width, shot.height, 0, form_of(shot)).left_out();
            const auto renderer = drawn_with(shot, views);
            shot.renderer = "reference";
            shot.settings = {{"model", name == "light-prepass" ? "weighted" : "full"}};
            if (samples > 1)
                shot.settings["msaa-layers"] = "fragment";
            const auto truth = drawn_with(shot, views);
            for (const std::string& view : views) {
                SCOPED_TRACE(name + " " + view + " of " + std::to_string(samples));
                const Image shown = renderer->read(view), right = truth->read(view);
                const Differences found = differences(shown, right, left_out);
                EXPECT_GT(found.counted, shown.pixels.size() * 2 / 3);
                EXPECT_GT(found.lit, shown.pixels.size() / 20);
                EXPECT_LE(found.off, found.counted / 1000);
            }
        }
    expect_validation_clean(test_device());
}

TEST(LayerView, IsWhatTheLayerAddsAndBlackWithoutOne) {
    Panes panes(4);
    for (const char* how : {"lists", "sorted", "peeled", "weighted", "k-buffer"}) {
        SCOPED_TRACE(how);
        const auto renderer =
            drawn_with(with(panes.shot(), {{"transparency", how}}), {"layer=1", "layer=4", "layer=5", "layers"});
        for (const size_t number : {1, 4}) {
            const glm::dvec4 pane = panes.layers[4 - number]; // the farthest first
            const glm::vec3 shown = middle_of(renderer->read("layer=" + std::to_string(number)));
            const glm::vec3 light = display_light(glm::vec3(pane.a * glm::dvec3(pane)), Tonemap::pbr_neutral);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(shown[c], srgb_encode(light[c]), 1.5 / 255) << number;
        }
        for (const glm::vec3& pixel : renderer->read("layer=5").pixels)
            ASSERT_EQ(pixel, glm::vec3(0));
    }
    for (Material& material : panes.scene.materials)
        material.alpha_mode = AlphaMode::opaque;
    EXPECT_EQ(middle_of(drawn_with(panes.shot(), {"layer=1"})->read("layer=1")), glm::vec3(0));
    expect_validation_clean(test_device());
}

TEST(LayerView, LeavesThePictureAndItsPassesAsTheyAre) {
    const Panes panes(4);
    const auto with_view = drawn_with(panes.shot(), {"linear", "layer=2"}),
               without = drawn_with(panes.shot(), {"linear"});
    EXPECT_EQ(with_view->read("linear").pixels, without->read("linear").pixels);
    for (const PassStats& pass : without->stats().passes)
        EXPECT_THAT(pass.name, testing::Not(HasSubstr("view")));
    expect_validation_clean(test_device());
}

TEST(LayerView, IsNamedByANumber) {
    EXPECT_EQ(layer_of_view("layer=1"), 1u);
    EXPECT_EQ(layer_of_view("layer=256"), 256u);
    const Panes panes(1);
    for (const char* name : {"layer=0", "layer=257", "layer=01", "layer=-1", "layer=+1", "layer=x",
                             "layer=", "layer=1x", "layer", "layer=99999999999"})
        for (const char* renderer : {"light-prepass", "reference"}) {
            Shot shot = panes.shot();
            shot.renderer = renderer;
            EXPECT_FALSE(layer_of_view(name)) << name;
            try {
                drawn_with(shot, {name});
                ADD_FAILURE() << renderer << " " << name;
            } catch (const UsageError& error) {
                EXPECT_THAT(error.what(), HasSubstr("layer=1 … layer=256"));
            }
        }
    for (const char* renderer : {"light-prepass", "reference"}) {
        Shot shot = with(panes.shot(), {{"transparency", "half-samples"}});
        shot.samples = 4;
        shot.renderer = renderer;
        EXPECT_THROW(drawn_with(shot, {"layer=1"}), UsageError) << renderer;
    }
}

} // namespace
} // namespace prelight
