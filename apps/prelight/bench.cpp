#include "bench.hpp"

#include "bench_scene/bench_scene.hpp"
#include "commands.hpp"
#include "memory_check.hpp"
#include "output.hpp"
#include "scene_files.hpp"
#include "scene_source.hpp"
#include "validation.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <tuple>

namespace prelight::app {
namespace {

constexpr std::array benches{
    Bench{"encodings", "angular error of each encoding of normals, and its picture's error", bench_encodings_table},
    Bench{"light-buffers", "error of each light buffer by the lights on a pixel, on a wall of its own",
          bench_light_buffers_table, 160, 90},
    Bench{"claims", "what the source texts claim, beside figures of this device", bench_claims_table},
};

} // namespace

std::string bench_names() {
    std::string names;
    for (const Bench& bench : benches)
        names += (names.empty() ? "" : ", ") + std::string(bench.name);
    return names;
}

bool is_bench(std::string_view name) { return std::ranges::find(benches, name, &Bench::name) != benches.end(); }

void run(const BenchCommand& command) {
    if (command.kind == BenchCommand::Kind::scene)
        return bench_scene(command);
    if (command.kind == BenchCommand::Kind::report)
        return bench_report(command);
    const auto bench = std::ranges::find(benches, std::string_view(command.what), &Bench::name);
    check_scene_name(command.scene);
    std::vector<std::filesystem::path> inputs = files_named_in(command.scene);
    inputs.emplace_back(command.scene);
    check_distinct(std::array{command.json}, inputs);
    if (!command.json.empty())
        check_writable(command.json);
    BenchCommand sized = command;
    if (command.width == 0)
        std::tie(sized.width, sized.height) = std::pair(bench->width, bench->height);
    const auto device =
        open_device({.select = command.device, .validate = command.validate}, sized.width, sized.height);
    nlohmann::ordered_json json = {{"bench", command.what}, {"device", device->name()}, {"driver", device->driver()}};
    json.update(bench->run(sized, *device));
    check_validation(*device);
    // A file name may hold any bytes; JSON holds UTF-8 only.
    if (!command.json.empty())
        save_text(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n", command.json);
}

} // namespace prelight::app
