// Shadows of blended surfaces: as deep as their alpha, by a map of what they leave of the light or by chance.
#include "panes.hpp"

namespace prelight {
namespace {

const std::vector<std::string> lit_by_maps{"light-prepass", "deferred", "z-prepass", "multipass", "inferred"};

/// A wall and a shelf before it, under lights from behind the camera, where panes stand that overlap in part. One more
/// stands between shelf and wall. The camera sees none of them.
struct Shade : TestWorld {
    static constexpr uint32_t first_pane = 3, shelf = 1; ///< instances
    explicit Shade(LightKind kind) {
        add_material({.base_colour = {0.6f, 0.7f, 0.8f, 1}, .metallic = 0, .roughness = 1});
        add(square(20), placed_at(0, 0, -3));
        add(square(0.9f), placed_at(-1.4, -0.6, -1));
        add_material(blended_material(0.5f));
        add(square(0.7f), placed_at(-1.4, -0.6, -2));
        add_material(blended_material(0.25f));
        add(square(0.6f), placed_at(-0.4, 0, 5.6));
        add_material(blended_material(0.7f));
        add(square(0.6f), placed_at(0.2, 0.2, 5.9));
        const uint32_t ramp = add_image(2, 1, {255, 255, 255, 26, 255, 255, 255, 230});
        Material material = blended_material(1);
        material.base_colour_texture = {.image = ramp};
        add_material(material);
        add(square(0.5f), placed_at(0.1, -0.5, 6.2));
        add_light({.kind = kind,
                   .intensity = kind == LightKind::directional ? 2.0f : 250.0f,
                   .range = 40,
                   .inner_cone = 0.4f,
                   .outer_cone = 0.5f},
                  {0.1, 0, 9}, {0, 0, -1});
    }
    static Material blended_material(float alpha) {
        Material material{.name = "pane", .metallic = 0, .alpha_mode = AlphaMode::blend};
        material.base_colour = {1, 1, 1, alpha};
        return material;
    }
    Shot shot(const std::string& shadows) const {
        Shot shot{.world = &world, .camera = front_camera(5), .width = 240, .height = 135};
        shot.settings = {{"shadows", "on"}, {"shadow-budget", "16777216"}, {"shadow-detail", "8"}};
        shot.settings["transparent-shadows"] = shadows;
        return shot;
    }
};

class TransparentShadows : public testing::TestWithParam<LightKind> {};
INSTANTIATE_TEST_SUITE_P(All, TransparentShadows,
                         testing::Values(LightKind::directional, LightKind::point, LightKind::spot),
                         [](const auto& kind) {
                             return kind.param == LightKind::directional ? "Directional"
                                    : kind.param == LightKind::point     ? "Point"
                                                                         : "Spot";
                         });

TEST_P(TransparentShadows, AgreeWithShadowRays) {
    const Shade shade(GetParam());
    const bool all = GetParam() == LightKind::point; // other kinds: where they may differ
    for (const char* shadows : {"filtered", "opaque", "none"}) {
        if (!all && shadows != std::string("filtered"))
            continue;
        Shot shot = shade.shot(shadows);
        shot.settings["shadow-filter"] = "hard";
        References references;
        const ReferencePicture& expected = references.of(shot);
        for (const std::string& renderer : lit_by_maps) {
            if (!all && renderer != lit_by_maps[0])
                continue;
            SCOPED_TRACE(renderer + " " + shadows);
            shot.renderer = renderer;
            if (renderer == "inferred")
                shot.settings["inferred-scale"] = "1";
            expect_within(compare_pixels(render_linear(test_device(), shot), expected.linear, expected.left_out()),
                          half_float_bound);
            shot.settings.erase("inferred-scale");
        }
    }
    expect_validation_clean(test_device());
}

/// Mean of a picture's green over 10×10 pixels, for each such block.
std::vector<double> block_means(const Image& picture) {
    std::vector<double> means;
    for (uint32_t y = 0; y + 10 <= picture.height; y += 10)
        for (uint32_t x = 0; x + 10 <= picture.width; x += 10) {
            double sum = 0;
            for (uint32_t i = 0; i < 100; ++i)
                sum += picture.pixels[size_t(y + i / 10) * picture.width + x + i % 10].g;
            means.push_back(sum / 100);
        }
    return means;
}

// Each pixel has noise, and their mean the right value.
TEST_P(TransparentShadows, ByChanceAreRightInTheMean) {
    const Shade shade(GetParam());
    const Shot shot = shade.shot("stochastic");
    const Image picture = render_linear(test_device(), shot);
    const std::vector<double> got = block_means(picture),
                              wanted = block_means(References().of(shade.shot("filtered")).linear);
    const double brightest = *std::max_element(wanted.begin(), wanted.end());
    double sum = 0, squares = 0;
    size_t dim = 0;
    for (size_t i = 0; i < got.size(); ++i) {
        const double off = (got[i] - wanted[i]) / brightest;
        sum += off / static_cast<double>(got.size());
        squares += off * off / static_cast<double>(got.size());
        EXPECT_LT(std::abs(off), 0.06) << "block " << i;
        dim += wanted[i] < 0.8 * brightest;
    }
    EXPECT_GT(dim, 10u);
    EXPECT_LT(std::abs(sum), 0.004);
    EXPECT_LT(std::sqrt(squares), 0.015);
    expect_validation_clean(test_device());
}

/// Lit panes behind each other, all of which the camera sees: what is nearer to the light shades what is farther.
struct LitStack : TestWorld {
    LitStack() {
        add_material({.base_colour = {0.5f, 0.5f, 0.5f, 1}, .metallic = 0, .roughness = 1});
        add(square(20), placed_at(0, 0, -3));
        for (const double z : {-1.5, -0.75, 0.0}) {
            Material material = Shade::blended_material(0.4f);
            material.roughness = 1;
            add_material(material);
            add(square(1.2f), placed_at(0.3 * z, 0, z));
        }
        add_light({.kind = LightKind::point, .intensity = 60, .range = 20}, {0.5, 0.5, 4});
    }
};

double mean_of(const Image& picture) {
    const std::vector<double> means = block_means(picture);
    return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
}

// A map of transmittance takes what lies before the nearest layer from what lies behind it, and no more: layers between
// others are too dark with it, by chance they are right.
TEST(TransparentShadows, LayersShadeEachOther) {
    const LitStack stack;
    Shot shot{.world = &stack.world, .camera = front_camera(5), .width = 160, .height = 90};
    shot.settings = {{"shadows", "on"}, {"transparency", "peeled"}, {"transparent-shadows", "stochastic"}};
    const double wanted = mean_of(References().of(shot).linear);
    EXPECT_NEAR(mean_of(render_linear(test_device(), shot)), wanted, 0.01 * wanted);
    shot.settings["transparent-shadows"] = "filtered";
    const double filtered = mean_of(render_linear(test_device(), shot));
    EXPECT_LT(filtered, wanted);
    EXPECT_GT(filtered, 0.9 * wanted);
    expect_validation_clean(test_device());
}

// What changes is drawn anew in both images, and nothing else is.
TEST(TransparentShadows, AKeptRendererDrawsWhatANewOneDraws) {
    for (const char* shadows : {"filtered", "stochastic", "none"}) {
        Shade shade(LightKind::point);
        const Shot shot = shade.shot(shadows);
        const auto kept = create_renderer("light-prepass", &test_device(), options_of(shot));
        kept->set_world(shade.world);
        kept->render(shot.camera);
        for (const uint32_t moved : {Shade::first_pane, Shade::shelf}) {
            Instance& instance = shade.world.instances[moved];
            instance.transform = glm::translate(instance.transform, {0.4, 0.1, 0.2});
            kept->update_world({.instances = {moved}});
            kept->render(shot.camera);
            EXPECT_TRUE(kept->read("linear").pixels == render_linear(test_device(), shot).pixels) << shadows << moved;
        }
        const ShadowStats stats = kept->stats().shadows.value();
        kept->render(shot.camera);
        EXPECT_EQ(kept->stats().shadows.value().tiles_drawn, 0u) << stats.tiles_drawn;
    }
    expect_validation_clean(test_device());
}

TEST(TransparentShadows, SwiftShaderAgreesWithShadowRays) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "no SwiftShader";
    const Shade shade(LightKind::spot);
    Shot shot = shade.shot("filtered");
    shot.settings["shadow-filter"] = "hard";
    expect_within(against_reference(*device, shot), half_float_bound);
    expect_validation_clean(*device);
}

TEST(TransparentShadows, AreNoMatterWhereNothingBlends) {
    Garden garden;
    garden.add_lights(3, 5, 5);
    Shot shot = garden.shot();
    shot.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}, {"transparent-shadows", "opaque"}};
    const Rendered expected = render_with(garden.world, shot.camera, options_of(shot));
    shot.settings["transparent-shadows"] = "filtered";
    const Rendered got = render_with(garden.world, shot.camera, options_of(shot));
    EXPECT_TRUE(got.linear.pixels == expected.linear.pixels);
    EXPECT_EQ(got.stats.passes.size(), expected.stats.passes.size());
}

} // namespace
} // namespace prelight
