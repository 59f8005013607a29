// Lists that only measurements need: what lists could be at best, and no lists.
#include "light_lists.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

void trim_light_lists(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                      const LightingInputs& inputs, const LightLists& lists) {
    const bool empty = inputs.list_contents == ListContents::empty;
    graph::Pass& pass = graph.pass(name + (empty ? "-lists empty" : "-lists perfect"));
    declare_lit_surface(graph, pass, inputs);
    declare_light_lists(pass, lists, true);
    gpu::Constants constants = list_lighting_constants(frame, inputs, lists);
    constants.emplace_back(CONSTANT_LIST_EMPTY, empty);
    dispatch_lists(pass, frame, lists.constants,
                   inputs.surface.format.roughness_in_stencil ? "light_lists_perfect+stencil.comp" : "light_lists_perfect.comp", constants,
                   [cells = lists.constants](const graph::PassContext& context) {
                       vkCmdDispatch(context.commands, (cells->cells.w + LIST_GROUP - 1) / LIST_GROUP, 1, 1);
                   });
}

} // namespace prelight::passes
