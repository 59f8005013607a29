// transparency=half-samples against the reference's own form of it, and what it is exact in.
#include "panes.hpp"
#include <algorithm>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Shot halved(Shot shot, const std::string& renderer = "light-prepass") {
    shot.renderer = renderer;
    return with(with_samples(shot, 192), {{"transparency", "half-samples"}});
}

struct Half {
    const char* name;
    const char* renderer;
    std::map<std::string, std::string> settings;
};
void PrintTo(const Half& one, std::ostream* out) { *out << one.name; }

class HalfSamples : public testing::TestWithParam<Half> {};

INSTANTIATE_TEST_SUITE_P(
    All, HalfSamples,
    testing::Values(Half{"Edges", "light-prepass", {}},
                    Half{"MaterialSample", "light-prepass", {{"msaa-material", "sample"}}},
                    Half{"Everywhere", "light-prepass", {{"msaa-light", "samples"}}},
                    Half{"Pixel", "light-prepass", {{"msaa-light", "pixel"}}},
                    Half{"Volumes", "light-prepass", {{"light-culling", "volumes"}}},
                    Half{"RoughnessApart", "light-prepass", {{"normals", "oct32"}, {"geometry", "two-passes"}}},
                    Half{"Packed", "light-prepass", {{"light-buffer", "packed-rgba16f"}}},
                    Half{"Deferred", "deferred", {}}, Half{"DeferredSamples", "deferred", {{"msaa-light", "samples"}}}),
    [](const auto& one) { return std::string(one.param.name); });

TEST_P(HalfSamples, AgreeWithTheReference) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    Shot shot = halved(lit.shot(), GetParam().renderer);
    shot.settings.insert(GetParam().settings.begin(), GetParam().settings.end());
    const ReferencePicture reference =
        render_reference(lit.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
    const Image picture = render_linear(test_device(), shot);
    save_when_wanted(picture, reference);
    expect_within_on_edges(picture, reference, half_float_bound, {.psnr = 50});
    expect_validation_clean(test_device());
}

const char* const halving_renderers[] = {"light-prepass", "deferred"};

/// `pane` before `wall`, by its alpha.
void expect_mixed(const Image& picture, glm::dvec3 wall, glm::dvec4 pane) {
    expect_layers(middle_of(picture), laid_over(wall, {pane}), 1);
}

TEST(HalfSamplesOf, ShadowsAgreeWithTheReference) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    for (const char* name : halving_renderers) {
        SCOPED_TRACE(name);
        Shot shot = with(halved(lit.shot(), name), {{"shadows", "on"}});
        shot.width = 256; // shadows of 15 lights: pixels on an edge of one of them are all over the floor
        shot.height = 144;
        expect_within(against_reference(test_device(), shot), {.left_out = 0.25});
    }
    expect_validation_clean(test_device());
}

// Smoke, whose clear corners hide nothing, closed bodies and panes that cross: the nearest of all that.
TEST(HalfSamplesOf, GlassAgreesWithTheReference) {
    const Scene scene = make_scene("glass", 16, 1);
    const World world = resolve(scene);
    for (const char* name : halving_renderers) {
        SCOPED_TRACE(name);
        Shot shot = halved({.world = &world, .camera = find_camera(world, "front")}, name);
        const ReferencePicture reference =
            render_reference(world, shot.camera, shot.width, shot.height, 0, form_of(shot));
        const Image picture = render_linear(test_device(), shot);
        save_when_wanted(picture, reference);
        expect_within_on_edges(picture, reference, {.left_out = 0.2});
    }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesOf, OneLayerAreExact) {
    const Panes panes(1);
    for (const char* name : halving_renderers)
        expect_mixed(render_linear(test_device(), halved(panes.shot(), name)), {0.1, 0.3, 0.2}, panes.layers[0]);
    expect_validation_clean(test_device());
}

TEST(HalfSamplesOf, SeveralLayersShowTheNearest) {
    const Panes panes(4);
    const CoincidentPanes coincident; // of which the world's first is the nearest
    for (const char* name : halving_renderers) {
        SCOPED_TRACE(name);
        expect_mixed(render_linear(test_device(), halved(panes.shot(), name)), {0.1, 0.3, 0.2}, panes.layers[3]);
        expect_mixed(render_linear(test_device(), halved(coincident.shot(), name)), {0.1, 0.3, 0.2},
                     {0.9, 0.1, 0.1, 0.5});
    }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesOf, ALayerThatCoversLittleShowWhatIsBehindIt) {
    for (const float alpha : {0.0f, 0.06f, 0.065f}) {
        TestWorld test;
        for (const glm::vec4& colour : {glm::vec4(0.9f, 0.5f, 0.1f, 0.5f), glm::vec4(0.1f, 0.9f, 0.9f, alpha)}) {
            test.add_material(unlit_material("pane", colour));
            test.add(square(2), placed_at(0, 0, test.world.instances.empty() ? 0 : 1));
        }
        const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 64, .height = 36};
        for (const char* name : halving_renderers)
            expect_mixed(render_linear(test_device(), halved(shot, name)), glm::dvec3(0),
                         alpha < 0.0625f ? glm::dvec4(0.9, 0.5, 0.1, 0.5) : glm::dvec4(0.1, 0.9, 0.9, alpha));
    }
    expect_validation_clean(test_device());
}

// Light blends, and not what a display shows of it.
TEST(HalfSamplesOf, ABrightLayerAreMixedBeforeToneMapping) {
    TestWorld test;
    Material lamp{
        .name = "lamp", .metallic = 0, .roughness = 1, .emissive = glm::vec3(2), .alpha_mode = AlphaMode::blend};
    lamp.base_colour = {0, 0, 0, 0.25f};
    test.add_material(lamp);
    test.add(square(0.5f));
    const Shot shot{.world = &test.world, .camera = front_camera(5), .width = 64, .height = 36};
    for (const char* name : halving_renderers) {
        const Shot half = halved(shot, name);
        const Image right = render_reference(test.world, half.camera, half.width, half.height, 0, form_of(half))
                                .display(RenderOptions{}.tonemap);
        const glm::vec3 shown = middle_of(view_of(half, "final")), expected = middle_of(right);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(shown[c], expected[c], 1.5 / 255) << name;
        const float apart = srgb_encode(0.25f * display_light(glm::vec3(2), RenderOptions{}.tonemap).r);
        EXPECT_GT(std::abs(shown.r - apart), 20.0 / 255) << "what mixing displayed light would give";
    }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesOf, ViewsShowWhatIsOpaque) {
    const Panes panes(1, true);
    for (const char* view : {"albedo", "depth", "normal"})
        for (const char* name : halving_renderers) {
            Shot shot = halved(panes.shot(), name);
            const glm::vec3 half = middle_of(view_of(shot, view));
            shot.settings = {{"transparency", "lists"}};
            EXPECT_EQ(half, middle_of(view_of(shot, view))) << name << " " << view;
        }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesStats, SayWhatIsLeftOutAndCostNothingWithoutIt) {
    Panes panes(4);
    double behind_first = 0; // layers of a pixel, the mean
    for (const uint32_t count :
         render_reference(panes.world, panes.shot().camera, 64, 36, 0, form_of(panes.shot())).layer_count)
        behind_first += std::max(count, 1u) - 1.0;
    behind_first /= 64 * 36;
    for (const char* name : halving_renderers) {
        SCOPED_TRACE(name);
        const Shot shot = halved(panes.shot(), name);
        const Rendered drawn = render_with(panes.world, shot.camera, options_of(shot), name);
        ASSERT_TRUE(drawn.stats.layers);
        EXPECT_EQ(drawn.stats.layers->most, 4u);
        EXPECT_EQ(drawn.stats.layers->exact, 1u);
        const double pixels = 192.0 * 108, left_out = static_cast<double>(drawn.stats.layers->approximate) / pixels;
        EXPECT_NEAR(left_out, behind_first, 0.02 * behind_first);
        EXPECT_THAT(drawn.stats.notes, Contains(HasSubstr("behind the nearest layer of their pixels are left out")));
        EXPECT_EQ(drawn.stats.settings.at("transparency"), "half-samples");
        for (Material& material : panes.scene.materials)
            material.alpha_mode = AlphaMode::opaque;
        const Rendered opaque = render_with(panes.world, shot.camera, options_of(shot), name);
        for (const PassStats& pass : opaque.stats.passes)
            EXPECT_THAT(pass.name, Not(HasSubstr("blended")));
        EXPECT_THAT(opaque.stats.notes, testing::IsEmpty());
        Shot other = shot;
        other.settings = {{"transparency", "opaque"}};
        EXPECT_EQ(opaque.linear.pixels, render_linear(test_device(), other).pixels);
        for (size_t i = 1; i < panes.scene.materials.size(); ++i)
            panes.scene.materials[i].alpha_mode = AlphaMode::blend;
    }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesStats, SayWhatTheyGiveWayTo) {
    TestWorld test;
    test.add_material(unlit_material("pane", {0.9f, 0.5f, 0.1f, 0.5f}));
    test.add(square(1));
    Material glass{.name = "glass", .shader = find_material_shader("layered")};
    glass.parameters["transmission"] = glm::vec4(1);
    test.add_material(glass);
    test.add(square(1), placed_at(1, 0, -1));
    const Shot shot = halved({.world = &test.world, .camera = front_camera(5)});
    const Rendered drawn = render_with(test.world, shot.camera, options_of(shot));
    EXPECT_EQ(drawn.stats.settings.at("transparency"), "lists");
    EXPECT_THAT(drawn.stats.notes, Contains(HasSubstr("transparency=half-samples: ")));
    Shot lists = shot;
    lists.settings = {{"transparency", "lists"}};
    EXPECT_EQ(drawn.linear.pixels, render_linear(test_device(), lists).pixels);
    expect_validation_clean(test_device());
}

// Measured: docs/transparency.md has these figures.
TEST(HalfSamplesError, IsThatOfTheLayersLeftOut) {
    for (const uint32_t lights : {4u, 64u})
        for (const size_t count : {1, 2, 4, 15}) {
            Panes panes(count, true);
            for (uint32_t i = 0; i < lights; ++i) {
                const double turn = 2.4 * i; // the golden angle, so that they spread
                panes.add_light({.kind = LightKind::point,
                                 .colour = {1, 0.6f + 0.4f * std::sin(turn), 0.6f + 0.4f * std::cos(turn)},
                                 .intensity = 40.0f / static_cast<float>(lights),
                                 .range = 8},
                                {3 * std::sin(turn) * std::sqrt((i + 1.0) / lights), std::cos(turn), 2.5});
            }
            Shot shot = halved(panes.shot());
            shot.width = 96;
            shot.height = 54;
            Shot all = shot;
            all.settings["transparency"] = "lists";
            const Image right = render_reference(panes.world, shot.camera, 96, 54, 0, form_of(all)).linear;
            const Comparison apart = compare_pixels(render_linear(test_device(), shot), right);
            std::printf("%u lights, %zu layers: %.1f dB, %.1f %% off\n", lights, count, apart.psnr,
                        100 * apart.off_share);
            EXPECT_GT(apart.psnr, count == 1 ? 60 : 12);
            if (count > 1) {
                EXPECT_LT(apart.psnr, 30) << "the note says so";
            }
        }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesRefusals, NameWhatIsMissing) {
    const auto line_of = [](const char* renderer, uint32_t msaa) -> std::string {
        try {
            create_renderer(renderer, &test_device(),
                            {.width = 16, .height = 16, .msaa = msaa, .settings = {{"transparency", "half-samples"}}});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "accepted";
    };
    for (const char* name : halving_renderers) {
        EXPECT_EQ(line_of(name, 4), "accepted");
        EXPECT_EQ(line_of(name, 1), "--set transparency=half-samples: needs --msaa 4, and it is 1");
    }
    for (const char* name : {"multipass", "z-prepass"})
        EXPECT_THAT(line_of(name, 4), HasSubstr("--set transparency=half-samples: allowed is lists, sorted"));
}

TEST(HalfSamplesFrames, ChangeAsANewRendererAndMakeNothing) {
    LitPane lit;
    lit.pane().alpha_mode = AlphaMode::blend;
    for (const char* name : halving_renderers) {
        SCOPED_TRACE(name);
        Shot shot = halved(lit.shot(), name);
        shot.width = 96;
        shot.height = 54;
        const auto kept = create_renderer(name, &test_device(), options_of(shot));
        kept->set_world(lit.world);
        for (int frame = 0; frame < 6; ++frame) {
            shot.camera.position += glm::dvec3(0.02, 0.01, -0.02);
            kept->render(shot.camera);
            if (frame >= 4) { // lists and edges find out how much room they need
                EXPECT_EQ(kept->stats().created, CreatedObjects{}) << "frame " << frame;
            }
        }
        const auto instance = static_cast<uint32_t>(lit.world.instances.size() - 1);
        for (const bool visible : {false, true}) {
            lit.world.instances.back().visible = visible;
            kept->update_world({.instances = {instance}});
            kept->render(shot.camera, 2);
            EXPECT_EQ(kept->read("linear").pixels, render_linear(test_device(), shot).pixels) << visible;
        }
    }
    expect_validation_clean(test_device());
}

TEST(HalfSamplesOnSwiftShader, ShowTheNearestLayer) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const Panes panes(4);
    for (const char* name : halving_renderers) {
        Shot shot = halved(panes.shot(), name);
        shot.width = 64;
        shot.height = 36;
        expect_mixed(render_linear(*device, shot), {0.1, 0.3, 0.2}, panes.layers[3]);
    }
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
