#include "shadow_settings.hpp"

namespace prelight {

std::vector<SettingInfo> shadow_settings() {
    return {{"shadows", {"off", "on"}, "off", "shadow maps of every light that casts a shadow"},
            {"shadow-filter", {"hard", "pcf", "contact"}, "pcf",
             "one texel; a disc of 1.5 texels; a disc as wide as the light and its distance make the penumbra"},
            {"shadow-budget", {"1 … 268435456"}, "16777216",
             "texels of all shadow maps (4 bytes each), rounded down to a power of two; shared by size on the screen"},
            {"shadow-detail", {"0.01 … 16"}, "2", "texels that a light asks for a pixel; the budget goes before"},
            {"shadow-cache", {"on", "off"}, "on", "off: maps are drawn every frame, for measuring"}};
}

resident::ShadowOptions shadow_options(const Settings& settings) {
    if (!settings.all().contains("shadows"))
        return {};
    using resident::ShadowFilter;
    return {.on = settings.is("shadows", "on"),
            .filter = settings.is("shadow-filter", "hard")  ? ShadowFilter::hard
                      : settings.is("shadow-filter", "pcf") ? ShadowFilter::pcf
                                                            : ShadowFilter::contact,
            .budget = static_cast<uint64_t>(settings.number("shadow-budget")),
            .detail = settings.number("shadow-detail"),
            .cached = settings.is("shadow-cache", "on")};
}

} // namespace prelight
