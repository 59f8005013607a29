#include "bench.hpp"
#include "scene_source.hpp"

#include <fmt/format.h>
#include <limits>
#include <prelight/bench.hpp>

namespace prelight::app {
namespace {

void print_row(const EncodingFigures& f) {
    fmt::print("{:<10} {:>4} {:<8} {:>5}   {:8.5f}   {:8.5f}   {:8.5f}   {:7.1f}   {:6.3f} %   {:5.2f}\n",
               f.name, f.bits, f.target, f.bytes, f.mean, f.percentile_99, f.max, f.picture.psnr,
               f.picture.off_share * 100, f.picture.block);
    std::fflush(stdout);
}

nlohmann::ordered_json row_json(const EncodingFigures& f) {
    return {{"name", f.name},
            {"bits", f.bits},
            {"target", f.target},
            {"bytes_per_pixel", f.bytes},
            {"mean_degrees", f.mean},
            {"percentile_99_degrees", f.percentile_99},
            {"max_degrees", f.max},
            {"psnr_db", f.picture.psnr},
            {"off_share", f.picture.off_share},
            {"block", f.picture.block},
            {"flip", f.picture.flip},
            {"left_out_share", f.picture.left_out_share}};
}

} // namespace

nlohmann::ordered_json bench_encodings_table(const BenchCommand& command, Device& device) {
    const auto loaded = load_scene(command.scene, command.lights, command.seed,
                                   std::numeric_limits<uint32_t>::max());
    const PlacedCamera& camera = command.camera.empty() ? loaded->world.cameras.at(0)
                                                        : find_camera(loaded->world, command.camera);
    fmt::print("{}, {} lights, {}x{}, on {}\n", command.scene, loaded->world.lights.size(),
               command.width, command.height, device.name());
    fmt::print("normals    bits target   bytes     mean °      99 % °      max °   PSNR dB        off   block\n");
    const std::vector<EncodingFigures> figures = bench_encodings(
        device, loaded->world, camera,
        {.width = command.width, .height = command.height, .done = print_row});
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const EncodingFigures& f : figures)
        rows.push_back(row_json(f));
    return {{"scene", command.scene},
            {"lights", loaded->world.lights.size()},
            {"size", {command.width, command.height}},
            {"directions", figures.front().directions},
            {"encodings", rows}};
}

} // namespace prelight::app
