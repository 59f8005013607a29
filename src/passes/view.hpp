#pragma once
#include "sample_surfaces.hpp"

namespace prelight::passes {

/// What a view pass makes of a buffer.
enum class ViewKind {
    depth,
    normal,
    roughness,
    light,
    light_alpha,
    count,
    colour,
    light_luv,
    albedo,                               ///< of a G-buffer: RT3
    specular,                             ///< of a G-buffer: the target that holds it
    motion,                               ///< of a G-buffer: RT2
    second_light,                         ///< the other half of a pair in one image
    occlusion = VIEW_OCCLUSION,           ///< visibility as grey
    specular_light = VIEW_SPECULAR_LIGHT, ///< light that is stored by the specular scale
    sun_occlusion = VIEW_SUN_OCCLUSION,   ///< of a G-buffer: RT3's alpha
    layers = VIEW_LAYERS,                 ///< layer_count_pass(): in the colours of `count`
    edges = VIEW_EDGES,                   ///< SampleEdges::flags: surfaces of an edge pixel, white for four
};

/// `buffer` drawn so that a person can read it, as sRGB-encoded RGBA8. `sample`: the one that is shown where surface
/// and buffer have several a pixel, depth in its attachment.
graph::ImageId view_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name, ViewKind kind,
                         const SurfaceBuffers& surface, graph::ImageId buffer, uint32_t sample = 0);

/// Edge pixels, whose samples have light of their own; black where no pixel is one.
graph::ImageId edges_view_pass(graph::FrameGraph& graph, const resident::View& view, const SampledSurfaces& surfaces);

/// A view of nothing: black.
graph::ImageId black_view_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name);

/// How many blended surfaces lie over each pixel: `layers`, layer_count_pass()'s; black without it.
graph::ImageId layers_view_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                                const std::optional<graph::ImageId>& layers);

} // namespace prelight::passes
