// Lists that only measurements need: what lists could be at best, and no lists.
#include "light_lists.hpp"
#include <gpu/compute_pipeline.hpp>
#include <shared/bindings.h>

namespace prelight::passes {

void trim_light_lists(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                      const LightingInputs& inputs, const LightLists& lists) {
    const bool empty = inputs.list_contents == ListContents::empty;
    graph::Pass& pass = graph.pass(name + (empty ? "-lists empty" : "-lists perfect"));
    declare_lit_surface(graph, pass, inputs);
    declare_light_lists(pass, lists, true);
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &frame](const graph::PassInterface& interface) {
        gpu::Constants constants = lighting_constants(frame, inputs);
        const gpu::Constants own = light_list_constants(lists);
        constants.insert(constants.end(), own.begin(), own.end());
        constants.emplace_back(CONSTANT_LIST_EMPTY, empty);
        *pipeline = gpu::ComputePipeline(frame.context(), {.name = "trim light lists",
                                                           .shader = "light_lists_perfect.comp",
                                                           .constants = constants,
                                                           .sets = {frame.layout(), interface.inputs},
                                                           .push_bytes = sizeof(shared::LightListConstants)});
    });
    pass.record([=, &frame](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, frame.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        pipeline->push(context.commands, std::as_bytes(std::span(lists.constants.get(), 1)));
        vkCmdDispatch(context.commands, (lists.constants->cells.w + LIST_GROUP - 1) / LIST_GROUP, 1, 1);
    });
}

} // namespace prelight::passes
