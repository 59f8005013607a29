#include "tonemap.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

graph::ImageId picture_image(graph::FrameGraph& graph, const resident::Frame& frame, Display display) {
    return display ? graph.image("final", {VK_FORMAT_R8G8B8A8_UNORM, frame.extent()})
                   : graph.image("linear", {VK_FORMAT_R16G16B16A16_SFLOAT, frame.extent()});
}

gpu::Constants display_constants(Display display) {
    return {{CONSTANT_TONEMAP, display ? static_cast<uint32_t>(*display) : TONEMAP_LINEAR}};
}

graph::ImageId tonemap_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                            graph::ImageId colour, Tonemap curve) {
    const graph::ImageId target = picture_image(graph, frame, curve);
    graph::Pass& pass = graph.pass("tonemap");
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, colour);
    draw_fullscreen(pass, frame, "tonemap.frag", display_constants(curve));
    return target;
}

} // namespace prelight::passes
