// Motion blur against the mean of many moments, each rendered by the reference.
#include "against_reference.hpp"
#include "garden.hpp"

namespace prelight {
namespace {

/// The mean of the pictures of 64 moments between the previous state and now.
template <class WorldAt>
Image mean_of_moments(const WorldAt& at, const Shot& shot) {
    Image sum(shot.width, shot.height);
    constexpr int moments = 64;
    for (int i = 0; i < moments; ++i) {
        Shot one = shot;
        const World world = at(double(i) / moments, one.camera); // 0: now, towards 1: the previous state
        const ReferencePicture picture = render_reference(world, one.camera, shot.width, shot.height, 0, form_of(shot));
        for (size_t p = 0; p < sum.pixels.size(); ++p)
            sum.pixels[p] += picture.linear.pixels[p] / float(moments);
    }
    return sum;
}

struct Figures {
    double sharp, blurred; ///< dB
};

/// Without and with motion blur.
template <class WorldAt>
Figures figures_of(const WorldAt& at, Shot shot) {
    shot.renderer = "deferred";
    const Image truth = mean_of_moments(at, shot);
    const World now = at(0, shot.camera);
    shot.world = &now;
    const double sharp = compare_pixels(render_linear(test_device(), shot), truth).psnr;
    shot.settings["motion-blur"] = "on";
    const double blurred = compare_pixels(render_linear(test_device(), shot), truth).psnr;
    std::printf("    %.1f dB without, %.1f dB with motion blur\n", sharp, blurred);
    expect_validation_clean(test_device());
    return {sharp, blurred};
}

TEST(MotionBlur, OfATurningCameraIsTheMeanOfItsMoments) {
    Garden garden;
    garden.add_lights(4, 3, 4);
    const PlacedCamera end = garden.camera;
    const auto at = [&](double back, PlacedCamera& camera) {
        camera = end;
        const auto turned = [&](double share) {
            return glm::dmat3(glm::rotate(glm::dmat4(1), 0.05 * share, glm::dvec3(0, 1, 0))) * end.axes;
        };
        camera.axes = turned(back);
        camera.previous = CameraPose{end.position, turned(1)};
        return garden.world;
    };
    const Figures figures = figures_of(at, {.camera = end, .width = 192, .height = 108});
    EXPECT_GT(figures.blurred, figures.sharp + 6);
    EXPECT_GT(figures.blurred, 28);
}

// Unlit, so that nothing but places changes.
TEST(MotionBlur, OfAnObjectBeforeAStillBackground) {
    TestWorld scene;
    Material stripes{.name = "stripes", .double_sided = true, .unlit = true};
    stripes.base_colour_texture = {
        .image = scene.add_image(4, 1, {200, 60, 30, 255, 40, 200, 90, 255, 30, 60, 200, 255, 220, 210, 60, 255})};
    scene.add_material(stripes);
    scene.add(square(6), glm::translate(glm::dmat4(1), {0, 0, -3}));
    scene.add_material({.name = "white", .double_sided = true, .unlit = true});
    scene.add(square(1));
    const PlacedCamera camera = look_at({.yfov = 0.9}, {0, 0, 5}, {0, 0, 0});
    const auto at = [&](double back, PlacedCamera& seen) {
        seen = camera;
        World world = scene.world;
        const auto placed = [&](double share) { return glm::translate(glm::dmat4(1), {-0.6 * share, 0.2 * share, 0}); };
        world.instances[1].transform = placed(back);
        world.instances[1].previous_transform = placed(1);
        return world;
    };
    const Figures figures = figures_of(at, {.camera = camera, .width = 192, .height = 108});
    EXPECT_GT(figures.blurred, figures.sharp + 6);
}

// Its highlights stay behind, which vectors of surfaces cannot know; that is little.
TEST(MotionBlur, OfAnObjectUnderLights) {
    Garden garden;
    garden.add_lights(4, 3, 4);
    const size_t moving = garden.world.instances.size() - 1;
    const glm::dmat4 end = garden.world.instances[moving].transform;
    const auto at = [&](double back, PlacedCamera& camera) {
        camera = garden.camera;
        World world = garden.world;
        const auto placed = [&](double share) { return glm::translate(glm::dmat4(1), {-0.4 * share, 0, 0}) * end; };
        world.instances[moving].transform = placed(back);
        world.instances[moving].previous_transform = placed(1);
        return world;
    };
    const Figures figures = figures_of(at, {.camera = garden.camera, .width = 192, .height = 108});
    EXPECT_GT(figures.blurred, figures.sharp + 10);
}

TEST(MotionBlur, LeavesWhatStandsStillAlone) {
    Garden garden;
    Shot shot{.world = &garden.world, .camera = garden.camera, .width = 96, .height = 54, .renderer = "deferred"};
    const Image sharp = render_linear(test_device(), shot);
    shot.settings["motion-blur"] = "on";
    EXPECT_EQ(render_linear(test_device(), shot).pixels, sharp.pixels);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
