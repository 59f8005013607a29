#include "bench.hpp"

#include <fmt/format.h>
#include <prelight/bench_light_buffers.hpp>

namespace prelight::app {
namespace {

using Figures = std::vector<LightBufferFigures>;

/// "12.3" with three digits; the columns stay narrow.
std::string percent(double fraction) {
    const double value = fraction * 100;
    return fmt::format("{:.{}f}", value, value < 1 ? 3 : value < 10 ? 2 : 1);
}

void print_overlap(const Figures& overlaps) {
    const LightBufferFigures& first = overlaps.front();
    fmt::print("{:<25} {:>5} {:<8}", first.name, first.bytes, first.writes);
    for (const auto sum :
         {&LightBufferFigures::diffuse, &LightBufferFigures::specular, &LightBufferFigures::rounding}) {
        fmt::print(" |");
        for (const LightBufferFigures& f : overlaps)
            fmt::print(" {:>6}", percent((f.*sum).rms));
    }
    fmt::print("\n");
    std::fflush(stdout);
}

void print_head(const std::vector<uint32_t>& overlaps) {
    fmt::print("RMS error in percent of the reference's mean, by lights on each pixel\n");
    fmt::print("{:<25} {:>5} {:<8}", "light buffer", "bytes", "writes");
    for (const char* sum : {"diffuse", "specular", "specular, rounding"})
        fmt::print(" | {:<{}}", sum, 7 * overlaps.size() - 1);
    fmt::print("\n{:<40}", "");
    for (int i = 0; i < 3; ++i) {
        fmt::print(" |");
        for (const uint32_t overlap : overlaps)
            fmt::print(" {:>6}", overlap);
    }
    fmt::print("\n");
}

nlohmann::ordered_json error_json(const LightSumError& e) { return {{"rms", e.rms}, {"max", e.max}, {"bias", e.bias}}; }

nlohmann::ordered_json row_json(const LightBufferFigures& f) {
    return {{"name", f.name},
            {"light-buffer", f.light_buffer},
            {"specular", f.specular_way},
            {"light-writes", f.writes},
            {"light-scale", f.scale},
            {"bytes_per_pixel", f.bytes},
            {"overlap", f.overlap},
            {"diffuse_error", error_json(f.diffuse)},
            {"specular_error", error_json(f.specular)},
            {"specular_rounding_error", error_json(f.rounding)}};
}

} // namespace

nlohmann::ordered_json bench_light_buffers_table(const BenchCommand& command, Device& device) {
    const LightBufferBench options{.width = command.width, .height = command.height, .done = print_overlap};
    fmt::print("a wall of {}x{} pixels, on {}\n", options.width, options.height, device.name());
    print_head(options.overlaps);
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const LightBufferFigures& f : bench_light_buffers(device, options))
        rows.push_back(row_json(f));
    return {{"size", {options.width, options.height}}, {"light_buffers", rows}};
}

} // namespace prelight::app
