#include "bench_scene/noise.hpp"
#include "report.hpp"
#include "stats_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <prelight/version.hpp>

namespace prelight::app {
namespace {

using ReportJson = nlohmann::ordered_json;

/// The buffers of the Round 2 sample have its keys, 1 to 4; the others follow.
struct Key {
    const char* view;
    const char* key;
    const char* label;
};
constexpr Key keys[] = {{"final", "0", "Picture"},
                        {"depth", "1", "Depth"},
                        {"normal", "2", "Normals"},
                        {"diffuse-light", "3", "Lights"},
                        {"albedo", "4", "Material"},
                        {"difference", "5", "Difference"},
                        {"specular-light", "6", "Specular light"},
                        {"light-count", "7", "Light count"},
                        {"roughness", "8", "Roughness"}};

/// Whether a pass is there for the lights alone: it evaluates them or finds their pixels. Passes that
/// shade lights together with materials are not.
bool is_light_pass(const std::string& name) {
    for (const char* word : {"light", "stencil", "tile", "cluster"})
        if (name.find(word) != std::string::npos)
            return true;
    return false;
}

/// Of the passes' time together; null where no pass is there for the lights alone.
ReportJson light_share(const Stats& stats) {
    double light = 0, all = 0;
    bool any = false;
    for (const PassStats& pass : stats.passes) {
        all += pass.gpu_ms.median;
        if (is_light_pass(pass.name)) {
            light += pass.gpu_ms.median;
            any = true;
        }
    }
    return any && all > 0 ? ReportJson(light / all) : ReportJson(nullptr);
}

ReportJson per_pixel(uint64_t bytes, const RenderOptions& options) {
    return double(bytes) / (double(options.width) * double(options.height));
}

ReportJson entry(const Report& report, const RunReport& run, const Stats& stats) {
    ReportJson json = stats_entry(report.scene, run.variant.renderer, run.options, stats);
    json["attachment_bytes_per_pixel"] = {{"shared", per_pixel(stats.attachment_bytes, run.options)},
                                          {"unshared", per_pixel(stats.attachment_bytes_unshared, run.options)}};
    json["light_pass_share"] = light_share(stats);
    for (size_t i = 0; i < stats.passes.size(); ++i)
        json["passes"][i]["for_lights"] = is_light_pass(stats.passes[i].name);
    return json;
}

ReportJson difference_json(const Comparison& difference) {
    return {{"psnr", std::isfinite(difference.psnr) ? ReportJson(difference.psnr) : ReportJson(nullptr)},
            {"flip", difference.flip},
            {"off_share", difference.off_share},
            {"block", difference.block},
            {"left_out_share", difference.left_out_share}};
}

ReportJson heading(const RunReport& run) {
    const Variant& variant = run.variant;
    return {{"variant", variant.name()},
            {"kind", !variant.preset.empty()     ? "preset"
                     : !variant.settings.empty() ? "settings"
                                                 : "architecture"},
            {"description", run.info.description},
            {"error", run.error.empty() ? ReportJson(nullptr) : ReportJson(run.error)}};
}

ReportJson run_json(const Report& report, const RunReport& run) {
    ReportJson json = heading(run);
    if (!run.error.empty()) {
        json["renderer"] = run.variant.renderer;
        return json;
    }
    json.update(entry(report, run, run.stats));
    json["reference_form"] = run.form;
    json["difference"] = difference_json(run.difference);
    json["pictures"] = ReportJson(run.pictures);
    return json;
}

/// Least squares of a time over the number of lights.
struct Line {
    ReportJson slope;          ///< what one light more costs, microseconds; null with fewer than two numbers of lights
    ReportJson error;          ///< standard error of it, by what each point's median may be off
    ReportJson without_lights; ///< milliseconds
};

Line line_through(const std::vector<Stats>& series, Spread Stats::*time) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Stats& stats : series) {
        const double lights = double(stats.lights), ms = (stats.*time).median;
        n += 1;
        x += lights;
        y += ms;
        xx += lights * lights;
        xy += lights * ms;
    }
    const double spread = n * xx - x * x;
    if (n < 2 || spread <= 0)
        return {};
    const double slope = (n * xy - x * y) / spread;
    double variance = 0; // of a weighted sum of the medians, which is what the slope is
    for (const Stats& stats : series) {
        const double weight = (n * double(stats.lights) - x) / spread, noise = figure_of(stats.*time).noise;
        variance += weight * weight * noise * noise;
    }
    return {slope * 1000, std::sqrt(variance) * 1000, (y - slope * x) / n};
}

ReportJson series_json(const Report& report) {
    ReportJson all = ReportJson::array();
    for (const RunReport& run : report.runs) {
        if (!run.error.empty() || !run.in_series)
            continue;
        const Line device = line_through(run.series, &Stats::gpu_ms), cpu = line_through(run.series, &Stats::cpu_ms);
        ReportJson json = {{"variant", run.variant.name()},
                           {"us_per_light", device.slope},
                           {"us_per_light_error", device.error},
                           {"ms_without_lights", device.without_lights},
                           {"cpu_us_per_light", cpu.slope},
                           {"cpu_us_per_light_error", cpu.error},
                           {"cpu_ms_without_lights", cpu.without_lights},
                           {"stopped", run.stopped.empty() ? ReportJson(nullptr) : ReportJson(run.stopped)},
                           {"points", ReportJson::array()}};
        for (const Stats& stats : run.series)
            json["points"].push_back(entry(report, run, stats));
        all.push_back(std::move(json));
    }
    return all;
}

/// Every buffer that any run has, with the key that shows it.
ReportJson views_json(const Report& report) {
    std::vector<std::string> found;
    const auto add = [&](const std::map<std::string, std::string>& pictures) {
        for (const auto& [view, file] : pictures)
            if (std::ranges::find(found, view) == found.end())
                found.push_back(view);
    };
    add(report.reference_pictures);
    for (const RunReport& run : report.runs)
        add(run.pictures);
    ReportJson views = ReportJson::array();
    for (const Key& key : keys)
        if (std::ranges::find(found, key.view) != found.end())
            views.push_back({{"name", key.view}, {"key", key.key}, {"label", key.label}});
    ReportJson free_key = "9";
    for (const std::string& view : found) {
        if (std::ranges::find(keys, view, &Key::view) != std::end(keys))
            continue;
        std::string label = view;
        std::ranges::replace(label, '-', ' ');
        label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
        views.push_back({{"name", view}, {"key", free_key}, {"label", label}});
        free_key = nullptr;
    }
    return views;
}

} // namespace

ReportJson report_json(const Report& report) {
    const CompareCommand& command = report.command;
    ReportJson json = {
        {"prelight_report", 1},
        {"version", version()},
        {"scene", report.scene},
        {"camera", report.camera},
        {"size", {command.options.width, command.options.height}},
        {"shading", command.options.shading.value_or(Shading::ggx) == Shading::ggx ? "ggx" : "phong"},
        {"exposure", command.options.exposure},
        {"seed", command.seed},
        {"time", command.moment ? ReportJson(command.moment->time) : ReportJson(nullptr)},
        {"lights", report.lights},
        {"lights_added", report.lights_added},
        {"triangles", report.triangles},
        {"device", report.device},
        {"driver", report.driver},
        {"device_type", report.device_type},
        {"steady_time", report.software() ? "cpu_ms" : "gpu_ms"},
        {"frames", command.frames},
        {"frame_limit", command.frame_limit},
        {"seconds", report.seconds},
        {"budget", report.budget.seconds() ? ReportJson{{"seconds", *report.budget.seconds()}, {"cut", report.cut}}
                                           : ReportJson(nullptr)},
        {"views", views_json(report)},
        {"reference", {{"wall_ms", report.reference_ms}, {"pictures", ReportJson(report.reference_pictures)}}},
        {"runs", ReportJson::array()}};
    for (const RunReport& run : report.runs)
        json["runs"].push_back(run_json(report, run));
    json["light_counts"] = series_json(report);
    return json;
}

} // namespace prelight::app
