#include "forward.hpp"
#include <algorithm>
#include <shared/bindings.h>

namespace prelight::passes {

void forward_few_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs) {
    SurfaceDraws::Desc desc = summed_desc("forward.frag", view, inputs, true);
    desc.depth = gpu::DepthTest::equal; // exact: vertex_position() is invariant
    desc.keeps_alpha_mask = false;
    desc.push_bytes = sizeof(shared::ForwardBatch);
    for (const auto& constant : display_constants(inputs.display, graph.desc(inputs.colour).format))
        desc.constants.push_back(constant);
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, graph::Load::clear, {0, 0, 0, inputs.display ? 1.0f : 0.0f})
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_surfaces(graph, pass, view, desc.depth);
    declare_shadows(pass, inputs.shadows);
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    pass.record([=, &view](const graph::PassContext& context) {
        // As they stand in light_order[]: those of the camera, whatever else there is.
        const shared::ForwardBatch batch = batches_of(view.light_groups().order, FORWARD_MOST_LIGHTS).front();
        (*draws)->record(context, std::as_bytes(std::span(&batch, 1)));
    });
}

} // namespace prelight::passes
