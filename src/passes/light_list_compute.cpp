#include "light_list_compute.hpp"
#include "light_draws.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Why compute cannot be had; empty: it can.
std::string obstacle(const graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs) {
    const gpu::Context& context = frame.context();
    if (frame.culling() != resident::LightCulling::tiles)
        return "is for light-culling=tiles";
    if (!context.features().store_without_format)
        return fmt::format("needs storage images without format, which {} has not", context.name());
    for (const graph::ImageId image : inputs.target.images)
        if (!context.supports(graph.desc(image).format, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT))
            return fmt::format("needs storage images of {}, which {} has not",
                               graph::format_name(graph.desc(image).format), context.name());
    return {};
}

/// Rows of pixels of an invocation: as many as leave a subgroup full. `lanes`: 1 … 64, light_list_passes() has seen to it.
uint32_t rows_of(uint32_t lanes) { return std::clamp<uint32_t>(LIT_BLOCK * LIT_BLOCK / lanes, 1, LIT_BLOCK); }

} // namespace

ListShading list_shading_of(graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs) {
    const ListShading asked = inputs.list_shading;
    if (asked == ListShading::fragment)
        return asked;
    const std::string why_not = obstacle(graph, frame, inputs);
    if (!why_not.empty() && asked != ListShading::automatic)
        graph.note(fmt::format("list-shading: compute {}, fragment is taken", why_not));
    if (!why_not.empty() || (asked == ListShading::automatic && !frame.context().is_software()))
        return ListShading::fragment;
    return ListShading::compute;
}

void light_list_compute_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightingInputs& inputs, const LightLists& lists) {
    gpu::Constants constants = list_lighting_constants(frame, inputs, lists);
    const uint32_t rows = rows_of(frame.context().features().shuffle_lanes);
    constants.insert(constants.end(), {{CONSTANT_LIST_ROWS, rows},
                                       {CONSTANT_LIST_GROUP_ROWS, LIT_BLOCK / rows},
                                       {CONSTANT_LIST_MASKED, lists.masked},
                                       {CONSTANT_AMBIENT_TOO, AmbientDraw::needed(inputs)}});

    const uint64_t blocks = uint64_t(lists.constants->blocks.x) * lists.constants->blocks.y;
    auto buffer = std::make_shared<gpu::Buffer>(
        frame.context(), "lit blocks", sizeof(shared::LitBlocks) + blocks * sizeof(uint32_t),
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, gpu::BufferPlace::device);
    const graph::BufferId lit = graph.buffer("lit blocks", *buffer);
    graph::Pass& find = graph.pass(name + "-lists lit");
    find.storage(INPUT_LIGHT_CELLS, lists.tiles, false).storage(INPUT_LIT_BLOCKS, lit, true);
    // LUV takes ambient light in when it writes, other ways as a light: every surface is lit then.
    const bool ambient = inputs.model.ambient_as_light && inputs.target.variant != "+count";
    dispatch_lists(find, frame, lists.constants, "light_lists_lit.comp",
                   {{CONSTANT_LIST_TILE_SIZE, lists.tile_size}, {CONSTANT_AMBIENT_TOO, ambient}},
            [](const graph::PassContext& context) { vkCmdDispatch(context.commands, 1, 1, 1); });

    const std::vector<graph::ImageId>& images = inputs.target.images;
    const bool keeps = inputs.target.load == graph::Load::keep;
    if (!keeps) { // blocks without light keep this
        graph::Pass& clear = graph.pass(name + " clear");
        for (const graph::ImageId image : images)
            clear.colour(image, graph::Load::clear);
        clear.record([](const graph::PassContext&) {});
    }
    graph::Pass& pass = graph.pass(name);
    declare_lit_surface(graph, pass, inputs);
    declare_light_lists(pass, lists);
    pass.storage(INPUT_LIT_BLOCKS, lit, false).indirect(lit).store(INPUT_LIGHT_TARGET, images[0]);
    if (images.size() > 1)
        pass.store(INPUT_SECOND_LIGHT_TARGET, images[1]);
    if (keeps)
        pass.sample(INPUT_COLOUR_BEFORE, images[0]);
    dispatch_lists(pass, frame, lists.constants, lighting_shader(inputs, "light_list", ".comp"), constants,
            [buffer](const graph::PassContext& context) {
                if (context.one_pixel)
                    vkCmdDispatch(context.commands, 1, 1, 1);
                else
                    vkCmdDispatchIndirect(context.commands, buffer->handle(), 0);
            });
}

} // namespace prelight::passes
