// A scene of somebody else's under a sun and 64 spots, all with shadows: example_shadowed_hall FILE.glb PICTURE.png
// [RENDERER]. The lights stand where a hall of 25 × 12 m around the origin, such as Sponza's, has room for them.
#include <cmath>
#include <fmt/format.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

namespace {

using namespace prelight;

void add_lights(World& world) {
    world.lights = {{{.kind = LightKind::directional, .colour = {1, 0.95f, 0.85f}, .intensity = 3},
                     glm::dvec3(0),
                     glm::normalize(glm::dvec3(0.2, -1, 0.15))}};
    for (int i = 0; i < 64; ++i) {
        const float hue = 0.7f * static_cast<float>(i);
        const Light spot{.kind = LightKind::spot,
                         .colour = {0.6f + 0.4f * std::cos(hue), 0.7f, 0.6f - 0.4f * std::cos(hue)},
                         .intensity = 12,
                         .range = 8,
                         .inner_cone = 0.3f,
                         .outer_cone = 0.55f};
        world.lights.push_back({spot, glm::dvec3(-10.5 + 1.4 * (i % 16), 4 + 0.3 * (i % 3), -4.5 + 3.0 * (i / 16)),
                                glm::normalize(glm::dvec3(0.3 * std::cos(2.4 * i), -1, 0.3 * std::sin(2.4 * i)))});
    }
}

void run(const char* file, const char* picture, const std::string& name) {
    const Scene scene = load_gltf(file);
    World world = resolve(scene);
    add_lights(world);
    Camera lens;
    lens.yfov = 0.9;
    RenderOptions options{.width = 960, .height = 540};
    options.exposure = 0.5;
    options.settings = {{"shadows", "on"}};
    const bool on_device = name != "reference";
    const std::unique_ptr<Device> device = on_device ? Device::create({}) : nullptr;
    const std::unique_ptr<Renderer> renderer = create_renderer(name, device.get(), options);
    renderer->set_world(world);
    renderer->render(look_at(lens, {-9, 2.2, 0.6}, {0, 1.8, -0.3}));
    save_png(renderer->read("final"), picture);
    const Stats stats = renderer->stats();
    fmt::print("{}: {} lights, {:.0f} ms on {}\n", picture, stats.lights, stats.wall_ms.median, stats.device);
}

} // namespace

int main(int count, char** words) {
    try {
        if (count < 3 || count > 4)
            throw UsageError("example_shadowed_hall FILE.glb PICTURE.png [RENDERER]");
        run(words[1], words[2], count > 3 ? words[3] : "light-prepass");
        return 0;
    } catch (const UsageError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
