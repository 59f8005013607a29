#include "light_pass.hpp"
#include "light_list_shading.hpp"
#include "light_loop.hpp"
#include "light_overlap.hpp"
#include "light_rectangles.hpp"
#include "light_rounds.hpp"
#include "light_stencil.hpp"
#include "light_volumes.hpp"

namespace prelight::passes {

void light_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                const LightingInputs& inputs) {
    if (inputs.write_once && view.culling() == resident::LightCulling::fullscreen)
        return light_loop_pass(graph, view, name, inputs);
    switch (view.culling()) {
    case resident::LightCulling::fullscreen:
    case resident::LightCulling::volumes: return light_volume_pass(graph, view, name, inputs);
    case resident::LightCulling::rectangles: return light_rectangle_pass(graph, view, name, inputs);
    case resident::LightCulling::stencil: return light_stencil_pass(graph, view, name, inputs);
    case resident::LightCulling::tiles:
    case resident::LightCulling::clusters: return light_list_pass(graph, view, name, inputs);
    case resident::LightCulling::grid: break; // forward only
    }
}

void sample_light_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                       LightingInputs inputs, const SampledSurfaces& surfaces, const LightTarget& target) {
    inputs.surface = surfaces.samples;
    inputs.edges = surfaces.edges;
    if (surfaces.shadows_per_pixel)
        inputs.shadows_at = surfaces.pixels;
    inputs.target = target;
    if (inputs.lists)
        light_list_pass(graph, view, name, inputs);
    else
        light_loop_pass(graph, view, name, inputs);
}

graph::ImageId light_count_pass(graph::FrameGraph& graph, const resident::View& view, LightingInputs inputs) {
    inputs.target =
        make_light_counts(graph, view, inputs.surface.depth, inputs.lists && inputs.lists->walk == LightWalk::compute);
    inputs.count_pairs = false;
    light_pass(graph, view, "light-count", inputs);
    return inputs.target.images[0];
}

uint32_t light_adds(const resident::View& view, bool one_by_one) {
    if (!resident::builds_lists(view.culling()) && one_by_one)
        return light_overlap(view.scene().geometry().draws, view.lights().placed());
    const LightWalk walk = view.culling() == resident::LightCulling::tiles ? LightWalk::compute : LightWalk::fragment;
    const uint32_t rounds = light_rounds(view, walk).count;
    return rounds > 1 ? rounds : 0;
}

} // namespace prelight::passes
