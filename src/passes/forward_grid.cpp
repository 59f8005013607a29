#include "forward.hpp"
#include "light_lists.hpp"
#include "surface_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void forward_grid_pass(graph::FrameGraph& graph, const resident::Frame& frame, const ForwardInputs& inputs) {
    const LightLists lists = light_list_passes(graph, frame, inputs.name, {});
    SurfaceDraws::Desc desc{.name = "forward grid",
                            .fragment = "forward_grid" + shadow_variant(inputs.shadows) + ".frag",
                            .constants = inputs.model.constants(),
                            .depth = gpu::DepthTest::equal, // exact: vertex_position() is invariant
                            .keeps_alpha_mask = false,
                            .push_bytes = sizeof(shared::LightListConstants),
                            .decals = bool(inputs.decals)};
    desc.constants.insert(desc.constants.end(),
                          {{CONSTANT_COUNT_PAIRS, inputs.count_pairs},
                           {CONSTANT_LIGHT_OUTPUT, inputs.counts_lights ? LIGHT_OUTPUT_COUNT : LIGHT_OUTPUT_LIGHT},
                           {CONSTANT_LIGHT_KINDS, frame.light_kinds()},
                           {CONSTANT_SPECULAR_ANTIALIASING, inputs.model.specular_antialiasing}});
    add_shadow_constants(desc.constants, frame);
    for (const auto& constant : display_constants(inputs.display, graph.desc(inputs.colour).format))
        desc.constants.push_back(constant);
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, inputs.load, {0, 0, 0, inputs.display ? 1.0f : 0.0f})
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_light_lists(pass, lists);
    declare_surfaces(graph, pass, frame, desc.depth);
    declare_shadows(pass, inputs.shadows);
    declare_decals(pass, inputs.decals);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) { draws->emplace(frame, interface, desc); });
    pass.record([=, &frame](const graph::PassContext& context) {
        if (inputs.draws)
            *inputs.draws = frame.visible().batches.size();
        (*draws)->record(context, std::as_bytes(std::span(lists.constants.get(), 1)));
    });
}

} // namespace prelight::passes
