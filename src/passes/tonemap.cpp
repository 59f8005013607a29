#include "tonemap.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

graph::ImageId tonemap_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                            graph::ImageId colour, Tonemap curve) {
    const graph::ImageId target = graph.image("final", {VK_FORMAT_R8G8B8A8_UNORM, frame.extent()});
    graph::Pass& pass = graph.pass("tonemap");
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, colour);
    draw_fullscreen(pass, frame, "tonemap.frag", {{CONSTANT_TONEMAP, static_cast<uint32_t>(curve)}});
    return target;
}

} // namespace prelight::passes
