#include "forward.hpp"

namespace prelight::passes {

void forward_few_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs) {
    SurfaceDraws::Desc desc = summed_desc("forward.frag", view, inputs, true);
    desc.push_bytes = sizeof(shared::ForwardBatch);
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, graph::Load::clear, {0, 0, 0, inputs.display ? 1.0f : 0.0f});
    const auto draws = declare_whole(graph, pass, view, inputs, std::move(desc));
    pass.record([draws, &view](const graph::PassContext& context) {
        // As they stand in light_order[]: those of the camera, whatever else there is.
        const shared::ForwardBatch batch = batches_of(view.light_groups().order, FORWARD_MOST_LIGHTS).front();
        (*draws)->record(context, std::as_bytes(std::span(&batch, 1)));
    });
}

} // namespace prelight::passes
