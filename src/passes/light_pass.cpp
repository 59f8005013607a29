#include "light_pass.hpp"
#include "light_list_shading.hpp"
#include "light_loop.hpp"
#include "light_overlap.hpp"
#include "light_rectangles.hpp"
#include "light_rounds.hpp"
#include "light_stencil.hpp"
#include "light_volumes.hpp"

namespace prelight::passes {

void light_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                const LightingInputs& inputs) {
    if (inputs.write_once && view.culling() == resident::LightCulling::fullscreen)
        return light_loop_pass(graph, view, name, inputs);
    switch (view.culling()) {
    case resident::LightCulling::fullscreen:
    case resident::LightCulling::volumes: return light_volume_pass(graph, view, name, inputs);
    case resident::LightCulling::rectangles: return light_rectangle_pass(graph, view, name, inputs);
    case resident::LightCulling::stencil: return light_stencil_pass(graph, view, name, inputs);
    case resident::LightCulling::tiles:
    case resident::LightCulling::clusters: return light_list_pass(graph, view, name, inputs);
    case resident::LightCulling::grid: break; // forward only
    }
}

graph::ImageId light_count_pass(graph::FrameGraph& graph, const resident::View& view, LightingInputs inputs) {
    inputs.target = make_light_counts(graph, view, inputs.lists && inputs.lists->walk == LightWalk::compute);
    inputs.count_pairs = false;
    light_pass(graph, view, "light-count", inputs);
    return inputs.target.images[0];
}

uint32_t light_adds(const resident::View& view, bool one_by_one) {
    if (!resident::builds_lists(view.culling()) && one_by_one)
        return light_overlap(view.scene().geometry().draws, view.lights().placed());
    const LightWalk walk = view.culling() == resident::LightCulling::tiles ? LightWalk::compute : LightWalk::fragment;
    const uint32_t rounds = light_rounds(view, walk).count;
    return rounds > 1 ? rounds : 0;
}

SettingInfo light_culling_setting() {
    return {"light-culling",
            {"auto", "volumes", "fullscreen", "rectangles", "stencil", "tiles", "clusters"},
            "auto",
            "how a light finds its pixels; auto: tiles where the device can build lists, else volumes"};
}

resident::LightCulling light_culling(const std::string& value) {
    using resident::LightCulling;
    return value == "fullscreen"   ? LightCulling::fullscreen
           : value == "rectangles" ? LightCulling::rectangles
           : value == "stencil"    ? LightCulling::stencil
           : value == "tiles"      ? LightCulling::tiles
           : value == "clusters"   ? LightCulling::clusters
                                   : LightCulling::volumes;
}

SettingInfo tile_size_setting() {
    return {"tile-size", {"8", "16", "32"}, "8", "pixels of a tile's side (light-culling=tiles, clusters)"};
}

SettingInfo list_shading_setting() {
    return {"list-shading",
            {"auto", "fragment", "compute"},
            "auto",
            "tiles: walk lists in a full-screen draw, or in a compute pass; auto: compute on software devices"};
}

SettingInfo list_contents_setting() {
    return {"light-lists",
            {"built", "perfect", "empty"},
            "built",
            "tiles, for measuring only: lists of contributing lights alone (a slow pass makes them), or no lights"};
}

ScreenListOptions screen_list_options(const std::map<std::string, std::string>& settings) {
    const std::string &shading = settings.at("list-shading"), &contents = settings.at("light-lists");
    return {.tile_size = static_cast<uint32_t>(std::stoul(settings.at("tile-size"))),
            .shading = shading == "fragment"  ? ListShading::fragment
                       : shading == "compute" ? ListShading::compute
                                              : ListShading::automatic,
            .contents = contents == "perfect" ? ListContents::perfect
                        : contents == "empty" ? ListContents::empty
                                              : ListContents::built};
}

std::vector<SettingInfo> volume_settings() {
    return {{"spot-volume", {"cone", "box"}, "cone", "volumes, stencil: shape around a spot of less than 80°"},
            {"volume-depth-test", {"on", "off"}, "on", "volumes: off leaves only the cull mode by camera position"},
            {"depth-bounds",
             {"auto", "on", "off"},
             "auto",
             "rectangles: test near and far side, a draw a light; auto: not on software devices"}};
}

resident::VolumeOptions volume_options(const std::map<std::string, std::string>& settings) {
    using resident::DepthBounds;
    const std::string& bounds = settings.at("depth-bounds");
    return {.spot_boxes = settings.at("spot-volume") == "box",
            .depth_test = settings.at("volume-depth-test") == "on",
            .depth_bounds = bounds == "auto" ? DepthBounds::automatic
                            : bounds == "on" ? DepthBounds::on
                                             : DepthBounds::off};
}

} // namespace prelight::passes
