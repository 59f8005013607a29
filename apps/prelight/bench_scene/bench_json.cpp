#include "bench_json.hpp"

#include "pass_kind.hpp"
#include "stats_json.hpp"

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json tile(const std::optional<double>& ms, uint32_t size) { return ms ? Json(size) : Json(nullptr); }

Json figures_json(const LimitFigures& f) {
    return {{"variant", f.run->job->variant.name()},
            {"lights", f.run->stop.lights},
            {"frames_by", f.by_cpu ? "cpu_ms" : "gpu_ms"},
            {"passes_by", f.passes_by_cpu ? "cpu_ms" : "gpu_ms"},
            {"unit_ms", f.unit_ms},
            {"frame_ms", f.frame_ms},
            {"frame_in_f", f.frame_in_f()},
            {"no_lights_ms", number(f.no_lights_ms)},
            {"no_lights_in_f", number(f.no_lights_in_f())},
            {"unit_pass_ms", number(f.unit_pass_ms)},
            {"geometry_ms", number(f.geometry_ms)},
            {"geometry_in_f", number(f.geometry_in_f())},
            {"light_ms", number(f.light_ms)},
            {"lists_ms", number(f.lists_ms)},
            {"lists_over_light", number(f.lists_over_light())},
            {"perfect_ms", number(f.perfect_ms)},
            {"perfect_tile", tile(f.perfect_ms, f.perfect_tile)},
            {"light_over_limit", number(f.light_over_limit())},
            {"empty_ms", number(f.empty_ms)},
            {"empty_tile", tile(f.empty_ms, f.empty_tile)}};
}

} // namespace

Json run_json(const std::string& scene, const Run& run) {
    const Job& job = *run.job;
    Json json = {{"variant", job.variant.name()},
                 {"role", role_name(job.role)},
                 {"light_count", run.stop.count ? Json(*run.stop.count) : Json(nullptr)},
                 {"at_lights", run.stop.lights}};
    json.update(stats_entry(scene, job.variant.renderer, job.options, run.stats));
    for (Json& pass : json["passes"])
        pass["kind"] = pass_kind_name(kind_of(pass["name"].get<std::string>()));
    return json;
}

Json limit_json(const std::string& scene, const Measured& measured, const std::vector<LimitFigures>& figures,
                const std::vector<std::string>& missing) {
    Json json = {{"figures", Json::array()}, {"missing", missing}, {"runs", Json::array()}};
    for (const LimitFigures& one : figures)
        json["figures"].push_back(figures_json(one));
    for (const Run& run : measured.runs)
        if (run.job->role != Role::contender)
            json["runs"].push_back(run_json(scene, run));
    return json;
}

} // namespace prelight::app
