#include "draw_settings.hpp"
#include <fmt/format.h>

namespace prelight {

namespace {

void resolve_trimming(Settings& settings, const gpu::Context& context) {
    // A software device's vertices and triangles cost the host more than the test does; a GPU's do not.
    const char* const best = context.is_software() ? "host" : "off";
    if (settings.is("index-trimming", "auto"))
        settings.resolve("index-trimming", best);
    if (context.features().first_instance_indirect)
        return;
    if (settings.is("index-trimming", "device")) {
        settings.resolve("index-trimming", best);
        settings.note(fmt::format("index-trimming=device: {} has no first instance in indirect draws, {} is taken",
                                  context.name(), best));
    }
    if (settings.all().contains("material-trimming") && settings.is("material-trimming", "depth")) {
        settings.resolve("material-trimming", "off");
        settings.note(
            fmt::format("material-trimming=depth: {} has no first instance in indirect draws", context.name()));
    }
}

} // namespace

std::vector<SettingInfo> draw_settings(bool twice) {
    std::vector<SettingInfo> all{
        {"draws",
         {"direct", "instanced", "indirect"},
         "indirect",
         "one draw an object; objects of the same mesh and material in one; the same from a buffer"},
        {"frustum-culling", {"on", "off"}, "on", "objects off screen are not drawn"},
        {"index-trimming",
         {"auto", "off", "host", "device"},
         "auto",
         "triangles that face away, lie off screen or cover no sample are left out, by the host or in a compute pass"}};
    if (twice) {
        all.push_back({"occlusion",
                       {"off", "queries"},
                       "off",
                       "queries: objects of which the first pass left no pixel are not drawn again"});
        all.push_back({"material-trimming",
                       {"off", "depth"},
                       "off",
                       "depth: nor are triangles of a few pixels that lie behind what the first pass left"});
    }
    return all;
}

SettingInfo specular_antialiasing_setting() {
    return {"specular-antialiasing",
            {"off", "on"},
            "on",
            "on: lamps see a rougher surface where normals differ under a pixel, so that highlights do not sparkle"};
}

void resolve_draw_settings(Settings& settings, const gpu::Context& context) {
    if (!settings.all().contains("draws"))
        return;
    resolve_trimming(settings, context);
    if (settings.is("draws", "indirect") && !context.features().first_instance_indirect) {
        settings.resolve("draws", "instanced");
        settings.note(fmt::format("draws=indirect: {} has no first instance in indirect draws, instanced is taken",
                                  context.name()));
    }
    if (settings.all().contains("occlusion") && settings.is("occlusion", "queries") &&
        !context.features().conditional_rendering) {
        settings.resolve("occlusion", "off");
        settings.note(
            fmt::format("occlusion=queries: {} has no VK_EXT_conditional_rendering, off is taken", context.name()));
    }
}

resident::DrawOptions draw_options(const Settings& settings) {
    if (!settings.all().contains("draws"))
        return {};
    using resident::IndexTrimming;
    const bool twice = settings.all().contains("occlusion");
    return {.frustum_culling = settings.is("frustum-culling", "on"),
            .instanced = !settings.is("draws", "direct"),
            .indirect = settings.is("draws", "indirect"),
            .trimming = settings.is("index-trimming", "host")     ? IndexTrimming::host
                        : settings.is("index-trimming", "device") ? IndexTrimming::device
                                                                  : IndexTrimming::off,
            .counts_pixels = twice && settings.is("occlusion", "queries"),
            .trims_by_depth = twice && settings.is("material-trimming", "depth")};
}

} // namespace prelight
