#include "stats_json.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const Spread& spread) { return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}}; }

Json host_json(const HostTimes& host) {
    return {{"lights", spread_json(host.lights)},
            {"culling", spread_json(host.culling)},
            {"objects", spread_json(host.objects)},
            {"record", spread_json(host.record)}};
}

Json shadows_json(const ShadowStats& shadows) {
    return {{"budget", shadows.budget},
            {"texels", shadows.texels},
            {"lights", shadows.lights},
            {"lights_reduced", shadows.lights_reduced},
            {"lights_without", shadows.lights_without},
            {"smallest", shadows.smallest},
            {"largest", shadows.largest},
            {"tiles_drawn", shadows.tiles_drawn},
            {"tiles_reused", shadows.tiles_reused},
            {"casters_drawn", shadows.casters_drawn}};
}

} // namespace

Json stats_entry(const std::string& scene, const std::string& renderer, const RenderOptions& options,
                 const Stats& stats) {
    Json passes = Json::array();
    // A pass's own CPU time wants it submitted alone: without that no figure, rather than a wrong one.
    for (const PassStats& pass : stats.passes)
        passes.push_back({{"name", pass.name},
                          {"gpu_ms", spread_json(pass.gpu_ms)},
                          {"cpu_ms", pass.cpu_ms ? spread_json(*pass.cpu_ms) : Json(nullptr)},
                          {"bytes_read", pass.bytes_read},
                          {"bytes_written", pass.bytes_written}});
    Json choices = Json::array();
    for (const SettingChoice& choice : stats.choices)
        choices.push_back(
            {{"setting", choice.key}, {"asked", choice.asked}, {"taken", choice.taken}, {"why", choice.why}});
    Json entry{
        {"device", stats.device},
        {"driver", stats.driver},
        {"scene", scene},
        {"renderer", renderer},
        {"preset", options.preset.empty() ? Json(nullptr) : Json(options.preset)},
        {"settings", Json(stats.settings)},
        {"choices", choices},
        {"size", {options.width, options.height}},
        {"msaa", options.msaa},
        {"exposure", options.exposure},
        {"shading", stats.shading == Shading::ggx ? "ggx" : "phong"},
        {"lights", stats.lights},
        {"triangles", stats.triangles},
        {"draws", stats.draws},
        {"triangles_drawn", stats.triangles_drawn},
        {"draws_skipped", stats.draws_skipped ? Json(*stats.draws_skipped) : Json(nullptr)},
        {"triangles_skipped", stats.triangles_skipped ? Json(*stats.triangles_skipped) : Json(nullptr)},
        {"frames", stats.frames},
        {"wall_ms", spread_json(stats.wall_ms)},
        {"cpu_ms", spread_json(stats.cpu_ms)},
        {"gpu_ms", spread_json(stats.gpu_ms)},
        {"host_ms", stats.host_ms ? host_json(*stats.host_ms) : Json(nullptr)},
        {"passes", passes},
        {"attachment_bytes", stats.attachment_bytes},
        {"attachment_bytes_unshared", stats.attachment_bytes_unshared},
        {"device_bytes", stats.device_bytes},
        {"device_bytes_peak", stats.device_bytes_peak},
        {"updated_bytes", stats.updated_bytes},
        {"frame_bytes", stats.frame_bytes},
        {"steady_frame",
         {{"allocations", stats.created.allocations},
          {"pipelines", stats.created.pipelines},
          {"buffers", stats.created.buffers},
          {"images", stats.created.images},
          {"descriptor_pools", stats.created.descriptor_pools}}},
        {"light_pixel_pairs", {{"evaluated", stats.pairs_evaluated}, {"contributing", stats.pairs_contributing}}},
    };
    if (stats.shadows)
        entry["shadows"] = shadows_json(*stats.shadows);
    if (stats.light_buffer)
        entry["light_buffer"] = {{"diffuse_scale", stats.light_buffer->diffuse_scale},
                                 {"specular_scale", stats.light_buffer->specular_scale},
                                 {"clipped_pixels", stats.light_buffer->clipped_pixels}};
    if (stats.inferred)
        entry["inferred"] = {{"layers", stats.inferred->layers},
                             {"layers_without_slot", stats.inferred->layers_without_slot},
                             {"unmatched_pixels", stats.inferred->unmatched_pixels}};
    if (stats.layers)
        entry["layers"] = {{"most", stats.layers->most},
                           {"mean", stats.layers->mean},
                           {"exact", stats.layers->exact},
                           {"approximate", stats.layers->approximate}};
    entry["notes"] = stats.notes;
    return entry;
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string stats_json(const RenderCommand& command, const Stats& stats, const StartUp& start_up,
                       const std::vector<std::string>& warnings) {
    Json entry = stats_entry(command.scene, command.renderer, command.options, stats);
    entry["start_up_ms"] = {{"device", start_up.device}, {"scene", start_up.scene},     {"world", start_up.world},
                            {"frames", start_up.frames}, {"picture", start_up.picture}, {"total", start_up.total()}};
    entry["warnings"] = warnings;
    return json_text(entry);
}

} // namespace prelight::app
