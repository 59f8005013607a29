#include "light_culling_settings.hpp"
#include <gpu/context.hpp>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using passes::ListContents;
using passes::ListShading;
using resident::DepthBounds;
using resident::LightCulling;

constexpr Choice<LightCulling> culling_words[] = {
    {"volumes", LightCulling::volumes},       {"fullscreen", LightCulling::fullscreen},
    {"rectangles", LightCulling::rectangles}, {"stencil", LightCulling::stencil},
    {"tiles", LightCulling::tiles},           {"clusters", LightCulling::clusters}};
constexpr ChoiceSetting<LightCulling> culling_setting{
    "light-culling", culling_words, "auto",
    "how a light finds its pixels; auto: tiles where the device can build lists, else volumes", true};

constexpr Choice<ListShading> list_shading_words[] = {
    {"auto", ListShading::automatic}, {"fragment", ListShading::fragment}, {"compute", ListShading::compute}};
constexpr ChoiceSetting<ListShading> list_shading_setting{
    "list-shading", list_shading_words, "auto",
    "tiles: walk lists in a full-screen draw, or in a compute pass; auto: compute on software devices"};

constexpr Choice<ListContents> list_contents_words[] = {
    {"built", ListContents::built}, {"perfect", ListContents::perfect}, {"empty", ListContents::empty}};
constexpr ChoiceSetting<ListContents> list_contents_setting{
    "light-lists", list_contents_words, "built",
    "tiles, for measuring only: lists of contributing lights alone (a slow pass makes them), or no lights"};

constexpr Choice<bool> spot_volume_words[] = {{"cone", false}, {"box", true}};
constexpr ChoiceSetting<bool> spot_volume_setting{"spot-volume", spot_volume_words, "cone",
                                                  "volumes, stencil: shape around a spot of less than 80°"};

constexpr Choice<DepthBounds> depth_bounds_words[] = {
    {"auto", DepthBounds::automatic}, {"on", DepthBounds::on}, {"off", DepthBounds::off}};
constexpr ChoiceSetting<DepthBounds> depth_bounds_setting{
    "depth-bounds", depth_bounds_words, "auto",
    "rectangles: test near and far side, a draw a light; auto: not on software devices"};

} // namespace

std::vector<SettingInfo> light_culling_settings() {
    return {culling_setting.info(),
            {"tile-size", {"8", "16", "32"}, "8", "pixels of a tile's side (light-culling=tiles, clusters)"},
            list_shading_setting.info(),
            list_contents_setting.info()};
}

std::vector<SettingInfo> volume_settings() {
    return {spot_volume_setting.info(),
            {"volume-depth-test", {"on", "off"}, "on", "volumes: off leaves only the cull mode by camera position"},
            depth_bounds_setting.info()};
}

void choose_light_culling(Settings& settings, const Device& device) {
    const bool measures = !settings.is("light-lists", "built");
    if (!settings.is("light-culling", "auto")) {
        if (measures && !settings.is("light-culling", "tiles"))
            throw UsageError("--set light-lists=" + settings.get("light-lists") + ": is for light-culling=tiles, not " +
                             settings.get("light-culling"));
        return;
    }
    const bool lists = dynamic_cast<const gpu::Context&>(device).features().shuffle_lanes > 0;
    const bool blended = settings.has("light-writes") && settings.is("light-writes", "blended");
    settings.resolve(culling_setting, lists && !blended ? LightCulling::tiles : LightCulling::volumes,
                     blended ? "light-writes=blended draws light by light"
                     : lists ? "the device can build light lists"
                             : "light lists need shuffles within subgroups of at most 64");
}

LightCulling light_culling(const Settings& settings) { return settings.value(culling_setting); }

passes::ScreenListOptions screen_list_options(const Settings& settings) {
    return {.tile_size = static_cast<uint32_t>(settings.number("tile-size")),
            .shading = settings.value(list_shading_setting),
            .contents = settings.value(list_contents_setting)};
}

resident::VolumeOptions volume_options(const Settings& settings) {
    return {.spot_boxes = settings.value(spot_volume_setting),
            .depth_test = settings.is("volume-depth-test", "on"),
            .depth_bounds = settings.value(depth_bounds_setting)};
}

} // namespace prelight
