#include "meter.hpp"

#include "renderer_info.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/exposure.hpp>

namespace prelight::app {
namespace {

constexpr uint32_t longest_side = 256;
/// Of a picture. Behind most scenes with lights of their own it is black.
constexpr double too_burnt = 0.25, too_black = 0.9;

/// The command's settings that say what light there is, as far as this renderer has them.
std::map<std::string, std::string> settings_of_light(const RendererInfo& info, const RenderOptions& options) {
    std::map<std::string, std::string> settings;
    for (const char* key : {"shadows", "ssao", "ssao-radius", "ambient-occlusion", "ambient-occlusion-radius"})
        if (const auto given = options.settings.find(key);
            given != options.settings.end() &&
            std::ranges::find(info.settings, key, &SettingInfo::key) != info.settings.end())
            settings[key] = given->second;
    return settings;
}

} // namespace

double meter_exposure(Device* device, const World& world, const PlacedCamera& camera, const RenderOptions& options) {
    const std::string name = device ? "light-prepass" : "reference";
    const double scale = std::min(1.0, double(longest_side) / std::max(options.width, options.height));
    const auto side = [&](uint32_t pixels) { return std::max(uint32_t(std::lround(pixels * scale)), 1u); };
    RenderOptions small{.width = side(options.width),
                        .height = side(options.height),
                        .shading = options.shading,
                        .preset = {},
                        .settings = settings_of_light(find_renderer(name), options),
                        .views = {"depth", "linear"}};
    // A half float holds forty stops: what is far off is metered again, nearer to its middle, and what is black once
    // more with more light.
    bool lit = false;
    for (int tries = 0; tries < 4; ++tries) {
        const auto renderer = create_renderer(name, device, small);
        renderer->set_world(world);
        renderer->render(camera);
        const Image depth = renderer->read("depth");
        std::vector<bool> surface;
        for (const glm::vec3& p : depth.pixels)
            surface.push_back(p.r > 0);
        const std::optional<double> more = auto_exposure(renderer->read("linear"), surface);
        lit |= more.has_value();
        small.exposure = std::clamp(small.exposure + more.value_or(24), -64.0, 64.0);
        if (more && std::abs(*more) < 8)
            break;
        if (!lit && tries == 1)
            return 0; // nothing shines
    }
    return small.exposure;
}

void print_exposure(double ev) { tell(fmt::format("exposure: auto is --exposure {:.1f}", ev)); }

void warn_of_extremes(const Log& log, const Image& display, const std::string& file, const World& world,
                      bool auto_exposure) {
    if (world.triangles == 0)
        return;
    const Extremes extremes = find_extremes(display);
    const auto percent = [](double share) { return std::lround(100 * share); };
    if (extremes.burnt > too_burnt)
        log.warning(fmt::format("{}: {} % of the pixels are burnt out: {}", file, percent(extremes.burnt),
                                auto_exposure ? "try a lower --exposure than auto's" : "try --exposure auto"));
    else if (extremes.black > too_black)
        log.warning(fmt::format("{}: {} % of the pixels are black: {}{}", file, percent(extremes.black),
                                world.scene->environment ? "try --background backdrop" : "try --environment studio",
                                auto_exposure ? "" : ", or --exposure auto"));
}

} // namespace prelight::app
