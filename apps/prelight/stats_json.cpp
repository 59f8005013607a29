#include "stats_json.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const Spread& spread) {
    return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

} // namespace

std::string stats_json(const RenderCommand& command, const Stats& stats) {
    const RenderOptions& options = command.options;
    Json passes = Json::array();
    // A pass's own CPU time would need it submitted alone: no figure here, rather than a wrong one.
    for (const PassStats& pass : stats.passes)
        passes.push_back(
            {{"name", pass.name}, {"gpu_ms", spread_json(pass.gpu_ms)}, {"cpu_ms", nullptr}});
    const Json json = {
        {"device", stats.device},
        {"driver", stats.driver},
        {"scene", command.scene},
        {"renderer", command.renderer},
        {"preset", options.preset.empty() ? Json(nullptr) : Json(options.preset)},
        {"settings", Json(stats.settings)},
        {"size", {options.width, options.height}},
        {"msaa", options.msaa},
        {"shading", options.shading == Shading::ggx ? "ggx" : "phong"},
        {"lights", stats.lights},
        {"triangles", stats.triangles},
        {"draws", stats.draws},
        {"frames", stats.frames},
        {"wall_ms", spread_json(stats.wall_ms)},
        {"cpu_ms", spread_json(stats.cpu_ms)},
        {"gpu_ms", spread_json(stats.gpu_ms)},
        {"passes", passes},
        {"attachment_bytes", stats.attachment_bytes},
        {"device_bytes", stats.device_bytes},
        {"light_pixel_pairs",
         {{"evaluated", stats.pairs_evaluated}, {"contributing", stats.pairs_contributing}}},
    };
    // A file name may hold any bytes; JSON holds UTF-8 only.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace prelight::app
