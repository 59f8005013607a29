#include "post_filter.hpp"
#include <passes/edge_blur.hpp>

namespace prelight {

PostFilter::PostFilter(const Settings& settings, const gpu::Context& context) : kind_(antialiasing(settings)) {
    if (kind_ == Antialiasing::smaa)
        smaa_.emplace(context);
}

graph::ImageId PostFilter::add(graph::FrameGraph& graph, const resident::View& view,
                               const passes::SurfaceBuffers& surface, graph::ImageId picture) const {
    switch (kind_) {
    case Antialiasing::edge_blur: return passes::edge_blur_pass(graph, view, surface, picture);
    case Antialiasing::smaa: return smaa_->add(graph, view, surface, picture);
    default: return picture;
    }
}

} // namespace prelight
