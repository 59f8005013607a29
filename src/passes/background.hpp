#pragma once
#include "tonemap.hpp"

namespace prelight::passes {

/// Draws the world's environment into `target`, a picture that picture_image() made with this `display`, wherever
/// `depth` is still at the far end. Nothing when the world has none, or none to be seen.
void background_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId target, graph::ImageId depth,
                     Display display);

} // namespace prelight::passes
