#include "draw_settings.hpp"
#include <fmt/format.h>

namespace prelight {

std::vector<SettingInfo> draw_settings() {
    return {{"draws", {"direct", "instanced", "indirect"}, "indirect",
             "one draw an object; objects of the same mesh and material in one; the same from a buffer"},
            {"frustum-culling", {"on", "off"}, "on", "objects off screen are not drawn"},
            {"index-trimming", {"auto", "off", "host"}, "auto",
             "triangles that face away, lie off screen or cover no sample are left out, by the host"}};
}

void resolve_draw_settings(Settings& settings, const gpu::Context& context) {
    if (!settings.all().contains("draws"))
        return;
    // A software device's vertices and triangles cost the host more than the test does; a GPU's do not.
    if (settings.is("index-trimming", "auto"))
        settings.resolve("index-trimming", context.is_software() ? "host" : "off");
    if (settings.is("draws", "indirect") && !context.features().first_instance_indirect) {
        settings.resolve("draws", "instanced");
        settings.note(fmt::format("draws=indirect: {} has no first instance in indirect draws, instanced is taken",
                                  context.name()));
    }
}

resident::DrawOptions draw_options(const Settings& settings) {
    if (!settings.all().contains("draws"))
        return {};
    return {.frustum_culling = settings.is("frustum-culling", "on"),
            .instanced = !settings.is("draws", "direct"),
            .indirect = settings.is("draws", "indirect"),
            .trimming = settings.is("index-trimming", "host") ? resident::IndexTrimming::host
                                                              : resident::IndexTrimming::off};
}

} // namespace prelight
