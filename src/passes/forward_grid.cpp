#include "forward.hpp"
#include "light_lists.hpp"
#include "light_rounds.hpp"
#include "surface_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

LightRounds grid_rounds(const resident::Frame& frame, bool counts) {
    return light_rounds(frame, LightWalk::fragment, counts);
}

/// The lights of one round; each but the first adds.
void forward_grid_round(graph::FrameGraph& graph, const resident::Frame& frame, const ForwardInputs& inputs,
                        const LightRounds& rounds, uint32_t round) {
    const LightLists lists = light_list_passes(graph, frame, inputs.name, {.rounds = &rounds, .round = round});
    SurfaceDraws::Desc desc{.name = "forward grid",
                            .fragment = "forward_grid" + shadow_variant(inputs.shadows) + ".frag",
                            .constants = inputs.model.constants(),
                            .depth = gpu::DepthTest::equal, // exact: vertex_position() is invariant
                            .keeps_alpha_mask = false,
                            .blend = round > 0 ? gpu::Blend::add : gpu::Blend::none,
                            .push_bytes = sizeof(shared::LightListConstants),
                            .decals = bool(inputs.decals)};
    desc.constants.insert(desc.constants.end(),
                          {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                           {CONSTANT_LIGHT_OUTPUT, inputs.counts_lights ? LIGHT_OUTPUT_COUNT : LIGHT_OUTPUT_LIGHT},
                           {CONSTANT_LIGHT_KINDS, frame.light_kinds()},
                           {CONSTANT_FORWARD_BASE, round == 0},
                           {CONSTANT_SPECULAR_ANTIALIASING, inputs.model.specular_antialiasing}});
    add_shadow_constants(desc.constants, frame);
    for (const auto& constant : display_constants(inputs.display, graph.desc(inputs.colour).format))
        desc.constants.push_back(constant);
    graph::Pass& pass = graph.pass(inputs.name + round_name(round));
    if (round > 0)
        pass.blends();
    pass.colour(inputs.colour, round > 0 ? graph::Load::keep : inputs.load, {0, 0, 0, inputs.display ? 1.0f : 0.0f})
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_light_lists(pass, lists);
    declare_surfaces(graph, pass, frame, desc.depth);
    declare_shadows(pass, inputs.shadows);
    declare_decals(pass, inputs.decals);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, desc); });
    pass.record([=, &frame](const graph::PassContext& context) {
        if (is_idle(*lists.constants, context))
            return;
        if (inputs.draws)
            *inputs.draws = (round > 0 ? *inputs.draws : 0) + frame.visible().batches.size();
        (*draws)->record(context, std::as_bytes(std::span(lists.constants.get(), 1)));
    });
}

} // namespace

bool forward_grid_adds(const resident::Frame& frame) { return grid_rounds(frame, false).count > 1; }

void forward_grid_pass(graph::FrameGraph& graph, const resident::Frame& frame, const ForwardInputs& inputs) {
    const LightRounds rounds = grid_rounds(frame, inputs.counts_lights);
    for (uint32_t round = 0; round < rounds.count; ++round)
        forward_grid_round(graph, frame, inputs, rounds, round);
}

} // namespace prelight::passes
