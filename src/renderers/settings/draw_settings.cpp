#include "draw_settings.hpp"

namespace prelight {

namespace {

using resident::IndexTrimming;

constexpr Choice<IndexTrimming> trimming_words[] = {
    {"off", IndexTrimming::off}, {"host", IndexTrimming::host}, {"device", IndexTrimming::device}};
constexpr ChoiceSetting<IndexTrimming> trimming_setting{
    "index-trimming", trimming_words, "auto",
    "triangles that face away, lie off screen or cover no sample are left out, by the host or in a compute pass", true};

std::string no_first_instance(const gpu::Context& context) {
    return context.name() + " has no first instance in indirect draws";
}

void resolve_trimming(Settings& settings, const gpu::Context& context) {
    // A software device's vertices and triangles cost the host more than the test does; a GPU's do not.
    const IndexTrimming best = context.is_software() ? IndexTrimming::host : IndexTrimming::off;
    if (settings.is("index-trimming", "auto"))
        settings.resolve(trimming_setting, best,
                         context.is_software() ? "a software device's triangles cost more than the host's test"
                                               : "a GPU's triangles cost less than the test");
    if (context.features().first_instance_indirect)
        return;
    if (settings.value(trimming_setting) == IndexTrimming::device)
        settings.fall_back(trimming_setting.key, trimming_setting.word(best), no_first_instance(context));
    if (settings.has("material-trimming") && settings.is("material-trimming", "depth"))
        settings.fall_back("material-trimming", "off", no_first_instance(context));
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
    if (settings.is("draws", "indirect") && !context.features().first_instance_indirect)
        settings.fall_back("draws", "instanced", no_first_instance(context));
    if (settings.has("occlusion") && settings.is("occlusion", "queries") && !context.features().conditional_rendering)
        settings.fall_back("occlusion", "off", context.name() + " has no VK_EXT_conditional_rendering");
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
