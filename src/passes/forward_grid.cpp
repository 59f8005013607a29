#include "forward.hpp"
#include "surface_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// The lights of one round; each but the first adds.
void forward_grid_round(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                        const LightListRound& round, bool adds) {
    SurfaceDraws::Desc desc{.name = "forward grid",
                            .fragment = {"forward_grid.frag", shadow_variant(inputs.shadows)},
                            .constants = inputs.model.constants(),
                            .depth = gpu::DepthTest::equal, // exact: vertex_position() is invariant
                            .keeps_alpha_mask = false,
                            .blend = adds ? gpu::Blend::add : gpu::Blend::none,
                            .push_bytes = sizeof(shared::LightListConstants),
                            .sample_shading = inputs.sample_shading,
                            .decals = decal_use(inputs.decals)};
    desc.constants.insert(desc.constants.end(),
                          {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                           {CONSTANT_LIGHT_OUTPUT, inputs.counts_lights ? LIGHT_OUTPUT_COUNT : LIGHT_OUTPUT_LIGHT},
                           {CONSTANT_LIGHT_KINDS, view.lights().kinds()},
                           {CONSTANT_FORWARD_BASE, !adds},
                           {CONSTANT_SPECULAR_ANTIALIASING, inputs.model.specular_antialiasing}});
    add_shadow_constants(desc.constants, view);
    for (const auto& constant : display_constants(inputs.display, graph.desc(inputs.colour).format))
        desc.constants.push_back(constant);
    graph::Pass& pass = graph.pass(inputs.name + round.ending);
    if (adds)
        pass.blends();
    pass.colour(inputs.colour, adds ? graph::Load::keep : inputs.load, {0, 0, 0, inputs.display ? 1.0f : 0.0f})
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_light_lists(pass, round);
    declare_surfaces(graph, pass, view, desc.depth);
    declare_shadows(pass, inputs.shadows);
    declare_decals(pass, inputs.decals);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    pass.record([=, &view](const graph::PassContext& context) {
        if (is_idle(*round.constants, context))
            return;
        if (inputs.draws)
            *inputs.draws = (adds ? *inputs.draws : 0) + view.visible().batches.size();
        (*draws)->record(context, std::as_bytes(std::span(round.constants.get(), 1)));
    });
}

} // namespace

LightLists grid_light_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name) {
    return build_light_lists(graph, view, name, {.rounds = light_rounds(view, LightWalk::fragment)});
}

void forward_grid_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                       const LightLists& lists) {
    for (size_t round = 0; round < lists.rounds.size(); ++round)
        forward_grid_round(graph, view, inputs, lists.rounds[round], round > 0);
}

} // namespace prelight::passes
