#include "forward.hpp"

namespace prelight::passes {
namespace {

/// The lights of one round; each but the first adds.
void forward_grid_round(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                        const LightListRound& round, bool adds) {
    SurfaceDraws::Desc desc = forward_desc("forward_grid.frag", view, inputs, !adds);
    desc.blend = adds ? gpu::Blend::add : gpu::Blend::none;
    desc.push_bytes = sizeof(shared::LightListConstants);
    graph::Pass& pass = graph.pass(inputs.name + round.ending);
    if (adds)
        pass.blends();
    pass.colour(inputs.colour, adds ? graph::Load::keep : inputs.load, {0, 0, 0, inputs.display ? 1.0f : 0.0f});
    declare_light_lists(pass, round);
    const auto draws = declare_whole(graph, pass, view, inputs, std::move(desc));
    pass.record([=, &view](const graph::PassContext& context) {
        if (is_idle(*round.constants, context))
            return;
        if (inputs.draws)
            *inputs.draws = (adds ? *inputs.draws : 0) + view.visible().batches.size();
        (*draws)->record(context, std::as_bytes(std::span(round.constants.get(), 1)));
    });
}

} // namespace

LightLists grid_light_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                            GridOver over) {
    return build_light_lists(graph, view, name, {.over = over, .rounds = light_rounds(view, LightWalk::fragment)});
}

void forward_grid_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                       const LightLists& lists) {
    for (size_t round = 0; round < lists.rounds.size(); ++round)
        forward_grid_round(graph, view, inputs, lists.rounds[round], round > 0);
}

} // namespace prelight::passes
