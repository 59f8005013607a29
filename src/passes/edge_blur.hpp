#pragma once
#include "depth_normal.hpp"

namespace prelight::passes {

/// The finished `picture` with edges of geometry blurred, half a pixel far at most along each axis. A renderer without
/// normals names its depth as SurfaceBuffers::normal; what bends less than the faces of a cube has no edge there.
graph::ImageId edge_blur_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                              graph::ImageId picture);

/// What finds edges of geometry (shaders/shared/geometry_edges.glsl) reads, and its specialisation constants with those
/// of a picture of this format.
gpu::Constants read_geometry_edges(graph::Pass& pass, const SurfaceBuffers& surface, VkFormat picture);

} // namespace prelight::passes
