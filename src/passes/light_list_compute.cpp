#include "light_list_compute.hpp"
#include "light_draws.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// A list of blocks of pixels that the device writes and dispatches over.
struct BlockList {
    BlockList(graph::FrameGraph& graph, const resident::View& view, const char* name, uint64_t room)
        : buffer(std::make_shared<gpu::Buffer>(
              view.context(), name, sizeof(shared::LitBlocks) + room * sizeof(uint32_t),
              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, gpu::BufferPlace::device)),
          id(graph.buffer(name, *buffer)) {}
    void dispatch(const graph::PassContext& context) const {
        vkCmdDispatchIndirect(context.commands, buffer->handle(), 0);
    }
    std::shared_ptr<gpu::Buffer> buffer;
    graph::BufferId id;
};

/// Of so many rows of pixels those of an invocation: as many as leave a subgroup full. `lanes`: 1 … 64,
/// build_light_lists() has seen to it.
uint32_t rows_of(uint32_t lanes, uint32_t rows) { return std::clamp<uint32_t>(LIT_BLOCK * rows / lanes, 1, rows); }

/// Passes that list the blocks with light, and clear those that have none any more.
template <class Store>
BlockList find_lit_blocks(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                          const LightingInputs& inputs, const LightListRound& round, bool ambient, Store&& store) {
    const LightLists& lists = *inputs.lists;
    const bool keeps = inputs.target.load == graph::Load::keep;
    const uint64_t blocks = uint64_t(round.constants->blocks.x) * round.constants->blocks.y, words = (blocks + 31) / 32;
    BlockList lit(graph, view, "lit blocks", blocks);
    const BlockList stale(graph, view, "stale blocks", blocks + words);
    const auto before = inputs.target.lit_before ? inputs.target.lit_before : std::make_shared<gpu::Buffer>();
    if (!before->handle())
        *before = gpu::make_device_buffer(view.context(), "blocks lit before",
                                          std::vector<std::byte>(words * sizeof(uint32_t)),
                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    graph::Pass& find = graph.pass(name + "-lists lit" + round.ending);
    find.storage(INPUT_LIGHT_CELLS, round.tiles, false)
        .storage(INPUT_LIT_BLOCKS, lit.id, true)
        .storage(INPUT_STALE_BLOCKS, stale.id, true)
        .storage(INPUT_LIT_BEFORE, graph.buffer("blocks lit before", *before), true);
    dispatch_lists(find, view, round.constants, "light_lists_lit.comp",
                   {{CONSTANT_LIST_TILE_SIZE, lists.tile_size}, {CONSTANT_AMBIENT_TOO, ambient || round.everywhere}},
                   [before, stale](const graph::PassContext& context) { vkCmdDispatch(context.commands, 1, 1, 1); });

    if (!keeps) { // blocks without light stay as they are: a clear of the whole picture costs more than few lights
        for (const graph::ImageId image : inputs.target.images)
            graph.persist(image);
        graph::Pass& clear = graph.pass(name + " clear");
        clear.storage(INPUT_STALE_BLOCKS, stale.id, false).indirect(stale.id);
        store(clear);
        dispatch_lists(clear, view, round.constants, {"light_list_clear.comp", inputs.target.variant}, {},
                       [stale](const graph::PassContext& context) { stale.dispatch(context); });
    }
    return lit;
}

} // namespace

void light_list_compute_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                             const LightingInputs& inputs, const LightListRound& round) {
    const LightLists& lists = *inputs.lists;
    const std::vector<graph::ImageId>& images = inputs.target.images;
    const bool keeps = inputs.target.load == graph::Load::keep;
    // With ambient light as a light every surface is lit.
    const bool ambient = inputs.model.ambient_as_light && !inputs.target.counts();
    const auto store = [&](graph::Pass& pass) {
        pass.store(INPUT_LIGHT_TARGET, images[0]);
        if (images.size() > 1)
            pass.store(INPUT_SECOND_LIGHT_TARGET, images[1]);
    };

    std::optional<BlockList> lit;
    if (!inputs.edges)
        lit = find_lit_blocks(graph, view, name, inputs, round, ambient, store);
    gpu::Constants constants = lighting_constants(view, inputs);
    const uint32_t all_rows = inputs.edges ? EDGE_TILE_ROWS : LIT_BLOCK;
    const uint32_t rows = rows_of(view.context().features().shuffle_lanes, all_rows);
    constants.insert(constants.end(), {{CONSTANT_LIST_ROWS, rows},
                                       {CONSTANT_LIST_GROUP_ROWS, all_rows / rows},
                                       {CONSTANT_LIST_MASKED, lists.masked},
                                       {CONSTANT_AMBIENT_TOO, ambient}});
    graph::Pass& pass = graph.pass(name + round.ending);
    declare_lit_surface(graph, pass, inputs);
    declare_light_lists(pass, round);
    if (lit)
        pass.storage(INPUT_LIT_BLOCKS, lit->id, false);
    pass.indirect(lit ? lit->id : inputs.edges->tiles);
    store(pass);
    if (keeps)
        pass.sample(INPUT_COLOUR_BEFORE, images[0]);
    if (inputs.target.added && images.size() > 1)
        pass.sample(INPUT_SECOND_BEFORE, images[1]);
    dispatch_lists(
        pass, view, round.constants, lighting_shader(inputs, "light_list.comp"), constants,
        [lit, tiles = inputs.edges ? inputs.edges->tile_buffer : nullptr](const graph::PassContext& context) {
            if (context.one_pixel)
                vkCmdDispatch(context.commands, 1, 1, 1);
            else
                vkCmdDispatchIndirect(context.commands, (lit ? lit->buffer : tiles)->handle(), 0);
        });
}

} // namespace prelight::passes
