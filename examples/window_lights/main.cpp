// Triangles of its own under 1,000 moving lights in a window: example_window_lights [FRAMES]
#include <cmath>
#include <cstdlib>
#include <prelight/glfw.hpp>
#include <prelight/scene_building.hpp>

int main(int argc, char** argv) {
    using namespace prelight;
    glfw::Window window("1,000 lights", 640, 360);
    Scene scene{.ambient = glm::vec3(0.01f)};
    const uint32_t grey = add_material(scene, {.metallic = 0, .roughness = 0.4f});
    add_object(scene, "floor", {.positions = {{-25, 0, 9}, {25, 0, 9}, {0, 0, -41}}}, grey);
    add_object(scene, "tent", {.positions = {{-2, 0, 1}, {2, 0, 1}, {0, 3, 0}, {2, 0, -1}, {-2, 0, -1}, {0, 3, 0}}},
               grey);
    World world = resolve(scene);
    world.lights.resize(1000, {.light = {.intensity = 0.1f, .range = 1.2f}});
    const auto renderer = create_renderer("light-prepass", &window.device(), {.width = 640, .height = 360});
    renderer->set_world(world);
    for (int frame = 0; window.is_open() && (argc < 2 || frame < std::atoi(argv[1])); ++frame) {
        for (int i = 0; i < 1000; ++i) {
            const double turn = 0.01 * frame + 2.4 * i, out = 0.28 * std::sqrt(i);
            world.lights[i].position = {out * std::cos(turn), 0.4 + 0.3 * std::sin(5 * turn), out * std::sin(turn)};
            world.lights[i].light.colour = 0.5f + 0.5f * glm::cos(glm::vec3(i, i + 2, i + 4));
        }
        renderer->set_lights(world.lights);
        renderer->render(look_at({}, {0, 5, 9}, {0, 0, 0}));
        window.show(*renderer);
    }
}
