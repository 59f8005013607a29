// Weighted blended transparency: what of it is exact, and how far off the rest is.
#include "panes.hpp"
#include <algorithm>
#include <gpu/context.hpp>
#include <numeric>
#include <prelight/material_shader.hpp>
#include <random>
#include <shared/blended_weight.h>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Shot weighted(Shot shot, const std::string& renderer = "light-prepass") {
    shot.renderer = renderer;
    return with(shot, {{"transparency", "weighted"}});
}

/// Panes that fill the picture before a wall, 5 m from the camera at z = 0.
struct Pile : TestWorld {
    struct Layer {
        glm::dvec4 colour{0};
        double z = 0;
        glm::vec3 emissive{0}; ///< lit where it is not 0
    };
    glm::dvec3 wall{0};
    std::vector<Layer> layers; ///< farthest first
    /// `order`: in which layers get materials, meshes and instances.
    Pile(glm::dvec3 behind, std::vector<Layer> of, const std::vector<size_t>& order)
        : wall(behind), layers(std::move(of)) {
        add_material(unlit_material("wall", glm::vec4(behind, 1), AlphaMode::opaque));
        add(square(20), placed_at(0, 0, -3));
        for (const size_t i : order) {
            const Layer& layer = layers[i];
            Material material = unlit_material("pane", glm::vec4(layer.colour));
            material.emissive = layer.emissive;
            material.unlit = layer.emissive == glm::vec3(0);
            add_material(material);
            add(square(6), placed_at(0, 0, layer.z));
        }
    }
    Pile(glm::dvec3 behind, const std::vector<Layer>& of) : Pile(behind, of, in_turn(of.size())) {}
    static std::vector<size_t> in_turn(size_t count) {
        std::vector<size_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        return order;
    }
    Shot shot() const { return {.world = &world, .camera = front_camera(5), .width = 64, .height = 36}; }
};

/// Between 1.5 m and 6 m before the camera.
std::vector<Pile::Layer> differing_layers(size_t count) {
    std::vector<Pile::Layer> layers(count);
    for (size_t i = 0; i < count; ++i) {
        const auto t = static_cast<double>(i);
        layers[i] = {.colour = {0.5 + 0.45 * std::sin(2 * t), 0.5 + 0.45 * std::sin(3 * t + 1),
                                0.5 + 0.45 * std::cos(5 * t), 0.2 + 0.07 * static_cast<double>(i % 5)},
                     .z = -1 + 4.5 * t / static_cast<double>(std::max<size_t>(count - 1, 1))};
    }
    return layers;
}

/// Equation (6) of the paper.
glm::dvec3 weighted_mean_over(const Pile& pile) {
    glm::dvec3 sum(0);
    double weights = 0, left = 1;
    for (const Pile::Layer& layer : pile.layers) {
        const double weight =
            shared::blended_weight(static_cast<float>(5 - layer.z), static_cast<float>(layer.colour.a), 1.0f);
        sum += weight * glm::dvec3(layer.colour);
        weights += weight;
        left *= 1 - layer.colour.a;
    }
    return (1 - left) * sum / weights + left * pile.wall;
}

class WeightedBlending : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, WeightedBlending, testing::ValuesIn(every_way({.width = 160, .height = 90})), way_name);

TEST_P(WeightedBlending, OneLitLayerIsExact) {
    LitPane lit;
    Shot shot = in_way(lit.shot(), GetParam());
    const Image expected = expected_of(lit, shot);
    lit.pane().alpha_mode = AlphaMode::blend;
    shot = weighted(shot, shot.renderer);
    expect_within(compare_pixels(render_linear(test_device(), shot), expected), half_float_bound);
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingForms, OneLayerAgreesWithTheReference) {
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        LitPane lit;
        lit.pane().alpha_mode = AlphaMode::blend;
        expect_agrees(weighted(lit.shot(), name));
    }
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    lit.camera.camera.kind = ProjectionKind::orthographic;
    lit.camera.camera.ymag = 3;
    lit.camera.camera.zfar = 30;
    expect_agrees(weighted(lit.shot()));
}

TEST(WeightedBlendingForms, OwnMaterialsAndShadowsAreThoseOfLists) {
    LitPane lit(find_material_shader("minnaert"));
    lit.pane().alpha_mode = AlphaMode::blend;
    for (const char* name : {"light-prepass", "z-prepass"}) {
        SCOPED_TRACE(name);
        Shot shot = lit.shot();
        shot.renderer = name;
        shot.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}};
        const Image lists = render_linear(test_device(), shot);
        expect_within(compare_pixels(render_linear(test_device(), weighted(shot, name)), lists), half_float_bound);
    }
    expect_validation_clean(test_device());
}

// With one layer on a pixel both are exact, on edges too.
TEST(WeightedBlendingForms, SamplesAreThoseOfLists) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        Shot shot = with_samples(lit.shot());
        shot.renderer = name;
        if (name == "light-prepass")
            shot.settings = {{"msaa-material", "sample"}};
        const Image lists = render_linear(test_device(), shot);
        expect_within(compare_pixels(render_linear(test_device(), weighted(shot, name)), lists), half_float_bound);
    }
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingOrder, MakesNoDifference) {
    const std::vector<Pile::Layer> layers = differing_layers(15);
    std::vector<size_t> order = Pile::in_turn(layers.size());
    const Image first = render_linear(test_device(), weighted(Pile({0.1, 0.3, 0.2}, layers, order).shot()));
    std::mt19937 lot(7);
    for (int i = 0; i < 6; ++i) {
        std::shuffle(order.begin(), order.end(), lot);
        const Pile pile({0.1, 0.3, 0.2}, layers, order);
        const Image picture = render_linear(test_device(), weighted(pile.shot()));
        for (size_t p = 0; p < picture.pixels.size(); ++p)
            for (int c = 0; c < 3; ++c) // each of 15 additions may lose half a step of a half float
                ASSERT_NEAR(picture.pixels[p][c], first.pixels[p][c], 15.0 / 2048) << "pixel " << p;
    }
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingCoverage, IsExactWhateverTheNumberOfLayers) {
    for (const double alpha : {0.02, 0.3, 0.9, 1.0})
        for (const size_t count : {1, 2, 4, 15, 64}) {
            SCOPED_TRACE(std::to_string(count) + " of " + std::to_string(alpha));
            std::vector<Pile::Layer> layers(count);
            for (size_t i = 0; i < count; ++i)
                layers[i] = {.colour = {1, 1, 1, alpha}, .z = -1 + 0.08 * static_cast<double>(i)};
            const Pile pile(glm::dvec3(0), layers);
            const double covered = 1 - std::pow(1 - alpha, static_cast<double>(count));
            const glm::vec3 pixel = middle_of(render_linear(test_device(), weighted(pile.shot())));
            // What is left of what is behind is a half float below 1: a layer may lose a step of it, 1/2048.
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixel[c], covered, static_cast<double>(count) / 2048 + 2 * covered / 1024) << c;
        }
    expect_validation_clean(test_device());
}

// Measured: docs/transparency.md has these figures.
TEST(WeightedBlendingError, IsThatOfThePaperAndBounded) {
    struct Case {
        size_t layers;
        double most; ///< of any channel, of 1
    };
    for (const auto& [count, most] : {Case{1, 0.002}, Case{2, 0.1}, Case{4, 0.08}, Case{15, 0.05}}) {
        SCOPED_TRACE(count);
        const Pile pile({0.1, 0.3, 0.2}, differing_layers(count));
        const Shot shot = weighted(pile.shot());
        const Image right = render_reference(pile.world, shot.camera, 64, 36, 0, form_of(shot)).linear;
        std::vector<glm::dvec4> colours;
        for (const Pile::Layer& layer : pile.layers)
            colours.push_back(layer.colour);
        expect_layers(middle_of(right), laid_over(pile.wall, colours), count);
        for (const std::string& name : device_renderers) {
            const Image picture = render_linear(test_device(), weighted(pile.shot(), name));
            expect_layers(middle_of(picture), weighted_mean_over(pile), count);
            double off = 0;
            for (size_t p = 0; p < picture.pixels.size(); ++p)
                for (int c = 0; c < 3; ++c)
                    off = std::max<double>(off, std::abs(picture.pixels[p][c] - right.pixels[p][c]));
            EXPECT_LT(off, most) << name;
            std::printf("%zu layers: off by up to %.4f (%s)\n", count, off, name.c_str());
        }
    }
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingRange, BrightLayersStayFinite) {
    for (const size_t count : {64, 300})
        for (const float light : {50.0f, 30000.0f}) {
            SCOPED_TRACE(std::to_string(count) + " of " + std::to_string(light));
            std::vector<Pile::Layer> layers(count);
            for (size_t i = 0; i < count; ++i) // from the camera's nose on
                layers[i] = {.colour = {0, 0, 0, i % 3 == 0 ? 1.0 : 0.1},
                             .z = 4.9 - 5.0 * static_cast<double>(i) / static_cast<double>(count),
                             .emissive = glm::vec3(light, 0.5f * light, 0.25f * light)};
            const Pile pile(glm::dvec3(0.5), layers);
            const Image picture = render_linear(test_device(), weighted(pile.shot()));
            for (const glm::vec3& pixel : picture.pixels)
                for (int c = 0; c < 3; ++c)
                    ASSERT_TRUE(std::isfinite(pixel[c]) && pixel[c] >= 0);
            if (count == 64) { // their sums are within half floats, of which 64 additions lose what they lose
                const glm::vec3 pixel = middle_of(picture);
                EXPECT_NEAR(pixel.r / light, 1, 0.04);
                EXPECT_NEAR(pixel.g / light, 0.5, 0.02);
                EXPECT_NEAR(pixel.b / light, 0.25, 0.01);
            }
        }
    expect_validation_clean(test_device());
}

Rendered weighted_picture(const Pile& pile, const std::string& renderer, std::vector<std::string>& passes) {
    const Rendered out =
        render_with(pile.world, pile.shot().camera, options_of(weighted(pile.shot(), renderer)), renderer);
    passes.clear();
    for (const PassStats& pass : out.stats.passes)
        passes.push_back(pass.name);
    return out;
}

TEST(WeightedBlendingStats, SayThatItIsApproximateAndCostNothingWithoutIt) {
    Pile pile({0.1, 0.3, 0.2}, differing_layers(4));
    for (const std::string& name : device_renderers) {
        SCOPED_TRACE(name);
        std::vector<std::string> passes;
        const Rendered blended = weighted_picture(pile, name, passes);
        EXPECT_THAT(blended.stats.notes, Contains(HasSubstr("weighted: 4 draws of blended surfaces")));
        EXPECT_EQ(blended.stats.settings.at("transparency"), "weighted");
        EXPECT_THAT(passes, Contains("blended"));
        EXPECT_THAT(passes, Contains("blended compose"));
        for (Material& material : pile.scene.materials)
            material.alpha_mode = AlphaMode::opaque;
        const Rendered opaque = weighted_picture(pile, name, passes);
        EXPECT_THAT(passes, Not(Contains(HasSubstr("blended"))));
        EXPECT_THAT(opaque.stats.notes, Not(Contains(HasSubstr("weighted"))));
        for (size_t i = 1; i < pile.scene.materials.size(); ++i)
            pile.scene.materials[i].alpha_mode = AlphaMode::blend;
    }
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingStats, SayWhatItGivesWayTo) {
    const auto device = Device::create({.select = "cpu", .validate = true});
    dynamic_cast<gpu::Context&>(*device).end_loops_after(24); // a light takes two turns
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    const Shot shot = with(lit.shot(), {{"light-culling", "volumes"}});
    const auto renderer = create_renderer("light-prepass", device.get(), options_of(weighted(shot)));
    renderer->set_world(lit.world);
    renderer->render(lit.camera);
    EXPECT_EQ(renderer->stats().settings.at("transparency"), "sorted");
    EXPECT_THAT(renderer->stats().notes, Contains(HasSubstr("transparency=weighted")));
    expect_validation_clean(*device);
}

TEST(WeightedBlendingFrames, ChangeAsANewRendererAndMakeNothing) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    Shot shot = weighted(lit.shot());
    const auto kept = create_renderer(shot.renderer, &test_device(), options_of(shot));
    kept->set_world(lit.world);
    for (int frame = 0; frame < 6; ++frame) {
        shot.camera.position += glm::dvec3(0.05, 0.02, -0.05);
        kept->render(shot.camera);
        if (frame >= 3) { // lists find out how much room they need
            EXPECT_EQ(kept->stats().created, CreatedObjects{}) << "frame " << frame;
        }
    }
    const auto instance = static_cast<uint32_t>(lit.world.instances.size() - 1);
    for (const bool visible : {false, true}) {
        lit.world.instances.back().visible = visible;
        kept->update_world({.instances = {instance}});
        kept->render(shot.camera, 2);
        EXPECT_EQ(kept->read("linear").pixels, render_linear(test_device(), shot).pixels);
        EXPECT_EQ(testing::Matches(Contains(HasSubstr("approximately")))(kept->stats().notes), visible);
    }
    expect_validation_clean(test_device());
}

TEST(WeightedBlendingOnSwiftShader, IsThatOfThePaper) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const Pile pile({0.1, 0.3, 0.2}, differing_layers(4));
    for (const uint32_t samples : {1u, 4u}) {
        Shot shot = weighted(pile.shot());
        shot.samples = samples;
        expect_layers(middle_of(render_linear(*device, shot)), weighted_mean_over(pile), 4);
    }
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
