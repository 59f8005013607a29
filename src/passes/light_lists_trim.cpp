// Lists that only measurements need: what lists could be at best, and no lists.
#include "light_lists.hpp"
#include <algorithm>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// How many lights of a tile an invocation looks at: loops over its pixels for each of them may take many turns, and
/// some drivers end loops in silence (LightRounds).
uint32_t lights_a_turn(uint32_t tile_size) {
    constexpr uint32_t most_turns = 32768, on_a_pixel = 16; // with a cookie
    return std::max(most_turns / (on_a_pixel * tile_size * tile_size), 1u);
}

} // namespace

void trim_light_lists(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                      const LightingInputs& inputs, const LightLists& lists, const std::string& ending) {
    const uint32_t each = lights_a_turn(inputs.tile_size);
    const char* shader =
        inputs.surface.format.roughness_in_stencil ? "light_lists_perfect+stencil.comp" : "light_lists_perfect.comp";
    const auto add = [&](const char* what, uint32_t step) {
        graph::Pass& pass = graph.pass(name + "-lists " + what + ending);
        declare_lit_surface(graph, pass, inputs);
        declare_light_lists(pass, lists, true);
        gpu::Constants constants = list_lighting_constants(frame, inputs, lists);
        constants.insert(constants.end(), {{CONSTANT_LIST_TRIM, step}, {CONSTANT_LIST_TRIM_LIGHTS, each}});
        dispatch_lists(pass, frame, lists.constants, shader, constants,
                       [=, cells = lists.constants](const graph::PassContext& context) {
                           const uint32_t all = std::max(cells->lights.y, 1u);
                           vkCmdDispatch(context.commands, (cells->cells.w + LIST_GROUP - 1) / LIST_GROUP,
                                         step == LIST_TRIM_MARK ? (all + each - 1) / each : 1, 1);
                       });
    };
    if (inputs.list_contents == ListContents::empty)
        return add("empty", LIST_TRIM_EMPTY);
    add("perfect marks", LIST_TRIM_MARK);
    add("perfect", LIST_TRIM_KEEP);
}

} // namespace prelight::passes
