#include "shadow_settings.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using resident::ShadowFilter;

constexpr Choice<ShadowFilter> filter_words[] = {
    {"hard", ShadowFilter::hard}, {"pcf", ShadowFilter::pcf}, {"contact", ShadowFilter::contact}};
constexpr ChoiceSetting<ShadowFilter> filter_setting{
    "shadow-filter", filter_words, "pcf",
    "one texel; a disc of 1.5 texels; a disc as wide as the light and its distance make the penumbra"};

using resident::TransparentShadows;

constexpr Choice<TransparentShadows> transparent_words[] = {{"opaque", TransparentShadows::opaque},
                                                            {"filtered", TransparentShadows::filtered},
                                                            {"stochastic", TransparentShadows::stochastic},
                                                            {"none", TransparentShadows::none}};
constexpr ChoiceSetting<TransparentShadows> transparent_setting{
    "transparent-shadows", transparent_words, "filtered",
    "shadows of BLEND surfaces: as of opaque ones; less deep by alpha, by a map of what they leave of the light, or "
    "by chance from texel to texel; or none"};

} // namespace

std::vector<SettingInfo> shadow_settings(bool light_by_light) {
    std::vector<SettingInfo> settings{
        {"shadows", {"off", "on"}, "off", "shadow maps of every light that casts a shadow"},
        filter_setting.info(),
        transparent_setting.info(),
        {"shadow-budget",
         {"1 … 268435456"},
         "16777216",
         "texels of all shadow maps (4 bytes each, 2 more with pcf), rounded down to a power of two; shared by size on "
         "the screen"},
        {"shadow-detail", {"0.01 … 16"}, "2", "texels that a light asks for a pixel; the budget goes before"},
        {"shadow-cache", {"on", "off"}, "on", "off: maps are drawn every frame, for measuring"},
        {"shadow-updates",
         {"all", "1 … 65536"},
         "all",
         "so many tiles of maps are drawn in a frame, beside a directional light's; the others wait for their turn"}};
    if (light_by_light)
        settings.push_back({"shadow-memory",
                            {"atlas", "reuse"},
                            "atlas",
                            "maps of all lights at once, or of one light after the other in the same memory"});
    return settings;
}

void choose_shadow_memory(Settings& settings) {
    if (!settings.is("shadows", "on") || !settings.is("shadow-memory", "reuse"))
        return;
    if (settings.is("light-culling", "auto"))
        settings.resolve("light-culling", "volumes", "shadow-memory=reuse draws light by light");
    const bool asked = settings.given("shadow-memory");
    const bool once = settings.has("light-writes") && settings.is("light-writes", "once");
    if (!once && !settings.is("light-culling", "tiles") && !settings.is("light-culling", "clusters"))
        return;
    const std::string reason =
        fmt::format("is for lights that are drawn one by one, not {}",
                    once ? "light-writes=once" : "light-culling=" + settings.get("light-culling"));
    if (asked)
        throw UsageError("--set shadow-memory=reuse: " + reason);
    settings.fall_back("shadow-memory", "atlas", reason); // a preset's gives way
}

resident::ShadowOptions shadow_options(const Settings& settings) {
    if (!settings.has("shadows"))
        return {};
    return {.on = settings.is("shadows", "on"),
            .filter = settings.value(filter_setting),
            .blended = settings.value(transparent_setting),
            .budget = static_cast<uint64_t>(settings.number("shadow-budget")),
            .detail = settings.number("shadow-detail"),
            .reuse = settings.has("shadow-memory") && settings.is("shadow-memory", "reuse"),
            .cached = settings.is("shadow-cache", "on"),
            .updates =
                settings.is("shadow-updates", "all") ? ~0u : static_cast<uint32_t>(settings.number("shadow-updates"))};
}

} // namespace prelight
