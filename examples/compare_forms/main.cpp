// example_compare_forms [SCENE.glb …]: figures of docs/measuring.md for the built-in scenes and for
// the files named, which get 1,024 lights: the light pre-pass against the reference of its own
// form, and the forms of the lighting model against the full one, reference against reference.
#include <fmt/format.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>
#include <prelight/reference.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;

namespace {

constexpr uint32_t width = 1280, height = 720;

void print(const std::string& name, const Comparison& c) {
    fmt::print("{:<34} {:>6.1f} dB {:>8.3f} % off, block {:>5.2f}/255, FLIP {:.4f}, {:.1f} % left out\n", name, c.psnr,
               c.off_share * 100, c.block, c.flip, c.left_out_share * 100);
}

void show(Device& device, const std::string& name, const World& world) {
    using Fresnel = ReferenceForm::Fresnel;
    const PlacedCamera& camera = world.cameras.at(0);
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.settings = {{"texture-filter", "bilinear"}};
    options.views = {"linear"};
    const auto renderer = create_renderer("light-prepass", &device, options);
    renderer->set_world(world);
    renderer->render(camera);
    const auto reference = [&](Fresnel fresnel) {
        ReferenceForm form = reference_form(options.shading.value_or(Shading::ggx), renderer->stats().settings);
        form.fresnel = fresnel;
        return render_reference(world, camera, width, height, 0, form);
    };

    const ReferencePicture full = reference(Fresnel::full), weighted = reference(Fresnel::weighted);
    print(name + ": light-prepass", compare(renderer->read("linear"), weighted.linear, weighted.left_out()));
    print("    weighted against full", compare(weighted.linear, full.linear));
    print("    nv against full", compare(reference(Fresnel::nv).linear, full.linear));
    print("    mono against full", compare(reference(Fresnel::mono).linear, full.linear));
}

void run(int argc, char** argv) {
    const auto device = Device::create({});
    const std::pair<const char*, uint32_t> builtins[] = {
        {"city", 256}, {"city", 1024}, {"lights", 1024}, {"spheres", 8}};
    for (const auto& [name, lights] : builtins) {
        const Scene scene = make_scene(name, lights, 1);
        show(*device, fmt::format("{}, {} lights", name, lights), resolve(scene));
    }
    for (int i = 1; i < argc; ++i) {
        const Scene scene = load_gltf(argv[i]);
        World world = resolve(scene);
        scatter_lights(world, 1024, 1);
        show(*device, scene.name + ", 1024 lights", world);
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
