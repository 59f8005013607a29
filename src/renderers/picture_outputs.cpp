// From what an architecture has shaded to the picture: what lies behind it, what is blended over it, and the display.
#include "device_renderer.hpp"
#include <passes/background.hpp>
#include <passes/resolve.hpp>
#include <passes/view.hpp>
#include <prelight/views.hpp>

namespace prelight {

DeviceRenderer::Outputs DeviceRenderer::linear_outputs(graph::FrameGraph& graph, const resident::View& view,
                                                       graph::ImageId linear, const passes::SurfaceBuffers& surface,
                                                       const std::function<graph::ImageId(graph::ImageId)>& filter) {
    passes::background_pass(graph, view, linear, surface.depth, {});
    own_passes(vulkan::Stage::after_opaque, graph, view, surface, {{"picture", linear}});
    passes::ForwardInputs over{
        .name = {}, .depth = surface.depth, .colour = linear, .kinds = {}, .plan = {}, .model = {}};
    over.shadows = shadows(graph, view);
    over.pair_counters = &pair_counters();
    over.count_pairs = options_.count_pairs;
    const std::optional<graph::ImageId> layers =
        blended_.add(graph, view, std::move(over), world_lists(), settings_,
                     view.scene().blends() ? layer_light(graph, view) : LayerLight{}, wants("layers"));
    Outputs outputs;
    add_picture_samples(outputs, graph, view, linear, options_.tonemap);
    auto which = blended_.in_half_samples() ? passes::Resolved::halves : passes::Resolved::all;
    if (filter) {
        linear = filter(passes::resolve_pass(graph, view, linear, which));
        which = passes::Resolved::all;
    }
    own_passes(vulkan::Stage::before_display, graph, view, surface, {{"picture", linear}});
    const bool one = graph.raster(linear).samples == 1;
    const graph::ImageId picture = one ? passes::tonemap_pass(graph, view, linear, options_.tonemap)
                                       : passes::resolve_tonemapped_pass(graph, view, linear, options_.tonemap, which);
    outputs["final"] = post_filter_.add(graph, view, surface, picture);
    own_passes(vulkan::Stage::after_display, graph, view, surface, {{"picture", outputs["final"]}});
    add_layers_views(outputs, graph, view, surface, layers);
    if (wants("linear"))
        outputs["linear"] = passes::resolve_pass(graph, view, linear, which);
    return outputs;
}

DeviceRenderer::Outputs DeviceRenderer::picture_outputs(graph::FrameGraph& graph, const resident::View& view,
                                                        const passes::SurfaceBuffers& surface,
                                                        const std::function<graph::ImageId(passes::Display)>& draw) {
    if (wants("linear") || view.scene().shows_through() || own_passes_.any_linear())
        return linear_outputs(graph, view, draw({}), surface);
    const graph::ImageId picture = draw(options_.tonemap);
    passes::background_pass(graph, view, picture, surface.depth, options_.tonemap);
    Outputs outputs{{"final", post_filter_.add(graph, view, surface, passes::resolve_pass(graph, view, picture))}};
    own_passes(vulkan::Stage::after_display, graph, view, surface, {{"picture", outputs["final"]}});
    add_layers_views(outputs, graph, view, surface, {});
    add_picture_samples(outputs, graph, view, picture, {});
    return outputs;
}

void DeviceRenderer::add_picture_samples(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                         graph::ImageId picture, passes::Display curve) const {
    for (const std::string& name : options_.views)
        if (const auto one = sample_of_view(name); one && one->buffer == "final") {
            const passes::Resolved alone = passes::only_sample(one->sample);
            outputs[name] = curve ? passes::resolve_tonemapped_pass(graph, view, picture, *curve, alone)
                                  : passes::resolve_pass(graph, view, picture, alone);
        }
}

void DeviceRenderer::add_surface_samples(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                         const passes::SurfaceBuffers& surface) const {
    using passes::ViewKind;
    for (const std::string& name : options_.views)
        if (const auto one = sample_of_view(name); one && one->buffer != "final") {
            const bool depth = one->buffer == "depth";
            outputs[name] = passes::view_pass(graph, view, name, depth ? ViewKind::depth : ViewKind::normal, surface,
                                              depth ? surface.depth_source : surface.normal, one->sample);
        }
}

void DeviceRenderer::add_layers_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                                      const passes::SurfaceBuffers& surface,
                                      const std::optional<graph::ImageId>& layers) const {
    if (wants("layers"))
        outputs["layers"] = passes::layers_view_pass(graph, view, surface, layers);
    const std::map<uint32_t, graph::ImageId>& shown = blended_.shown_layers();
    for (const std::string& name : options_.views) {
        const auto number = layer_of_view(name);
        if (!number)
            continue;
        const auto one = shown.find(*number);
        outputs[name] = one == shown.end() ? passes::black_view_pass(graph, view, name)
                        : graph.raster(one->second).samples > 1
                            ? passes::resolve_tonemapped_pass(graph, view, one->second, options_.tonemap)
                            : passes::tonemap_pass(graph, view, one->second, options_.tonemap);
    }
}

} // namespace prelight
