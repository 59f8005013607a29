// example_inferred_error [SCENE.glb …]: the table of docs/inferred.md. How far inferred lighting at each scale is from
// light at each pixel and layer, reference against reference, and the renderer from its own form, for built-in scenes
// and for the files named, which get 64 lights.
#include <fmt/format.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>
#include <prelight/reference.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;

namespace {

constexpr uint32_t width = 640, height = 360;

void print(const std::string& name, const Comparison& c) {
    fmt::print("{:<34} {:>6.1f} dB {:>8.3f} % off, block {:>5.2f}/255, FLIP {:.4f}, {:.1f} % left out\n", name, c.psnr,
               c.off_share * 100, c.block, c.flip, c.left_out_share * 100);
}

void show(Device& device, const std::string& name, const World& world) {
    const PlacedCamera& camera = world.cameras.at(0);
    fmt::print("{}\n", name);
    ReferencePicture truth;
    for (const char* scale : {"1", "3/4", "5/8", "1/2"}) {
        RenderOptions options;
        options.width = width;
        options.height = height;
        options.settings = {{"texture-filter", "bilinear"}, {"inferred-scale", scale}};
        options.views = {"linear"};
        const auto renderer = create_renderer("inferred", &device, options);
        renderer->set_world(world);
        renderer->render(camera);
        const Stats stats = renderer->stats();
        ReferenceForm form = reference_form(stats.shading, stats.settings);
        const ReferencePicture own = render_reference(world, camera, width, height, 0, form);
        if (truth.linear.pixels.empty()) {
            form.inferred_scale = 0;
            truth = render_reference(world, camera, width, height, 0, form);
        }
        print(fmt::format("    {} against the truth", scale), compare(own.linear, truth.linear));
        print(fmt::format("    {}, the renderer", scale),
              compare(renderer->read("linear"), own.linear, own.left_out()));
        const uint64_t pixels = uint64_t(width) * height;
        fmt::print("    {} layers, {} without a slot of their own, unmatched {:.2f} % of the picture's pixels\n",
                   stats.inferred->layers, stats.inferred->layers_without_slot,
                   100.0 * static_cast<double>(stats.inferred->unmatched_pixels) / static_cast<double>(pixels));
    }
}

void run(int argc, char** argv) {
    const auto device = Device::create({});
    const std::pair<const char*, uint32_t> builtins[] = {{"spheres", 8}, {"city", 64}, {"glass", 16}};
    for (const auto& [name, lights] : builtins) {
        const Scene scene = make_scene(name, lights, 1);
        show(*device, fmt::format("{}, {} lights", name, lights), resolve(scene));
    }
    for (int i = 1; i < argc; ++i) {
        const Scene scene = load_gltf(argv[i]);
        World world = resolve(scene);
        scatter_lights(world, 64, 1);
        show(*device, scene.name + ", 64 lights", world);
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
