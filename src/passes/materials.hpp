#pragma once
#include "decals.hpp"
#include "lighting.hpp"
#include "tonemap.hpp"
#include <optional>

namespace prelight::passes {

struct MaterialInputs {
    graph::ImageId depth;
    LightBuffer light;
    LightModel model;
    DecalBuffer decals = {};
    gpu::SampleShading sample_shading = gpu::SampleShading::fragment;
    std::optional<SampleEdges> edges = {}; ///< whose samples' light is in `sample_light`; `depth` has several samples
    LightBuffer sample_light = {};
    std::optional<graph::ImageId> visibility = {}; ///< ambient_occlusion_passes()'; none: ambient light is not occluded
};

/// Stage 3: every object once more with its own material, depth test EQUAL, light from the light
/// buffer. The result is scene-linear and exposed; with `display`, the finished picture.
graph::ImageId material_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                             Display display = {});

/// The light buffer's sums as a material receives them, exposed and scene-linear, in full floats:
/// diffuse light, or specular light with the material's own shininess.
graph::ImageId light_sum_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                              bool specular);

/// The base colour of what is seen, for --view albedo.
graph::ImageId albedo_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs);

} // namespace prelight::passes
