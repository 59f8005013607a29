// Triangles of its own under 1,000 moving lights in a window: example_window_lights [FRAMES]
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <cmath>
#include <cstdlib>
#include <prelight/scene_building.hpp>
#include <prelight/vulkan.hpp>

int main(int argc, char** argv) {
    using namespace prelight;
    glfwInit();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* window = glfwCreateWindow(640, 360, "1,000 lights", nullptr, nullptr);
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    const auto device = Device::create({.window_extensions = {names, names + count}});
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    glfwCreateWindowSurface(vulkan::handles(*device).instance, window, nullptr, &surface);
    vulkan::Presenter presenter(*device, surface);

    Scene scene;
    const uint32_t grey = add_material(scene, {.metallic = 0, .roughness = 0.4f});
    add_object(scene, "floor", {.positions = {{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}},
               grey);
    add_object(scene, "tent", {.positions = {{-2, 0, 1}, {2, 0, 1}, {0, 3, 0}, {2, 0, -1}, {-2, 0, -1}, {0, 3, 0}}},
               grey);
    scene.ambient = glm::vec3(0.01f);
    World world = resolve(scene);
    world.lights.resize(1000, {.light = {.intensity = 0.1f, .range = 1.2f}});
    const auto renderer = create_renderer("light-prepass", device.get(), {.width = 640, .height = 360});
    renderer->set_world(world);
    for (int frame = 0; !glfwWindowShouldClose(window) && (argc < 2 || frame < std::atoi(argv[1])); ++frame) {
        glfwPollEvents();
        for (int i = 0; i < 1000; ++i) {
            const double turn = 0.01 * frame + 2.4 * i, out = 0.28 * std::sqrt(i);
            world.lights[i].position = {out * std::cos(turn), 0.4 + 0.3 * std::sin(5 * turn), out * std::sin(turn)};
            world.lights[i].light.colour = {0.5 + 0.5 * std::cos(i), 0.5 + 0.5 * std::cos(i + 2),
                                            0.5 + 0.5 * std::cos(i + 4)};
        }
        renderer->set_lights(world.lights);
        renderer->render(look_at({}, {0, 5, 9}, {0, 0, 0}));
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        presenter.show(*renderer, {uint32_t(width), uint32_t(height)});
    }
}
