#include "layer_peeler.hpp"
#include "blended.hpp"
#include <shared/bindings.h>
#include <utility>

namespace prelight::passes {

LayerPeeler::LayerPeeler(graph::FrameGraph& graph, const resident::View& view, graph::ImageId opaque, First order)
    : opaque_(opaque), last_(opaque), order_(order) {
    for (graph::ImageId& one : depths_)
        one = graph.image("layer depth", {VK_FORMAT_D32_SFLOAT, view.surface_raster()});
}

graph::ImageId LayerPeeler::next(graph::FrameGraph& graph, const resident::View& view, const std::string& name) {
    graph::Pass& pass = graph.pass(name);
    const bool nearest = order_ == First::nearest;
    pass.depth_write(depths_[0], graph::Load::clear, nearest ? 0 : 1).sample(INPUT_DEPTH, last_);
    if (nearest)
        pass.sample(INPUT_SAMPLE_DEPTH, opaque_);
    const bool samples = view.surface_raster().samples > 1;
    draw_blended(pass, view,
                 {.name = "peel",
                  .fragment = {nearest ? "peel_nearest.frag" : "peel.frag", gpu::when(samples, gpu::Variant::samples)},
                  .constants = {{CONSTANT_FIRST_LAYER, first_}},
                  .depth = nearest ? gpu::DepthTest::write_nearer : gpu::DepthTest::write_farther,
                  .sample_shading = gpu::SampleShading::sample,
                  .positions_only = true,
                  .draws = resident::DrawClass::blended});
    first_ = false;
    last_ = depths_[0];
    std::swap(depths_[0], depths_[1]);
    return last_;
}

} // namespace prelight::passes
