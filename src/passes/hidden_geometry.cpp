#include "hidden_geometry.hpp"
#include "index_trimming.hpp"

namespace prelight::passes {

void hidden_geometry_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth) {
    if (const resident::VisiblePixels* pixels = view.visible_pixels()) {
        graph.pass("geometry visible-pixels")
            .copy_to(graph.buffer("draw conditions", pixels->conditions()))
            .copy_to(graph.buffer("visible pixels", pixels->host_counts()))
            .record([pixels, &view](const graph::PassContext& context) {
                pixels->copy(context.commands, context.slot, static_cast<uint32_t>(view.visible().batches.size()));
            });
    }
    depth_trimming_passes(graph, view, depth);
}

} // namespace prelight::passes
