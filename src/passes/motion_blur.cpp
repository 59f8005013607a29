#include "motion_blur.hpp"
#include "fullscreen.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

graph::ImageId motion_blur_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                                graph::ImageId linear) {
    const gpu::Constants constants = gbuffer.surface.format.constants();
    const gpu::Raster picture = graph.raster(linear);
    const auto tiles = [](uint32_t size) { return (size + MOTION_TILE - 1) / MOTION_TILE; };
    const graph::ImageDesc small{VK_FORMAT_R16G16_SFLOAT,
                                 {{tiles(picture.extent.width), tiles(picture.extent.height)}}};

    const graph::ImageId longest = graph.image("longest motion", small);
    graph::Pass& find = graph.pass("motion tiles");
    find.colour(longest, graph::Load::discard)
        .raster(picture)
        .sample(INPUT_DEPTH, gbuffer.surface.depth_source)
        .sample(INPUT_MATERIAL, gbuffer.motion);
    draw_fullscreen(find, view, "motion_tiles.frag", constants);

    const graph::ImageId around = graph.image("longest motion around", small);
    graph::Pass& spread = graph.pass("motion neighbours");
    spread.colour(around, graph::Load::discard).sample(INPUT_MOTION_TILES, longest);
    draw_fullscreen(spread, view, "motion_neighbours.frag", {});

    const graph::ImageId blurred = graph.image("blurred", graph.desc(linear));
    graph::Pass& blur = graph.pass("motion blur");
    blur.colour(blurred, graph::Load::discard)
        .sample(INPUT_DEPTH, gbuffer.surface.depth_source)
        .sample(INPUT_MATERIAL, gbuffer.motion)
        .sample(INPUT_MOTION_TILES, around)
        .sample(INPUT_COLOUR_BEFORE, linear);
    draw_fullscreen(blur, view, "motion_blur.frag", constants);
    return blurred;
}

} // namespace prelight::passes
