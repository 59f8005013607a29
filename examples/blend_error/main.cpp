// What blending into a half-float light buffer costs, in two tables (docs/figures.md holds them).
// First: N equal lights at one place share a fixed total of light on a white floor; the relative
// error of the picture's mean against the reference's, and what it would be if every add rounded to
// the nearest half float, or cut the rest off. Second: the scene `lights`.
#include <cmath>
#include <fmt/format.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>
#include <prelight/reference.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;

namespace {

Scene white_floor() {
    Primitive floor;
    floor.positions = {{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}};
    floor.normals.assign(4, {0, 1, 0});
    floor.indices = {0, 1, 2, 0, 2, 3};
    Scene scene;
    scene.name = "white floor";
    scene.materials.push_back({.name = "white", .metallic = 0, .roughness = 1});
    scene.meshes.push_back({"floor", {floor}});
    Node node;
    node.mesh = 0;
    scene.nodes.push_back(node);
    scene.scenes.push_back({"floor", {0}});
    scene.ambient = glm::vec3(1e-6f); // so that resolve() adds no light of its own
    return scene;
}

/// Relative error of the mean over the pixels that count.
double mean_error(const Image& picture, const ReferencePicture& truth) {
    const std::vector<uint8_t> left_out = truth.left_out();
    double sum = 0, true_sum = 0;
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3 && !left_out[i]; ++c) {
            sum += picture.pixels[i][c];
            true_sum += truth.linear.pixels[i][c];
        }
    return sum / true_sum - 1;
}

/// `value` > 0 with the 11 significant bits of a half float.
double to_half(double value, bool nearest) {
    const double step = std::exp2(std::max(std::ilogb(value), -14) - 10);
    return (nearest ? std::nearbyint(value / step) : std::floor(value / step)) * step;
}

/// Relative error of `count` adds of total/count into a half float and of writing the picture as
/// half floats, averaged over totals of one octave.
double simulated(uint32_t count, bool nearest) {
    constexpr int samples = 64;
    double error = 0;
    for (int s = 0; s < samples; ++s) {
        const double total = 1 + std::fmod(0.618034 * s, 1.0), albedo = 0.9 + 0.1 * std::fmod(0.754878 * s, 1.0);
        double sum = 0;
        for (uint32_t i = 0; i < count; ++i)
            sum = to_half(sum + total / count, nearest);
        error += (to_half(sum * albedo, nearest) / (total * albedo) - 1) / samples;
    }
    return error;
}

struct Pair {
    Image picture;
    ReferencePicture truth;
};

Pair render_both(Device& device, const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.views = {"linear"};
    options.settings = {{"light-culling", "volumes"},
                        {"light-sums", "target"}}; // blended in half floats, however many lights
    const auto renderer = create_renderer("light-prepass", &device, options);
    renderer->set_world(world);
    renderer->render(camera);
    return {renderer->read("linear"), render_reference(world, camera, width, height, 0, {})};
}

void equal_lights(Device& device) {
    const Scene scene = white_floor();
    const PlacedCamera camera = look_at(Camera{}, {0, 4, 0.01}, {0, 0, 0});
    fmt::print("{:>6} {:>10} {:>15} {:>10}\n", "lights", "error", "to the nearest", "cut off");
    for (uint32_t count = 1; count <= 4096; count *= 4) {
        World world = resolve(scene);
        world.ambient = glm::vec3(0);
        PlacedLight lamp;
        lamp.light.intensity = 20.0f / static_cast<float>(count);
        lamp.light.range = 10;
        lamp.position = {0, 2, 0};
        world.lights.assign(count, lamp);
        const Pair both = render_both(device, world, camera, 128, 128);
        fmt::print("{:>6} {:>9.2f}% {:>14.2f}% {:>9.2f}%\n", count, mean_error(both.picture, both.truth) * 100,
                   simulated(count, true) * 100, simulated(count, false) * 100);
    }
}

void baseline(Device& device) {
    fmt::print("\n{:>6} {:>10} {:>8} {:>10}\n", "lights", "error", "PSNR", "block");
    for (const uint32_t count : {256u, 1024u, 4096u, 16384u, 65536u}) {
        const Scene scene = make_scene("lights", count, 1);
        const World world = resolve(scene);
        const Pair both = render_both(device, world, world.cameras.at(0), 320, 180);
        const Comparison c = compare(both.picture, both.truth.linear, both.truth.left_out());
        fmt::print("{:>6} {:>9.2f}% {:>8.1f} {:>6.2f}/255\n", count, mean_error(both.picture, both.truth) * 100, c.psnr,
                   c.block);
    }
}

} // namespace

int main() {
    try {
        const auto device = Device::create({});
        fmt::print("{}\n", device->name());
        equal_lights(*device);
        baseline(*device);
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
