#include "smaa.hpp"
#include "edge_blur.hpp"
#include "fullscreen.hpp"
#include "smaa_tables.hpp"
#include "tonemap.hpp"

namespace prelight::passes {

Smaa::Smaa(const gpu::Context& context) {
    const std::vector<uint32_t> areas = smaa_areas();
    areas_ = gpu::make_device_buffer(context, "smaa areas", std::as_bytes(std::span(areas)),
                                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

graph::ImageId Smaa::add(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                         graph::ImageId picture) const {
    const graph::ImageDesc desc = graph.desc(picture);

    const graph::ImageId edges = graph.image("smaa edges", {VK_FORMAT_R8_UNORM, desc.raster});
    graph::Pass& find = graph.pass("smaa edges");
    find.colour(edges, graph::Load::discard).sample(INPUT_COLOUR_BEFORE, picture);
    draw_fullscreen(find, view, "smaa_edges.frag", read_geometry_edges(find, surface, desc.format));

    const graph::ImageId crossings = graph.image("smaa crossings", {VK_FORMAT_R8_UNORM, desc.raster});
    graph::Pass& gather = graph.pass("smaa crossings");
    gather.colour(crossings, graph::Load::discard).sample(INPUT_SMAA_EDGES, edges);
    draw_fullscreen(gather, view, "smaa_crossings.frag", {});

    const graph::ImageId weights = graph.image("smaa weights", {VK_FORMAT_R8G8B8A8_UNORM, desc.raster});
    graph::Pass& weigh = graph.pass("smaa weights");
    weigh.colour(weights, graph::Load::discard)
        .sample(INPUT_SMAA_EDGES, crossings)
        .storage(INPUT_SMAA_AREAS, graph.buffer("smaa areas", areas_), false);
    draw_fullscreen(weigh, view, "smaa_weights.frag", {});

    const graph::ImageId smooth = graph.image("smaa", desc);
    graph::Pass& blend = graph.pass("smaa blend");
    blend.colour(smooth, graph::Load::discard).sample(INPUT_COLOUR_BEFORE, picture).sample(INPUT_SMAA_WEIGHTS, weights);
    draw_fullscreen(blend, view, "smaa_blend.frag", display_constants({}, desc.format));
    return smooth;
}

} // namespace prelight::passes
