// What a program needs of the library: example_embed [SCENE.glb [FOLDER]]. Renders two views of a
// scene from one renderer and writes FOLDER/embed-0.png, FOLDER/embed-1.png (default: here).
#include <cstdio>
#include <filesystem>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

namespace {

void run(int argc, char** argv) {
    using namespace prelight;
    // A scene is what a file holds; a world is one of its node trees resolved to world space.
    const Scene scene = argc > 1 ? load_gltf(argv[1]) : make_scene("lights", 256, 1);
    for (const std::string& warning : scene.warnings)
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    World world = resolve(scene);

    // Lights and cameras of the program's own.
    const double size = glm::length(world.bounds_max - world.bounds_min);
    const glm::dvec3 middle = (world.bounds_min + world.bounds_max) * 0.5;
    PlacedLight lamp;
    lamp.light.colour = {1, 0.6f, 0.3f};
    lamp.light.range = static_cast<float>(size);
    lamp.light.intensity = static_cast<float>(size * size * 0.1);
    lamp.position = middle + glm::dvec3(0, size * 0.1, 0);
    world.lights.push_back(lamp);
    const PlacedCamera above = look_at(Camera{}, middle + glm::dvec3(0.1, 0.4, 0.3) * size, middle);

    // One device for the program, one renderer for each set of options.
    const std::unique_ptr<Device> device = Device::create({.select = "auto"});
    RenderOptions options;
    options.width = 640;
    options.height = 360;
    options.settings = {{"normals", "oct32"}};
    const std::unique_ptr<Renderer> renderer = create_renderer("light-prepass", device.get(), options);
    renderer->set_world(world);

    const std::filesystem::path folder = argc > 2 ? argv[2] : ".";
    const PlacedCamera cameras[] = {world.cameras.at(0), above};
    for (int i = 0; i < 2; ++i) {
        renderer->render(cameras[i]);
        save_png(renderer->read("final"), folder / ("embed-" + std::to_string(i) + ".png"));
        for (const PassStats& pass : renderer->stats().passes)
            std::printf("%-14s %8.2f ms\n", pass.name.c_str(), pass.gpu_ms.median);
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
        return 0;
    } catch (const prelight::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
