// example_edge_error [--scenes FOLDER] [SCENE.glb …]: the table of docs/anti-aliasing.md. What each way to smooth edges
// leaves of their error against 64 samples a pixel, in CPU time of a plain forward frame (F) and bytes of a pixel: of
// built-in scenes, of two with leaves and wires that it makes itself, and of the files named, which get 64 lights where
// they have fewer than two. With --scenes it only writes those two, leaves.glb and wires.glb.
#include "thin_scenes.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <map>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>
#include <span>

using namespace prelight;

namespace {

using Settings = std::map<std::string, std::string>;

struct Size {
    uint32_t width, height;
};
constexpr Size judged{240, 135}, timed{640, 360};
constexpr uint32_t many = 8; ///< times the judged size, both ways: the truth

struct Way {
    const char* name;
    uint32_t msaa;
    Settings settings;
    uint32_t times = 1; ///< the size, to be scaled down
};

const Way ways[] = {{"none", 1, {}},
                    {"edge-blur", 1, {{"antialiasing", "edge-blur"}}},
                    {"smaa", 1, {{"antialiasing", "smaa"}}},
                    {"msaa-light=pixel", 4, {{"msaa-light", "pixel"}}},
                    {"msaa-light=edges", 4, {}},
                    {"msaa-light=samples", 4, {{"msaa-light", "samples"}}},
                    {"msaa-material=sample", 4, {{"msaa-material", "sample"}}},
                    {"2×2 times the size", 1, {}, 2},
                    {"4×4 times the size", 1, {}, 4}};

struct Drawn {
    Image picture;
    Stats stats;
};

Drawn draw(Device& device, const World& world, const char* renderer, const Way& way, Size size, uint32_t frames) {
    RenderOptions options{.width = size.width * way.times, .height = size.height * way.times, .msaa = way.msaa};
    options.settings = way.settings;
    const auto made = create_renderer(renderer, &device, options);
    made->set_world(world);
    made->render(world.cameras.at(0), frames);
    return {made->read("final"), made->stats()};
}

glm::vec3 linear(glm::vec3 c) { return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)}; }

/// The mean of times × times pixels of a larger picture, in linear light.
glm::vec3 mean_of(const Image& large, uint32_t x, uint32_t y, uint32_t times) {
    glm::vec3 sum(0);
    for (uint32_t i = 0; i < times * times; ++i)
        sum += linear(large.at(times * x + i % times, times * y + i / times));
    return sum / static_cast<float>(times * times);
}

struct EdgeError {
    double edges = 0, others = 0, edge_share = 0; ///< RMS in linear light; share of pixels
};

/// Edge pixels: those whose samples differ by 0.1 or more in a channel.
EdgeError edge_error(const Image& picture, uint32_t times, const Image& truth) {
    EdgeError error;
    for (uint32_t y = 0; y < judged.height; ++y)
        for (uint32_t x = 0; x < judged.width; ++x) {
            glm::vec3 low(1), high(0);
            for (uint32_t i = 0; i < many * many; ++i) {
                const glm::vec3 sample = truth.at(many * x + i % many, many * y + i / many);
                low = glm::min(low, sample), high = glm::max(high, sample);
            }
            const glm::vec3 off = mean_of(picture, x, y, times) - mean_of(truth, x, y, many), span = high - low;
            const bool edge = std::max({span.r, span.g, span.b}) >= 0.1f;
            (edge ? error.edges : error.others) += static_cast<double>(glm::dot(off, off)) / 3;
            error.edge_share += edge;
        }
    const double pixels = double(judged.width) * judged.height, edges = error.edge_share;
    error.edges = edges > 0 ? std::sqrt(error.edges / edges) : 0;
    error.others = edges < pixels ? std::sqrt(error.others / (pixels - edges)) : 0;
    error.edge_share = edges / pixels;
    return error;
}

void show(Device& device, const std::string& name, const World& world) {
    const Image truth = draw(device, world, "light-prepass", {"truth", 1, {}, many}, judged, 1).picture;
    const double f = draw(device, world, "plain-forward", ways[0], timed, 9).stats.cpu_ms.median;
    fmt::print("\n{}: F {:.1f} ms, edges {:.1f} % of {}×{} pixels, times at {}×{}\n\n", name, f,
               100 * edge_error(truth, many, truth).edge_share, judged.width, judged.height, timed.width, timed.height);
    fmt::print("| | edges | others | F | bytes a pixel |\n| --- | --- | --- | --- | --- |\n");
    for (const Way& way : ways) {
        const Drawn small = draw(device, world, "light-prepass", way, judged, 1);
        const EdgeError error = edge_error(small.picture, way.times, truth);
        const Stats large = draw(device, world, "light-prepass", way, timed, 7).stats;
        fmt::print("| {} | {:.3f} | {:.3f} | {:.1f} | {:.0f} |\n", way.name, error.edges, error.others,
                   large.cpu_ms.median / f, static_cast<double>(large.attachment_bytes) / timed.width / timed.height);
        std::fflush(stdout);
    }
}

void run(std::span<char*> arguments) {
    if (arguments.size() == 2 && std::string(arguments[0]) == "--scenes") {
        const std::filesystem::path folder = arguments[1];
        save_glb(make_leaves(), folder / "leaves.glb");
        save_glb(make_wires(), folder / "wires.glb");
        return;
    }
    const auto device = Device::create({});
    fmt::print("{}\n", device->name());
    const std::pair<const char*, uint32_t> builtins[] = {{"city", 256}, {"lights", 256}};
    for (const auto& [name, lights] : builtins) {
        const Scene scene = make_scene(name, lights, 1);
        show(*device, fmt::format("{}, {} lights", name, lights), resolve(scene));
    }
    for (const Scene& scene : {make_leaves(), make_wires()})
        show(*device, scene.name, resolve(scene));
    for (const char* file : arguments) {
        const Scene scene = load_gltf(file);
        World world = resolve(scene);
        if (world.lights.size() < 2)
            scatter_lights(world, 64, 1);
        show(*device, scene.name, world);
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(std::span(argv, static_cast<size_t>(argc)).subspan(1));
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
