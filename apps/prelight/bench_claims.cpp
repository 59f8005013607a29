#include "bench.hpp"
#include "claims.hpp"
#include "device_type.hpp"

#include <fmt/format.h>
#include <limits>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint32_t default_lights = 16; ///< of a built-in scene
constexpr uint32_t default_frames = 5;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

void print_claim(const Claim& c) {
    fmt::print("\n{}: {}\n    claim    {} ({})\n    how      {}\n", c.id, verdict_name(c.verdict()), c.claim, c.source,
               c.how);
    if (c.a && c.b)
        fmt::print("    figures  {:.3g} : {:.3g} {}{}\n", *c.a, *c.b, c.unit,
                   c.ratio() ? fmt::format(" = {:.2f}", *c.ratio()) : "");
    std::fflush(stdout);
}

Json row_json(const Claim& c) {
    return {{"id", c.id},
            {"claim", c.claim},
            {"source", c.source},
            {"how", c.how},
            {"unit", c.unit},
            {"a", number(c.a)},
            {"b", number(c.b)},
            {"ratio", number(c.ratio())},
            {"agrees_from", c.from},
            {"agrees_to", number(c.to)},
            {"verdict", verdict_name(c.verdict())}};
}

} // namespace

Json bench_claims_table(const BenchCommand& command, Device& device) {
    const auto lights = command.lights || names_file(command.scene) ? command.lights : default_lights;
    const auto loaded = load_scene(command.scene, lights, command.seed, std::numeric_limits<uint32_t>::max());
    const World& world = loaded->world;
    const ClaimScene scene{.device = device,
                           .world = world,
                           .camera = command.camera.empty() ? world.cameras.at(0) : find_camera(world, command.camera),
                           .width = command.width,
                           .height = command.height,
                           .frames = command.frames.value_or(default_frames),
                           .software = type_of(device) == "software"};
    fmt::print("{}, {} lights, {} objects, {}x{}, on {}\n", command.scene, world.lights.size(), world.instances.size(),
               scene.width, scene.height, device.name());
    Json rows = Json::array(), presets = rows;
    const auto add = [&](const std::vector<Claim>& claims) {
        for (const Claim& claim : claims) {
            print_claim(claim);
            rows.push_back(row_json(claim));
        }
    };
    add(size_claims(scene)); // at once: the others take minutes
    add(time_claims(scene));
    fmt::print("\npreset        bytes a pixel   unshared   MB at 1280x720\n");
    for (const PresetSize& size : preset_sizes(scene)) {
        fmt::print("{:<13} {:13.1f}   {:8.1f}   {:14.1f}\n", size.preset, size.bytes, size.unshared,
                   size.bytes * 1280 * 720 / 1e6);
        presets.push_back(
            {{"preset", size.preset}, {"bytes_per_pixel", size.bytes}, {"bytes_per_pixel_unshared", size.unshared}});
    }
    return {{"scene", command.scene},
            {"lights", world.lights.size()},
            {"objects", world.instances.size()},
            {"size", {scene.width, scene.height}},
            {"frames", scene.frames},
            {"claims", rows},
            {"presets", presets}};
}

} // namespace prelight::app
