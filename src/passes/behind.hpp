#pragma once
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// The picture behind transmissive surfaces, sharp and ever more blurred.
struct Behind {
    graph::ImageId image;    ///< RGBA16F, all levels as shared/behind.h places them
    uint32_t last_level = 0; ///< the one of a single texel
};

/// Passes "behind 0", which copies `linear` (scene-linear, one sample a pixel), and "behind 1" … that make each level
/// of the one before. Throws Error where the device holds no image of all levels: 1.5 times as many texels as the
/// picture.
Behind behind_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear);

} // namespace prelight::passes
