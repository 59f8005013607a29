#pragma once
#include "depth_normal.hpp"
#include "light_lists.hpp"
#include "light_model.hpp"
#include "sample_surfaces.hpp"
#include "shadow_maps.hpp"

namespace prelight::passes {

/// Where a light pass puts its sums. The shaders have one variant for each kind of target
/// (shaders/shared/light_sums.glsl).
struct LightTarget {
    gpu::Variants variant;              ///< one of …_target and light_pair, or none: two images
    std::vector<graph::ImageId> images; ///< colour attachments, in the order of the variant's outputs
    graph::Load load = graph::Load::clear;
    gpu::Constants constants; ///< of the variant
    bool added = false;       ///< a compute pass adds to what stands there, where it would replace it
    /// Of a compute pass: which blocks of the images hold light. Passes that fill the same images one after another
    /// share it; empty until the first is made. Null: no other pass fills them.
    std::shared_ptr<gpu::Buffer> lit_before = {};

    bool packed() const { return variant.has(gpu::Variant::one_target); }
    bool counts() const { return variant.has(gpu::Variant::count_target); }
    bool deferred() const { return variant.has(gpu::Variant::deferred_target); }
};

/// What every light pass gets, however it finds its pixels.
struct LightingInputs {
    SurfaceBuffers surface;
    graph::ImageId material{}, albedo{}; ///< of a deferred target: RT2 and RT3 of the G-buffer
    graph::ImageId own_light{};          ///< with `edges`: RT0, with several samples
    LightModel model;
    LightTarget target;
    Shadows shadows;
    const gpu::Buffer* pair_counters = nullptr; ///< two uint32 a row of pixels; always bound
    bool count_pairs = false;
    std::optional<LightLists> lists; ///< tiles and clusters
    /// `surface` has several samples a pixel, and the target is a sample light buffer: light of edge pixels' samples.
    std::optional<SampleEdges> edges = {};
    /// With `edges`: the pixels' one surface, where shadows are looked up there (SampledSurfaces::shadows_per_pixel).
    std::optional<SurfaceBuffers> shadows_at = {};
    bool write_once = false; ///< all of a pixel's lights in one loop, instead of blended one by one
};

/// The light buffer; `specular` is the diffuse image itself when packed, or the fifth channel.
struct LightBuffer {
    graph::ImageId diffuse;
    graph::ImageId specular;
    LightTarget target;
};
/// Whether one image of pairs can hold the light buffer: it is two images of RGBA16F.
bool is_pair_of_halves(const LightModel& model);
/// `pair`: one image of pairs (is_light_pair()), where is_pair_of_halves() and compute_walks(). `wide`: full floats in
/// the place of half floats and smaller ones, for sums of many lights.
/// `edges`: the sample light buffer instead of the light buffer, or both in one image of pairs
/// (SampleEdges::first_row).
LightBuffer make_light_buffer(graph::FrameGraph& graph, const resident::View& view, const LightModel& model,
                              bool pair = false, bool wide = false, const SampleEdges* edges = nullptr);
/// An image of pairs: four half floats of diffuse and four of specular light as the bits of one RGBA32UI texel
/// (shaders/shared/light_pair.glsl), which only a light pass that writes each pixel once can fill.
bool is_light_pair(const graph::FrameGraph& graph, graph::ImageId image);

/// Lights evaluated in R, contributing in G, for --view light-count: full floats, for half floats count to 2,048.
/// A count for each pixel of `depth`. `stored`: a compute pass writes them; else they are blended.
graph::ImageId light_count_image(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth,
                                 bool stored = false);
/// The same as a target to light.
LightTarget make_light_counts(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth, bool stored);

/// The inputs as the pass's attachments and bindings.
void declare_lighting(graph::FrameGraph& graph, graph::Pass& pass, const LightingInputs& inputs);
/// The same without the target's images.
void declare_lit_surface(graph::FrameGraph& graph, graph::Pass& pass, const LightingInputs& inputs);
/// The shader in its variant for the target, and for shadows where there are any: counts know none.
gpu::ShaderKey lighting_shader(const LightingInputs& inputs, const char* file);
/// Specialisation constants of every shader that evaluates lights: their kinds, how they are read, their shadows.
void add_light_constants(gpu::Constants& constants, const resident::View& view);
/// The same with those of the light's lists, where the shader walks some.
gpu::Constants lighting_constants(const resident::View& view, const LightingInputs& inputs);
/// A pipeline with `fragment` in its variant for the target, drawn over the pass's attachments; the caller
/// adds vertex shader, depth test and blending.
gpu::GraphicsPipelineDesc lighting_pipeline(const resident::View& view, const graph::PassInterface& interface,
                                            const LightingInputs& inputs, const char* fragment);

} // namespace prelight::passes
