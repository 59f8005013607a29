#include "resolve.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// `curve`: of `target`, where that is the finished picture of a scene-linear one.
graph::ImageId resolve(graph::FrameGraph& graph, const resident::View& view, graph::ImageId image,
                       graph::ImageId target, Display curve, Resolved which) {
    const std::string name = which >= Resolved::first
                                 ? "view-sample=" + std::to_string(static_cast<uint32_t>(which) - RESOLVED_SAMPLE)
                             : curve ? "resolve final"
                                     : "resolve " + graph.name(target);
    graph::Pass& pass = graph.pass(name);
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, image);
    gpu::Constants constants = display_constants(curve, graph.desc(target).format);
    constants.insert(constants.end(), {{CONSTANT_SAMPLES, graph.raster(image).samples},
                                       {CONSTANT_STORED_ENCODED, graph.desc(image).format == VK_FORMAT_R8G8B8A8_UNORM},
                                       {CONSTANT_RESOLVED, static_cast<uint32_t>(which)}});
    draw_fullscreen(pass, view, "resolve.frag", constants);
    return target;
}

} // namespace

graph::ImageId resolve_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId image,
                            Resolved which) {
    if (graph.raster(image).samples == 1)
        return image;
    const VkFormat format = graph.desc(image).format;
    return resolve(graph, view, image, graph.image(graph.name(image), {format, view.raster()}), {}, which);
}

graph::ImageId resolve_tonemapped_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear,
                                       Tonemap curve, Resolved which) {
    return resolve(graph, view, linear, picture_image(graph, view, view.raster(), curve), curve, which);
}

} // namespace prelight::passes
