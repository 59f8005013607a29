// The shortest program: a built-in scene with a thousand lights becomes hello.png.
#include <prelight/device.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

int main() {
    const prelight::Scene scene = prelight::make_scene("lights", 1000, 1);
    const prelight::World world = prelight::resolve(scene);
    const auto device = prelight::Device::create({});
    const auto renderer = prelight::create_renderer("light-prepass", device.get(), {.width = 640, .height = 360});
    renderer->set_world(world);
    renderer->render(world.cameras.at(0));
    save_png(renderer->read("final"), "hello.png");
}
