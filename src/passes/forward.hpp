#pragma once
#include "decals.hpp"
#include "forward_plan.hpp"
#include "light_lists.hpp"
#include "light_model.hpp"
#include "shadow_maps.hpp"
#include "surface_draws.hpp"
#include "tonemap.hpp"
#include <functional>
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// A pass that shades objects where they are drawn, lights included.
struct ForwardInputs {
    std::string name;
    graph::ImageId depth;
    graph::ImageId colour; ///< picture_image(): scene-linear and exposed, or finished
    Display display = {};  ///< forward_grid_pass(), forward_few_pass(): how `colour` was made
    graph::Load load = graph::Load::clear;
    /// Of lights: `equal`, exact because vertex_position() is invariant, or `behind_or_at`, LESS_OR_EQUAL.
    gpu::DepthTest lights_test = gpu::DepthTest::equal;
    std::vector<StepKind> kinds; ///< what the plan has; with base among them depth is written
    /// The draws of a frame, made anew for each from the lights of its objects.
    std::function<ForwardPlan(const resident::LightReach&)> plan;
    LightModel model;
    Shadows shadows; ///< not of passes that count lights
    DecalBuffer decals = {};
    /// Of blended surfaces: the depth of what is opaque, where soft ones look at it.
    std::optional<graph::ImageId> behind = {};
    const gpu::Buffer* pair_counters = nullptr; ///< two uint32 a row of pixels; bound with lights
    bool count_pairs = false;
    gpu::SampleShading sample_shading = gpu::SampleShading::fragment;
    bool counts_lights = false; ///< instead of light: 1 for each in R, and in G where it contributes
    uint64_t* draws = nullptr;  ///< gets the number of draws at each recording
};
/// What draws with forward.frag or forward_grid.frag have in common; `with_base`: ambient and emissive light too.
SurfaceDraws::Desc forward_desc(const char* fragment, const resident::View& view, const ForwardInputs& inputs,
                                bool with_base);
/// The same for weighted Fresnel, too, which takes the sums of all lights: every material gets them, as those with a
/// shader of their own do.
SurfaceDraws::Desc summed_desc(const char* fragment, const resident::View& view, ForwardInputs inputs, bool with_base);
/// Makes `pass`, which has its colour, draw every object once where its depth is, with `desc` and this display; to be
/// recorded by SurfaceDraws::record().
std::shared_ptr<std::optional<SurfaceDraws>> declare_whole(graph::FrameGraph& graph, graph::Pass& pass,
                                                           const resident::View& view, const ForwardInputs& inputs,
                                                           SurfaceDraws::Desc desc);
void forward_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs);

/// Every object once, with all lights that the camera may see, at most FORWARD_MOST_LIGHTS; replaces, depth test EQUAL.
/// `kinds` and `plan` are not used.
void forward_few_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs);

/// Lists for the cells of a grid.
LightLists grid_light_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                            GridOver over = GridOver::world);

/// Every object once, with the lights that `lists` has for the pixel's place; replaces, depth test EQUAL. `kinds` and
/// `plan` are not used. With several rounds, in several draws that add up: `colour` must be linear.
void forward_grid_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                       const LightLists& lists);

/// The base colour of what is seen, for --view albedo.
graph::ImageId forward_albedo_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth,
                                   const DecalBuffer& decals);

} // namespace prelight::passes
