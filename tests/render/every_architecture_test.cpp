// Every architecture, in every way that it finds lights, gives the same picture of the same scene.
#include "every_way.hpp"
#include "garden.hpp"
#include "random_scene.hpp"
#include <prelight/error.hpp>
#include <prelight/vary.hpp>

namespace prelight {
namespace {

class RandomScenes : public testing::TestWithParam<uint64_t> {};

TEST_P(RandomScenes, EveryArchitectureAgreesWithTheReferenceAndTheOthers) {
    const RandomScene scene(GetParam());
    const Shot form = scene.shot();
    const ReferencePicture reference =
        render_reference(scene.world, scene.camera, form.width, form.height, 0,
                         {.fresnel = ReferenceForm::Fresnel::nv, .specular_antialiasing = true});
    Image first;
    for (const Shot& shot : every_way(form)) {
        SCOPED_TRACE(name_of(shot));
        const Image image = render_linear(test_device(), shot);
        expect_within(compare_pixels(image, reference.linear, reference.left_out()), half_float_bound);
        if (first.pixels.empty())
            first = image;
        // Both are within the bound of the same reference; between them twice that may lie.
        const Comparison c = compare_pixels(image, first, std::vector<uint8_t>(image.pixels.size(), 0));
        EXPECT_GE(c.psnr, 52);
        EXPECT_LE(c.block, 2);
    }
    expect_validation_clean(test_device());
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range<uint64_t>(1, 9));

// Lights that move, change, come and go while the renderer stays: the same bytes as a renderer
// made for those lights.
TEST(EveryArchitecture, LightsChangeWhileItRuns) {
    Garden garden;
    garden.add_lights(5, 4, 6);
    std::vector<std::vector<PlacedLight>> steps(1, garden.world.lights);
    const auto step = [&](auto&& change) {
        steps.push_back(steps.back());
        change(steps.back());
    };
    step([&](auto& l) { rotate_lights(l, garden.at(0, 0, 0), 0.7); });
    step([&](auto& l) { randomize_lights(l, 3); });
    step([&](auto& l) {
        for (int i = 0; i < 60; ++i)
            l.push_back({garden.point(3, 2), garden.at(0.15 * i - 4.5, 1, 2)});
    });
    step([&](auto& l) { l.resize(3); });
    step([&](auto& l) { l[1].light.falloff = Falloff::quadratic; });
    step([&](auto& l) { l.push_back({{.kind = LightKind::directional}, glm::dvec3(0), {0, -1, 0}}); });
    step([&](auto& l) { l.clear(); });
    Shot small = garden.shot();
    small.width = 160, small.height = 90;
    for (const Shot& shot : every_way(small)) {
        SCOPED_TRACE(name_of(shot));
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        EXPECT_THROW(renderer->set_lights(steps[1]), Error);
        renderer->set_world(garden.world);
        Image before;
        for (const auto& lights : steps) {
            renderer->set_lights(lights);
            renderer->render(shot.camera);
            const Image image = renderer->read("linear");
            EXPECT_EQ(renderer->stats().lights, lights.size());
            World world = garden.world;
            world.lights = lights;
            Shot fresh = shot;
            fresh.world = &world;
            EXPECT_TRUE(image.pixels == render_linear(test_device(), fresh).pixels) << lights.size() << " lights";
            EXPECT_FALSE(image.pixels == before.pixels) << "the change does not show";
            before = image;
        }
    }
    expect_validation_clean(test_device());
}

TEST(EveryArchitecture, TheReferenceTakesOtherLightsToo) {
    Garden garden;
    garden.add_lights(5, 4, 6);
    RenderOptions options{.width = 64, .height = 36};
    const auto renderer = create_renderer("reference", nullptr, options);
    EXPECT_THROW(renderer->set_lights({}), Error);
    renderer->set_world(garden.world);
    std::vector<PlacedLight> lights = garden.world.lights;
    rotate_lights(lights, garden.at(0, 0, 0), 0.7);
    renderer->set_lights(lights);
    renderer->render(garden.camera);
    const Image image = renderer->read("linear");
    garden.world.lights = lights;
    EXPECT_TRUE(image.pixels ==
                render_reference(garden.world, garden.camera, 64, 36, 0,
                                 {.fresnel = ReferenceForm::Fresnel::full, .specular_antialiasing = true})
                    .linear.pixels);
}

} // namespace
} // namespace prelight
