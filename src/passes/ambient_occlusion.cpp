#include "ambient_occlusion.hpp"
#include "fullscreen.hpp"
#include <bit>

namespace prelight::passes {
namespace {

class Occlusion {
public:
    Occlusion(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
              const OcclusionOptions& options)
        : graph_(graph), view_(view), surface_(surface), raster_(graph.raster(surface.depth)),
          constants_(surface.format.constants()) {
        if (options.half)
            raster_.extent = {(raster_.extent.width + 1) / 2, (raster_.extent.height + 1) / 2};
        constants_.insert(constants_.end(), {{CONSTANT_OCCLUSION_RADIUS, std::bit_cast<uint32_t>(options.radius)},
                                             {CONSTANT_OCCLUSION_SCALE, options.half ? 2u : 1u}});
    }

    /// Visibility and depth, noisy.
    graph::ImageId search() {
        const graph::ImageId out = image("occlusion");
        graph::Pass& pass = graph_.pass("occlusion search");
        pass.colour(out, graph::Load::discard)
            .raster(graph_.raster(surface_.depth)) // pixels are the surface's, here and below
            .sample(INPUT_DEPTH, surface_.depth_source)
            .sample(INPUT_NORMAL, surface_.normal);
        draw_fullscreen(pass, view_, "occlusion_search.frag", constants_);
        return out;
    }

    graph::ImageId blur(graph::ImageId noisy, uint32_t axis) {
        const graph::ImageId out = image(axis == 0 ? "occlusion, rows" : "occlusion, columns");
        graph::Pass& pass = graph_.pass(axis == 0 ? "occlusion rows" : "occlusion columns");
        pass.colour(out, graph::Load::discard).raster(graph_.raster(surface_.depth)).sample(INPUT_OCCLUSION, noisy);
        gpu::Constants constants = constants_;
        constants.emplace_back(CONSTANT_OCCLUSION_AXIS, axis);
        draw_fullscreen(pass, view_, "occlusion_blur.frag", constants);
        return out;
    }

    graph::ImageId upsample(graph::ImageId half) {
        const graph::ImageId out = graph_.image("visibility", {VK_FORMAT_R8_UNORM, graph_.raster(surface_.depth)});
        graph::Pass& pass = graph_.pass("occlusion upsample");
        pass.colour(out, graph::Load::discard)
            .sample(INPUT_DEPTH, surface_.depth_source)
            .sample(INPUT_NORMAL, surface_.normal)
            .sample(INPUT_OCCLUSION, half);
        draw_fullscreen(pass, view_, "occlusion_upsample.frag", constants_);
        return out;
    }

private:
    /// Depth needs more than half floats: a plane's slope is a difference of it.
    graph::ImageId image(const char* name) { return graph_.image(name, {VK_FORMAT_R32G32_SFLOAT, raster_}); }
    graph::FrameGraph& graph_;
    const resident::View& view_;
    const SurfaceBuffers& surface_;
    gpu::Raster raster_;
    gpu::Constants constants_;
};

} // namespace

graph::ImageId ambient_occlusion_passes(graph::FrameGraph& graph, const resident::View& view,
                                        const SurfaceBuffers& surface, const OcclusionOptions& options) {
    Occlusion occlusion(graph, view, surface, options);
    const graph::ImageId visibility = occlusion.blur(occlusion.blur(occlusion.search(), 0), 1);
    return options.half ? occlusion.upsample(visibility) : visibility;
}

} // namespace prelight::passes
