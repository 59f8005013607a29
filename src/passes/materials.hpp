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
    bool half_samples =
        false; ///< half_surfaces_pass() has drawn into `depth`: opaque surfaces have two of four samples
    std::optional<graph::ImageId> visibility = {}; ///< ambient_occlusion_passes()'; none: ambient light is not occluded
    /// Light and visibility are of these surfaces, with ids and at another resolution, and are found by
    /// shaders/shared/inferred_light.glsl.
    std::optional<SurfaceBuffers> lit_surfaces = {};
    const gpu::Buffer* unmatched = nullptr; ///< uint32, with `lit_surfaces`: pixels without a texel of their surface
};

/// Stage 3: every object once more with its own material, depth test EQUAL, light from the light
/// buffer. The result is scene-linear and exposed; with `display`, the finished picture.
graph::ImageId material_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                             Display display = {});

/// The same of a layer of blended surfaces, those at `inputs.depth`, over what `target` holds, which is scene-linear: a
/// pass `name`. `drawn` gets the number of draws.
void blended_material_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                           const std::string& name, graph::ImageId target, uint64_t* drawn);

/// The same of the blended surfaces that half_surfaces_pass() drew into `inputs.depth`: a pass "blended", into their
/// samples of `target`, unblended, for Resolved::halves.
void half_material_pass(graph::FrameGraph& graph, const resident::View& view, MaterialInputs inputs,
                        graph::ImageId target, uint64_t* drawn);

/// The light buffer's sums as a material receives them, exposed and scene-linear, in full floats:
/// diffuse light, or specular light with the material's own shininess.
graph::ImageId light_sum_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                              bool specular);

/// A pass "material counts" before those: no pixel is without a texel of its surface yet.
void clear_unmatched_pass(graph::FrameGraph& graph, const gpu::Buffer& unmatched);

/// A pass "blended layers": blended objects back to front over the scene-linear picture `target`, lit by the texels of
/// their slots (`inputs.lit_surfaces`, into which layer_geometry_pass() has drawn them). `slots`: the view whose
/// layers() those are. `drawn`: set to the number of draws.
void layer_pass(graph::FrameGraph& graph, const resident::View& view, MaterialInputs inputs,
                const resident::View& slots, graph::ImageId target, uint64_t* drawn);

/// Where pixels are without a texel of their surface: white, over the base colours in grey. `slots`: of blended
/// objects; null: there are none.
graph::ImageId unmatched_view_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs,
                                   const resident::View* slots);

/// The base colour of what is seen, for --view albedo.
graph::ImageId albedo_pass(graph::FrameGraph& graph, const resident::View& view, const MaterialInputs& inputs);

} // namespace prelight::passes
