#include "draw_settings.hpp"
#include <fmt/format.h>

namespace prelight {

namespace {

using resident::IndexTrimming;

constexpr Choice<IndexTrimming> trimming_words[] = {
    {"off", IndexTrimming::off}, {"host", IndexTrimming::host}, {"device", IndexTrimming::device}};
constexpr ChoiceSetting<IndexTrimming> trimming_setting{
    "index-trimming", trimming_words, "auto",
    "triangles that face away, lie off screen or cover no sample are left out, by the host or in a compute pass", true};

void resolve_trimming(Settings& settings, const gpu::Context& context) {
    // A software device's vertices and triangles cost the host more than the test does; a GPU's do not.
    const IndexTrimming best = context.is_software() ? IndexTrimming::host : IndexTrimming::off;
    if (settings.is("index-trimming", "auto"))
        settings.resolve(trimming_setting, best);
    if (context.features().first_instance_indirect)
        return;
    if (settings.value(trimming_setting) == IndexTrimming::device) {
        settings.resolve(trimming_setting, best);
        settings.note(fmt::format("index-trimming=device: {} has no first instance in indirect draws, {} is taken",
                                  context.name(), trimming_setting.word(best)));
    }
    if (settings.has("material-trimming") && settings.is("material-trimming", "depth")) {
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
        trimming_setting.info()};
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
            "on: lights see a rougher surface where normals differ under a pixel, so that highlights do not sparkle"};
}

void resolve_draw_settings(Settings& settings, const gpu::Context& context) {
    if (!settings.has("draws"))
        return;
    resolve_trimming(settings, context);
    if (settings.is("draws", "indirect") && !context.features().first_instance_indirect) {
        settings.resolve("draws", "instanced");
        settings.note(fmt::format("draws=indirect: {} has no first instance in indirect draws, instanced is taken",
                                  context.name()));
    }
    if (settings.has("occlusion") && settings.is("occlusion", "queries") && !context.features().conditional_rendering) {
        settings.resolve("occlusion", "off");
        settings.note(
            fmt::format("occlusion=queries: {} has no VK_EXT_conditional_rendering, off is taken", context.name()));
    }
}

resident::DrawOptions draw_options(const Settings& settings) {
    if (!settings.has("draws"))
        return {};
    const bool twice = settings.has("occlusion");
    return {.frustum_culling = settings.is("frustum-culling", "on"),
            .instanced = !settings.is("draws", "direct"),
            .indirect = settings.is("draws", "indirect"),
            .trimming = settings.value(trimming_setting),
            .counts_pixels = twice && settings.is("occlusion", "queries"),
            .trims_by_depth = twice && settings.is("material-trimming", "depth")};
}

} // namespace prelight
