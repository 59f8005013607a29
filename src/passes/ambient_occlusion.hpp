#pragma once
#include "depth_normal.hpp"

namespace prelight::passes {

/// How much of ambient light nearby surfaces let through (docs/ssao.md).
struct OcclusionOptions {
    bool on = false;
    bool half = false; ///< searched at half the resolution, and brought to the picture's along edges
    float radius = 1;  ///< metres; what is farther occludes nothing
};

/// Visibility, 1 where all is open and where nothing is, for each pixel: an image that shaders fetch from, its first
/// channel. From the depth and normals of `surface`: `options.on` is the caller's to ask.
graph::ImageId ambient_occlusion_passes(graph::FrameGraph& graph, const resident::View& view,
                                        const SurfaceBuffers& surface, const OcclusionOptions& options);

} // namespace prelight::passes
