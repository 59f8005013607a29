// Light lists of tiles and clusters: who walks them, and lists that only measurements need.
#include "screen_lists.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Why compute cannot be had, whatever the target; empty: it can.
std::string obstacle(const resident::View& view) {
    if (view.culling() != resident::LightCulling::tiles)
        return "is for light-culling=tiles";
    if (!view.context().features().store_without_format)
        return fmt::format("needs storage images without format, which {} has not", view.context().name());
    return {};
}

std::string obstacle(const graph::FrameGraph& graph, const resident::View& view, const LightingInputs& inputs) {
    const gpu::Context& context = view.context();
    if (std::string why_not = obstacle(view); !why_not.empty())
        return why_not;
    for (const graph::ImageId image : inputs.target.images)
        if (!context.supports(graph.desc(image).format, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT))
            return fmt::format("needs storage images of {}, which {} has not",
                               graph::format_name(graph.desc(image).format), context.name());
    return {};
}

/// `asked` as the device and the inputs have it.
LightWalk walk_of(graph::FrameGraph& graph, const resident::View& view, const LightingInputs& inputs,
                  ListShading asked) {
    if (asked == ListShading::fragment)
        return LightWalk::fragment;
    const std::string why_not = obstacle(graph, view, inputs);
    if (!why_not.empty() && asked != ListShading::automatic)
        graph.note(fmt::format("list-shading: compute {}, fragment is taken", why_not));
    if (!why_not.empty() || (asked == ListShading::automatic && !view.context().is_software()))
        return LightWalk::fragment;
    return LightWalk::compute;
}

/// How many lights of a tile an invocation looks at: loops over its pixels for each of them may take many turns, and
/// some drivers end loops in silence (LightRounds).
uint32_t lights_a_turn(uint32_t tile_size) {
    constexpr uint32_t most_turns = 32768, on_a_pixel = 16; // with a cookie
    return std::max(most_turns / (on_a_pixel * tile_size * tile_size), 1u);
}

/// Takes lights out of tiles' lists, in passes of their own: "NAME-lists perfect …" or "NAME-lists empty".
void trim_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                const LightingInputs& inputs, const LightListRound& round, ListContents contents) {
    const uint32_t each = lights_a_turn(inputs.lists->tile_size);
    const gpu::ShaderKey shader("light_lists_perfect.comp",
                                gpu::when(inputs.surface.format.roughness_in_stencil, gpu::Variant::stencil_roughness));
    const auto add = [&](const char* what, uint32_t step) {
        graph::Pass& pass = graph.pass(name + "-lists " + what + round.ending);
        declare_lit_surface(graph, pass, inputs);
        declare_light_lists(pass, round, true);
        gpu::Constants constants = lighting_constants(view, inputs);
        constants.insert(constants.end(), {{CONSTANT_LIST_TRIM, step}, {CONSTANT_LIST_TRIM_LIGHTS, each}});
        dispatch_lists(pass, view, round.constants, shader, constants,
                       [=, cells = round.constants](const graph::PassContext& context) {
                           const uint32_t all = std::max(cells->lights.y, 1u);
                           vkCmdDispatch(context.commands, (cells->cells.w + LIST_GROUP - 1) / LIST_GROUP,
                                         step == LIST_TRIM_MARK ? (all + each - 1) / each : 1, 1);
                       });
    };
    if (contents == ListContents::empty)
        return add("empty", LIST_TRIM_EMPTY);
    add("perfect marks", LIST_TRIM_MARK);
    add("perfect", LIST_TRIM_KEEP);
}

} // namespace

bool compute_walks(const resident::View& view, ListShading asked) {
    return asked != ListShading::fragment && view.context().is_software() && obstacle(view).empty();
}

std::optional<LightLists> screen_light_lists(graph::FrameGraph& graph, const resident::View& view,
                                             const std::string& name, const LightingInputs& inputs,
                                             const ScreenListOptions& options) {
    if (!resident::builds_lists(view.culling()))
        return {};
    const LightWalk walk = walk_of(graph, view, inputs, options.shading);
    LightLists lists =
        build_light_lists(graph, view, name,
                          {.surface = options.samples ? options.samples : &inputs.surface,
                           .tile_size = options.tile_size,
                           .sliced = view.culling() == resident::LightCulling::clusters,
                           // Only lists of tiles' own can be trimmed.
                           .masked = walk == LightWalk::compute && options.contents == ListContents::built,
                           .walk = walk,
                           .everywhere = inputs.model.ambient_as_light,
                           .rounds = light_rounds(view, walk),
                           .first_room = options.first_room});
    if (options.contents != ListContents::built) {
        LightingInputs listed = inputs;
        listed.lists = lists;
        for (const LightListRound& round : lists.rounds)
            trim_lists(graph, view, name, listed, round, options.contents);
    }
    return lists;
}

} // namespace prelight::passes
