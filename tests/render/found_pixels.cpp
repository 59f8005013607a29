#include "found_pixels.hpp"
#include <cmath>

namespace prelight {

std::vector<Found> find_pixels(const World& world, std::span<const PlacedCamera> cameras, const SettingMap& settings,
                               Device& device) {
    RenderOptions options;
    options.width = found_width;
    options.height = found_height;
    options.count_pairs = true;
    options.views = {"light-count", "linear"};
    options.settings = settings;
    const auto renderer = create_renderer("light-prepass", &device, options);
    renderer->set_world(world);
    std::vector<Found> found;
    for (const PlacedCamera& camera : cameras) {
        renderer->render(camera);
        const Stats stats = renderer->stats();
        found.push_back(
            {renderer->read("linear"), renderer->read("light-count"), stats.pairs_evaluated, stats.pairs_contributing});
    }
    return found;
}

std::vector<std::vector<Found>> expect_same_as_fullscreen(const World& world, std::span<const PlacedCamera> cameras,
                                                          std::span<const SettingMap> settings, Device& device) {
    std::vector<std::vector<Found>> all;
    const std::vector<Found> baseline = find_pixels(world, cameras, {{"light-culling", "fullscreen"}}, device);
    uint64_t lit = 0;
    for (const Found& one : baseline)
        lit += one.contributing;
    EXPECT_GT(lit, 0u) << "nothing is lit, nothing is tested";
    for (const SettingMap& setting : settings) {
        const std::vector<Found>& found = all.emplace_back(find_pixels(world, cameras, setting, device));
        for (size_t i = 0; i < found.size(); ++i) {
            const auto where = [&] { return testing::PrintToString(setting) + " from camera " + std::to_string(i); };
            EXPECT_EQ(found[i].contributing, baseline[i].contributing) << where();
            EXPECT_LE(found[i].evaluated, world.lights.size() * found_width * found_height) << where();
            EXPECT_TRUE(found[i].counts.pixels == baseline[i].counts.pixels) << where();
            if (world.lights.size() == 1)
                EXPECT_TRUE(found[i].linear.pixels == baseline[i].linear.pixels) << where();
            else
                EXPECT_GE(compare_pixels(found[i].linear, baseline[i].linear).psnr, 70) << where();
        }
    }
    expect_validation_clean(device);
    return all;
}

LightFromEverywhere::LightFromEverywhere(const Light& light, glm::dvec3 direction) {
    const glm::dvec3 place = garden.at(0.3, 1.4, 1.5), forward = -garden.camera.axes[2];
    garden.add_light(light, place, direction);
    garden.camera.camera.znear = 0.25; // a large near rectangle, so that volumes are really cut
    for (const double share : {2.5, 1.02, 0.97, 0.5, 0.05}) {
        cameras.push_back(garden.camera);
        cameras.back().position = place - forward * (share * light.range);
    }
}

void PrintTo(const LightCase& c, std::ostream* out) { *out << c.name; }

std::vector<LightCase> light_cases() {
    const Garden g;
    return {{"point", g.point(4, 12)},
            {"narrow_spot", g.spot(15 * degree, 6, 60)},
            {"wide_spot", g.spot(60 * degree, 4, 20)},
            {"spot_of_79_degrees", g.spot(79 * degree, 4, 16)},
            {"spot_of_85_degrees", g.spot(85 * degree, 4, 16)},
            {"spot_seen_from_behind", g.spot(30 * degree, 6, 40), {0, -0.5, -1}},
            {"spot_towards_the_camera", g.spot(40 * degree, 6, 40), {0, 0.3, 1}}};
}

LightsEverywhere::LightsEverywhere() {
    const glm::dvec3 eye = garden.camera.position;
    garden.add_lights(20, 2, 3);
    for (int i = 0; i < 24; ++i) { // around the view, before, beside and behind the eye
        const double angle = 0.9 * i, radius = 1 + 0.2 * i;
        const glm::dvec3 across = garden.camera.axes[0] * (std::cos(angle) * radius) +
                                  garden.camera.axes[1] * (std::sin(angle) * radius) +
                                  garden.camera.axes[2] * (6.0 - 0.7 * i);
        const float range = 1 + 0.4f * static_cast<float>(i % 8);
        if (i % 3 == 0)
            garden.add_light(garden.point(range, 3), eye + across);
        else
            garden.add_light(garden.spot(static_cast<float>(10 + 24 * (i % 4)) * degree, 2 * range, 12), eye + across,
                             {std::sin(2.0 * i), -1, std::cos(2.0 * i)});
    }
    const PlacedCamera& home = garden.camera;
    PlacedCamera finite = home, orthographic = home, tele = home, wide = home;
    finite.camera.zfar = 11; // volumes reach past the far plane
    orthographic.camera.kind = ProjectionKind::orthographic;
    orthographic.camera.ymag = 2;
    orthographic.camera.znear = 7; // cuts through the garden
    orthographic.camera.zfar = 11;
    tele.camera.yfov = 0.25;
    wide.camera.yfov = 2.2;
    wide.camera.znear = 0.5;
    cameras = {home, finite, orthographic, tele, wide};
}

} // namespace prelight
