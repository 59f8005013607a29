// Several samples a pixel from frame to frame, and in pictures of unusual sizes and worlds: the samples of edge pixels
// lie in a buffer whose room is a guess until a frame has counted them.
#include "every_way.hpp"
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <gpu/context.hpp>
#include <numeric>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using Words = std::map<std::string, std::string>;

/// Layers of blades about a pixel wide before a wall, all of which face the camera, so that samples see another surface
/// where they see another depth: most pixels show several.
struct Grass : TestWorld {
    Grass() {
        add_material({.name = "wall", .base_colour = {0.6f, 0.6f, 0.7f, 1}, .metallic = 0, .roughness = 0.8f});
        add(square(8), glm::translate(glm::dmat4(1), {0, 0, -3}));
        add_material({.name = "blade", .base_colour = {0.3f, 0.6f, 0.2f, 1}, .metallic = 0, .roughness = 0.5f});
        add(square(1), glm::translate(glm::dmat4(1), {0, 0, -20})); // the mesh
        for (int layer = 0; layer < 4; ++layer)
            for (int row = 0; row < 4; ++row)
                for (int i = 0; i < 40; ++i) {
                    glm::dmat4 m = glm::rotate(glm::dmat4(1), 0.5 * layer - 0.8, glm::dvec3(0, 0, 1));
                    m = glm::translate(m, {0.2 * i - 4 + 0.05 * row, 1.6 * row - 2.4, -0.6 * layer});
                    place(1, glm::scale(m, glm::dvec3(0.03, 0.7, 1)));
                }
        for (int i = 0; i < 6; ++i)
            add_light({.kind = LightKind::point,
                       .colour = {1, 0.2f * static_cast<float>(i), 0.5f},
                       .intensity = 8,
                       .range = 9},
                      {1.2 * i - 3, 1.0 - 0.6 * (i % 3), 2});
        world.ambient = glm::vec3(0.05f);
    }
    Shot shot(const std::string& renderer = "light-prepass") const {
        return {
            .world = &world, .camera = front_camera(5), .width = 128, .height = 72, .renderer = renderer, .samples = 4};
    }
    /// Nothing but the wall.
    static PlacedCamera aside() { return look_at(front_camera(5).camera, {0, 4.6, 5}, {0, 5.6, -3}); }
};

// Where nearly all blocks are edges the first guess is too small.
TEST(EdgeSamples, AreLitHoweverManyThereAre) {
    const Grass grass;
    for (const char* renderer : {"light-prepass", "deferred"})
        for (const auto& settings : {Words{}, Words{{"light-culling", "volumes"}}}) {
            Shot shot = grass.shot(renderer);
            shot.settings = settings;
            SCOPED_TRACE(name_of(shot));
            const ReferencePicture reference =
                render_reference(grass.world, shot.camera, shot.width, shot.height, 0, form_of(shot));
            std::vector<uint8_t> sure = reference.left_out();
            for (size_t i = 0; i < sure.size(); ++i)
                sure[i] = reference.edge[i] && !sure[i];
            const auto edges = static_cast<size_t>(std::accumulate(sure.begin(), sure.end(), 0));
            EXPECT_GT(edges, sure.size() * 4 / 10);
            const Image ours = render_linear(test_device(), shot);
            shot.settings["msaa-light"] = "samples";
            const Image everywhere = render_linear(test_device(), shot);
            // Light of a surface's samples is that of each of them, within what light changes in a pixel.
            std::vector<uint8_t> others(sure.size());
            std::ranges::transform(sure, others.begin(), [](uint8_t one) { return one == 0 ? 1 : 0; });
            const Comparison each = compare_pixels(ours, everywhere, others);
            EXPECT_GE(each.psnr, 60);
            EXPECT_LE(each.block, 1);
            expect_within_on_edges(ours, reference, {.psnr = 50, .off_share = 0.01}, {.pixels = edges});
            expect_within_on_edges(everywhere, reference, half_float_bound, {.pixels = edges});
        }
    expect_validation_clean(test_device());
}

TEST(EdgeSamples, HaveRoomAfterCamerasMoved) {
    const Grass grass;
    for (const char* renderer : {"light-prepass", "deferred"}) {
        Shot shot = grass.shot(renderer);
        const auto kept = create_renderer(renderer, &test_device(), options_of(shot));
        kept->set_world(grass.world);
        for (int step = 0; step < 5; ++step) {
            kept->render(Grass::aside(), 1 + static_cast<uint32_t>(step % 3)); // hardly an edge, and then many
            shot.camera.position += glm::dvec3(0.1, 0, -0.4);
            kept->render(shot.camera, 1 + static_cast<uint32_t>(step % 2));
            EXPECT_TRUE(kept->read("linear").pixels == render_linear(test_device(), shot).pixels)
                << renderer << ", step " << step;
        }
    }
    expect_validation_clean(test_device());
}

TEST(EdgeSamples, TakeNothingMoreOnceThereIsRoom) {
    const Grass grass;
    for (const char* renderer : {"light-prepass", "deferred"}) {
        const Shot shot = grass.shot(renderer);
        RenderOptions options = options_of(shot);
        options.pass_cpu = true; // draws each pass once more, and nothing is counted twice
        const auto kept = create_renderer(renderer, &test_device(), options);
        kept->set_world(grass.world);
        const auto expect_steady = [&](const char* when) {
            for (int frame = 0; frame < 3; ++frame)
                kept->render(shot.camera, 2);
            for (int frame = 0; frame < 3; ++frame) {
                const VulkanCalls calls;
                kept->render(shot.camera, 4);
                EXPECT_EQ(kept->stats().created, CreatedObjects{}) << renderer << " " << when;
                EXPECT_EQ(calls.pipelines + calls.images + calls.buffers, 0u) << renderer << " " << when;
            }
        };
        expect_steady("as made");
        const uint64_t bytes = kept->stats().attachment_bytes;
        kept->resize(32, 18); // for whose few blocks there were never as many
        expect_steady("smaller");
        kept->resize(shot.width, shot.height);
        expect_steady("as before");
        EXPECT_LE(kept->stats().attachment_bytes, bytes * 11 / 10);
    }
    expect_validation_clean(test_device());
}

// Room goes by what a frame counts: not by what lies in memory before its first one, nor by frames drawn before.
TEST(EdgeSamples, TakeNoRoomThatIsNotNeeded) {
    Garden garden;
    garden.add_lights(5, 4, 4);
    Shot shot = garden.shot();
    shot.samples = 4;
    RenderOptions options = options_of(shot);
    options.pass_cpu = true;
    const auto kept = create_renderer(shot.renderer, &test_device(), options);
    kept->set_world(garden.world);
    kept->render(shot.camera, 8);
    const uint64_t bytes = kept->stats().attachment_bytes;
    for (int i = 0; i < 3; ++i) {
        kept->set_world(garden.world);
        kept->render(shot.camera, 8);
        kept->read("linear");
    }
    EXPECT_LE(kept->stats().attachment_bytes, bytes);
    expect_validation_clean(test_device());
}

TEST(SamplesOfPictures, OfAnySize) {
    TestWorld cards;
    cards.add_material({.name = "paper", .base_colour = {0.7f, 0.6f, 0.5f, 1}, .metallic = 0, .roughness = 0.9f});
    cards.add(square(20), glm::translate(glm::dmat4(1), {0, 0, -2}));
    cards.add(square(1), glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(0.1, 0.2, 1)));
    cards.add_light({.kind = LightKind::point, .intensity = 900, .range = 60}, {6, 8, 25});
    for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 5u}, {33u, 17u}, {3u, 200u}, {200u, 2u}})
        for (const std::string& renderer : device_renderers) {
            Shot shot{.world = &cards.world,
                      .camera = front_camera(5),
                      .width = width,
                      .height = height,
                      .renderer = renderer,
                      .samples = 4};
            SCOPED_TRACE(fmt::format("{} {}x{}", renderer, width, height));
            const bool lights_samples = renderer == "light-prepass" || renderer == "deferred";
            if (lights_samples) { // but for edges pixels are lit at their centres: the only one shows everything
                expect_within(against_reference(test_device(), shot), {.psnr = 45, .left_out = 0.2});
                shot.settings["msaa-light"] = "samples";
            }
            expect_within(against_reference(test_device(), shot), {.left_out = 0.2});
        }
    expect_validation_clean(test_device());
}

/// Lighting all samples gives the picture that lighting those of edges gives.
void expect_all_as_edges(uint32_t width, uint32_t height) {
    Garden garden;
    garden.add_lights(3, 5, 4);
    Shot shot = garden.shot();
    shot.width = width, shot.height = height;
    shot.samples = 4;
    shot.settings["msaa-light"] = "samples";
    const Image all = render_linear(test_device(), shot);
    shot.settings["msaa-light"] = "edges";
    EXPECT_GE(compare_pixels(all, render_linear(test_device(), shot)).psnr, 50);
    expect_validation_clean(test_device());
}

// The buffer of all samples is four times as high as the picture, unless that is more than an image may be.
TEST(SamplesOfPictures, OfATallStrip) {
    expect_all_as_edges(8, dynamic_cast<gpu::Context&>(test_device()).limits().maxImageDimension2D / 2);
}

// More slots for samples than the bits beside an edge's flags can count.
TEST(SamplesOfPictures, OfALargeOne) { expect_all_as_edges(1024, 520); }

TEST(SamplesOfWorlds, WithoutLightsOrWithoutAnything) {
    Garden garden;
    TestWorld empty;
    empty.add_material();
    empty.add_light({.kind = LightKind::point, .intensity = 5, .range = 9}, {1, 1, 1});
    for (const Shot& way : every_way({.width = 64, .height = 36, .samples = 4})) {
        SCOPED_TRACE(name_of(way));
        Shot shot = way;
        shot.world = &garden.world;
        shot.camera = garden.camera;
        EXPECT_GE(against_reference(test_device(), shot).psnr, 55);
        shot.world = &empty.world;
        const Image black = render_linear(test_device(), shot);
        EXPECT_EQ(black.pixels, std::vector<glm::vec3>(black.pixels.size(), glm::vec3(0)));
    }
    expect_validation_clean(test_device());
}

// More lights than one round of a driver that ends loops can take.
TEST(SamplesOfWorlds, WithMoreLightsThanARoundTakes) {
    Garden garden;
    garden.scene.ambient = glm::vec3(0.05f);
    garden.add_lights(100, 3, 0.5f);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.05f}, garden.at(0, 0, 0), {0.1, -1, 0.1});
    const auto impatient = Device::create({.select = "cpu", .validate = true});
    dynamic_cast<gpu::Context&>(*impatient).end_loops_after(230);
    Shot form = garden.shot();
    form.width = 64, form.height = 36;
    form.samples = 4;
    for (Shot shot : every_way(form)) {
        const std::string culling = shot.settings.contains("light-culling") ? shot.settings.at("light-culling") : "";
        if (culling != "tiles" && culling != "volumes")
            continue; // the others are like one of these
        SCOPED_TRACE(name_of(shot));
        for (const char* light : {"edges", "samples"}) {
            shot.settings["msaa-light"] = light;
            const Image right = render_linear(test_device(), shot), image = render_linear(*impatient, shot);
            const Comparison c = compare_pixels(image, right);
            EXPECT_GE(c.psnr, 60) << light;
            EXPECT_LE(c.block, 0.5) << light;
        }
        expect_validation_clean(*impatient);
    }
}

TEST(SamplesOf, AsManyAsTheDeviceHas) {
    auto& context = dynamic_cast<gpu::Context&>(test_device());
    if (context.limits().framebufferColorSampleCounts & VK_SAMPLE_COUNT_2_BIT)
        GTEST_SKIP() << "the device has two";
    for (const std::string& renderer : device_renderers)
        try {
            create_renderer(renderer, &test_device(), {.width = 8, .height = 8, .msaa = 2});
            FAIL() << renderer;
        } catch (const UsageError&) {
            FAIL() << renderer << ": it is not the user's fault";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()), context.name() + ": --msaa 2: the device does not have so many");
        }
}

} // namespace
} // namespace prelight
