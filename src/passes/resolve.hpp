#pragma once
#include "tonemap.hpp"

namespace prelight::passes {

/// The mean of each pixel's samples as light: of a picture that is scene-linear, or finished. An image with one sample
/// a pixel stays as it is.
graph::ImageId resolve_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId image);

/// The finished picture of a scene-linear image with several samples a pixel: the mean of its tone-mapped samples.
graph::ImageId resolve_tonemapped_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear,
                                       Tonemap curve);

} // namespace prelight::passes
