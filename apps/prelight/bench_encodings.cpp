#include "bench.hpp"
#include "scene_source.hpp"

#include <fmt/format.h>
#include <limits>
#include <prelight/bench.hpp>

namespace prelight::app {
namespace {

void print_row(const EncodingFigures& f) {
    fmt::print("{:<10} {:>4} {:<8} {:>5}   {:8.5f}   {:8.5f}   {:8.5f}   {:7.1f}   {:6.3f} %   {:5.2f}\n", f.name,
               f.bits, f.target, f.bytes, f.mean, f.percentile_99, f.max, f.picture.psnr, f.picture.off_share * 100,
               f.picture.block);
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

void print_row(const DepthFigures& f) {
    const std::string relative = f.relative ? fmt::format("{:.2e}", *f.relative) : "-";
    fmt::print("{:<10} {:<8} {:>5}   {:>12}   {:7.1f}   {:6.3f} %   {:5.2f}\n", f.name, f.target, f.bytes, relative,
               f.picture.psnr, f.picture.off_share * 100, f.picture.block);
}

nlohmann::ordered_json row_json(const DepthFigures& f) {
    using Json = nlohmann::ordered_json;
    return {{"name", f.name},
            {"target", f.target},
            {"bytes_per_pixel", f.bytes},
            {"max_relative_error", f.relative ? Json(*f.relative) : Json(nullptr)},
            {"psnr_db", f.picture.psnr},
            {"off_share", f.picture.off_share},
            {"block", f.picture.block},
            {"flip", f.picture.flip}};
}

} // namespace

nlohmann::ordered_json bench_encodings_table(const BenchCommand& command, Device& device) {
    const auto loaded = load_scene(command.scene, command.lights, command.seed, std::numeric_limits<uint32_t>::max());
    const PlacedCamera& camera =
        command.camera.empty() ? loaded->world.cameras.at(0) : find_camera(loaded->world, command.camera);
    fmt::print("{}, {} lights, {}x{}, on {}\n", command.scene, loaded->world.lights.size(), command.width,
               command.height, device.name());
    fmt::print("normals    bits target   bytes     mean °      99 % °      max °   PSNR dB        off   block\n");
    const EncodingBench options{
        .width = command.width, .height = command.height, .done = [](const EncodingFigures& f) { print_row(f); }};
    const auto encodings = bench_encodings(device, loaded->world, camera, options);
    nlohmann::ordered_json encoding_rows = nlohmann::ordered_json::array(), depth_rows = encoding_rows;
    for (const EncodingFigures& f : encodings)
        encoding_rows.push_back(row_json(f));
    fmt::print("\nwith normals=oct32:\ndepth      target   bytes   max relative   PSNR dB        off   block\n");
    for (const DepthFigures& f : bench_depth_sources(device, loaded->world, camera, options)) {
        print_row(f);
        depth_rows.push_back(row_json(f));
    }
    return {{"scene", command.scene},
            {"lights", loaded->world.lights.size()},
            {"size", {command.width, command.height}},
            {"directions", encodings.front().directions},
            {"encodings", encoding_rows},
            {"depth_sources", depth_rows}};
}

} // namespace prelight::app
