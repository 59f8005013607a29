#include "light_list_compute.hpp"
#include "light_draws.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Why compute cannot be had, whatever the target; empty: it can.
std::string obstacle(const resident::Frame& frame) {
    if (frame.culling() != resident::LightCulling::tiles)
        return "is for light-culling=tiles";
    if (!frame.context().features().store_without_format)
        return fmt::format("needs storage images without format, which {} has not", frame.context().name());
    return {};
}

std::string obstacle(const graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs) {
    const gpu::Context& context = frame.context();
    if (std::string why_not = obstacle(frame); !why_not.empty())
        return why_not;
    for (const graph::ImageId image : inputs.target.images)
        if (!context.supports(graph.desc(image).format, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT))
            return fmt::format("needs storage images of {}, which {} has not",
                               graph::format_name(graph.desc(image).format), context.name());
    return {};
}

/// A list of blocks of pixels that the device writes and dispatches over.
struct BlockList {
    BlockList(graph::FrameGraph& graph, const resident::Frame& frame, const char* name, uint64_t room)
        : buffer(std::make_shared<gpu::Buffer>(
              frame.context(), name, sizeof(shared::LitBlocks) + room * sizeof(uint32_t),
              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, gpu::BufferPlace::device)),
          id(graph.buffer(name, *buffer)) {}
    void dispatch(const graph::PassContext& context) const {
        vkCmdDispatchIndirect(context.commands, buffer->handle(), 0);
    }
    std::shared_ptr<gpu::Buffer> buffer;
    graph::BufferId id;
};

/// Rows of pixels of an invocation: as many as leave a subgroup full. `lanes`: 1 … 64, light_list_passes() has seen to
/// it.
uint32_t rows_of(uint32_t lanes) { return std::clamp<uint32_t>(LIT_BLOCK * LIT_BLOCK / lanes, 1, LIT_BLOCK); }

} // namespace

bool light_pair_pays(const resident::Frame& frame, const LightModel& model, ListShading asked) {
    return asked != ListShading::fragment && frame.context().is_software() && obstacle(frame).empty() &&
           model.buffer == LightBufferFormat::rgba16f && model.specular != SpecularWay::fifth_channel;
}

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
                             const LightingInputs& inputs, const LightLists& lists, bool everywhere,
                             const std::string& ending) {
    const std::vector<graph::ImageId>& images = inputs.target.images;
    const bool keeps = inputs.target.load == graph::Load::keep;
    // With ambient light as a light every surface is lit.
    const bool ambient = inputs.model.ambient_as_light && inputs.target.variant != "+count";
    const auto store = [&](graph::Pass& pass) {
        pass.store(INPUT_LIGHT_TARGET, images[0]);
        if (images.size() > 1)
            pass.store(INPUT_SECOND_LIGHT_TARGET, images[1]);
    };

    const uint64_t blocks = uint64_t(lists.constants->blocks.x) * lists.constants->blocks.y, words = (blocks + 31) / 32;
    const BlockList lit(graph, frame, "lit blocks", blocks), stale(graph, frame, "stale blocks", blocks + words);
    const auto before = std::make_shared<gpu::Buffer>(
        gpu::make_device_buffer(frame.context(), "blocks lit before", std::vector<std::byte>(words * sizeof(uint32_t)),
                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    graph::Pass& find = graph.pass(name + "-lists lit" + ending);
    find.storage(INPUT_LIGHT_CELLS, lists.tiles, false)
        .storage(INPUT_LIT_BLOCKS, lit.id, true)
        .storage(INPUT_STALE_BLOCKS, stale.id, true)
        .storage(INPUT_LIT_BEFORE, graph.buffer("blocks lit before", *before), true);
    dispatch_lists(find, frame, lists.constants, "light_lists_lit.comp",
                   {{CONSTANT_LIST_TILE_SIZE, lists.tile_size}, {CONSTANT_AMBIENT_TOO, ambient || everywhere}},
                   [before, stale](const graph::PassContext& context) { vkCmdDispatch(context.commands, 1, 1, 1); });

    if (!keeps) { // blocks without light stay as they are: a clear of the whole picture costs more than few lights
        for (const graph::ImageId image : images)
            graph.persist(image);
        graph::Pass& clear = graph.pass(name + " clear");
        clear.storage(INPUT_STALE_BLOCKS, stale.id, false).indirect(stale.id);
        store(clear);
        dispatch_lists(clear, frame, lists.constants, "light_list_clear" + inputs.target.variant + ".comp", {},
                       [stale](const graph::PassContext& context) { stale.dispatch(context); });
    }
    gpu::Constants constants = list_lighting_constants(frame, inputs, lists);
    const uint32_t rows = rows_of(frame.context().features().shuffle_lanes);
    constants.insert(constants.end(), {{CONSTANT_LIST_ROWS, rows},
                                       {CONSTANT_LIST_GROUP_ROWS, LIT_BLOCK / rows},
                                       {CONSTANT_LIST_MASKED, lists.masked},
                                       {CONSTANT_AMBIENT_TOO, ambient}});
    graph::Pass& pass = graph.pass(name + ending);
    declare_lit_surface(graph, pass, inputs);
    declare_light_lists(pass, lists);
    pass.storage(INPUT_LIT_BLOCKS, lit.id, false).indirect(lit.id);
    store(pass);
    if (keeps)
        pass.sample(INPUT_COLOUR_BEFORE, images[0]);
    if (inputs.target.added && images.size() > 1)
        pass.sample(INPUT_SECOND_BEFORE, images[1]);
    dispatch_lists(pass, frame, lists.constants, lighting_shader(inputs, "light_list", ".comp"), constants,
                   [lit](const graph::PassContext& context) {
                       if (context.one_pixel)
                           vkCmdDispatch(context.commands, 1, 1, 1);
                       else
                           lit.dispatch(context);
                   });
}

} // namespace prelight::passes
