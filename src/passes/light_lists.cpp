#include "light_lists.hpp"
#include "light_grid.hpp"
#include "light_list_buffers.hpp"
#include "light_rounds.hpp"
#include <algorithm>
#include <gpu/compute_pipeline.hpp>
#include <prelight/error.hpp>
#include <shared/bindings.h>
#include <utility>

namespace prelight::passes {
namespace {

using shared::LightListConstants;

uint32_t groups_of(uint64_t count, uint32_t size) { return static_cast<uint32_t>((count + size - 1) / size); }

/// All compute passes of one kind of list.
class Builder {
public:
    Builder(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
            const LightListInputs& inputs, uint32_t round, const LightListConstants& layout, const LightGrid& grid)
        : graph_(graph), view_(view), name_(name), inputs_(inputs),
          everywhere_(round == 0 && (inputs.everywhere || inputs.rounds.count > 1)), ending_(round_name(round)),
          buffers_(std::make_shared<ListBuffers>(view, layout, grid, inputs.first_room, inputs.rounds, round)) {
        cells_ = graph.buffer("light cells", buffers_->cells);
        coarse_ = graph.buffer("coarse light cells", buffers_->coarse);
        masks_ = graph.buffer("light masks", buffers_->masks);
        entries_ = graph.buffer("light lists", buffers_->entries);
        slices_ = graph.buffer("depth slices", buffers_->slices);
        total_ = graph.buffer("light list total", buffers_->total);
        graph.before_frame([&graph, buffers = buffers_, entries = entries_](const gpu::FrameTurn& turn) {
            if (std::optional<gpu::Buffer> outgrown = buffers->update(turn)) {
                graph.rebind(entries, buffers->entries);
                graph.retire(std::move(*outgrown)); // frames in flight still read it
            }
        });
        if (inputs.surface)
            constants_ = inputs.surface->format.constants();
        if (inputs.surface)
            constants_.emplace_back(CONSTANT_SAMPLES, graph.raster(inputs.surface->depth).samples);
        constants_.insert(constants_.end(), {{CONSTANT_LIST_TILE_SIZE, inputs.tile_size},
                                             {CONSTANT_LIST_SLICED, inputs.sliced},
                                             {CONSTANT_LIGHT_KINDS, view.lights().kinds()}});
    }

    LightListRound build() {
        const auto whole = [](const LightListConstants& c) { return VkExtent3D{c.coarse.x, c.coarse.y, c.coarse.z}; };
        const auto each_coarse = [](const LightListConstants& c) {
            return VkExtent3D{groups_of(c.coarse.w, LIST_GROUP), 1, 1};
        };
        const auto each_light = [](const LightListConstants& c) {
            return VkExtent3D{groups_of(c.lights.x + c.lights.y, LIST_GROUP), 1, 1};
        };
        const gpu::Variants kind = gpu::when(!inputs_.surface, gpu::Variant::grid_cells);
        if (inputs_.surface) {
            graph::Pass& range =
                add("depth-range", {"depth_range.comp", sampled()}, whole, {{CONSTANT_AMBIENT_TOO, everywhere_}});
            range.storage(INPUT_LIGHT_CELLS, cells_, true);
            read_depth(range);
        }

        add(name_ + "-lists coarse", {"light_lists_coarse.comp", kind}, each_coarse)
            .storage(INPUT_LIGHT_CELLS, cells_, false)
            .storage(INPUT_COARSE_CELLS, coarse_, true)
            .storage(INPUT_LIGHT_MASKS, masks_, true);

        if (inputs_.sliced)
            add(name_ + "-lists slices", "light_lists_slices.comp", once)
                .storage(INPUT_COARSE_CELLS, coarse_, false)
                .storage(INPUT_DEPTH_SLICES, slices_, true);

        add(name_ + "-lists scatter", {"light_lists_scatter.comp", kind}, each_light)
            .storage(INPUT_COARSE_CELLS, coarse_, true)
            .storage(INPUT_LIGHT_MASKS, masks_, true)
            .storage(INPUT_LIGHT_ENTRIES, entries_, true);

        add_offsets("-lists coarse offsets", coarse_, true);
        add(name_ + "-lists candidates", {"light_lists_candidates.comp", kind}, each_coarse)
            .storage(INPUT_COARSE_CELLS, coarse_, false)
            .storage(INPUT_LIGHT_MASKS, masks_, false)
            .storage(INPUT_LIGHT_ENTRIES, entries_, true);

        LightListRound lists{.cells = coarse_,
                             .tiles = cells_,
                             .entries = entries_,
                             .slices = slices_,
                             .constants = buffers_->constants(),
                             .everywhere = everywhere_,
                             .ending = ending_};
        if (inputs_.masked) {
            add(name_ + "-lists masks", "light_lists_masks.comp", whole,
                {{CONSTANT_LIST_LANES, view_.context().features().shuffle_lanes}})
                .storage(INPUT_LIGHT_CELLS, cells_, true)
                .storage(INPUT_COARSE_CELLS, coarse_, false)
                .storage(INPUT_LIGHT_ENTRIES, entries_, true)
                .storage(INPUT_DEPTH_SLICES, slices_, false);
            return lists;
        }
        for (const bool fill : {false, true}) {
            graph::Pass& pass = add(name_ + (fill ? "-lists fill" : "-lists count"),
                                    {"light_lists_cells.comp", kind | sampled()}, whole, {{CONSTANT_LIST_FILL, fill}});
            // Counting writes the cells and filling the entries; both stand in the one shader.
            pass.storage(INPUT_LIGHT_CELLS, cells_, true)
                .storage(INPUT_COARSE_CELLS, coarse_, false)
                .storage(INPUT_LIGHT_ENTRIES, entries_, true)
                .storage(INPUT_DEPTH_SLICES, slices_, false);
            if (inputs_.surface)
                read_depth(pass);
            if (!fill)
                add_offsets("-lists offsets", cells_, false);
        }
        lists.cells = cells_;
        return lists;
    }

private:
    using Groups = VkExtent3D (*)(const LightListConstants&);

    graph::Pass& add(const std::string& name, const gpu::ShaderKey& shader, Groups groups, gpu::Constants own = {}) {
        graph::Pass& pass = graph_.pass(name + ending_);
        if (inputs_.surface)
            pass.raster(graph_.raster(inputs_.surface->depth));
        own.insert(own.end(), constants_.begin(), constants_.end());
        dispatch_lists(pass, view_, buffers_->constants(), shader, own,
                       [groups, constants = buffers_->constants()](const graph::PassContext& context) {
                           const VkExtent3D count = groups(*constants);
                           vkCmdDispatch(context.commands, count.width, count.height, count.depth);
                       });
        return pass;
    }
    void add_offsets(const char* what, graph::BufferId cells, bool coarse) {
        add(name_ + what, "light_lists_offsets.comp", once,
            {{CONSTANT_LIST_COARSE, coarse}, {CONSTANT_LIST_MASKED, inputs_.masked}})
            .storage(INPUT_LIGHT_CELLS, cells, true)
            .storage(INPUT_LIST_TOTAL, total_, true);
    }
    static VkExtent3D once(const LightListConstants&) { return {1, 1, 1}; }
    gpu::Variants sampled() const {
        return gpu::when(inputs_.surface && graph_.raster(inputs_.surface->depth).samples > 1, gpu::Variant::samples);
    }
    void read_depth(graph::Pass& pass) const { pass.sample(INPUT_DEPTH, inputs_.surface->depth_source); }

    graph::FrameGraph& graph_;
    const resident::View& view_;
    std::string name_;
    LightListInputs inputs_;
    bool everywhere_ = false;
    std::string ending_;
    gpu::Constants constants_;
    std::shared_ptr<ListBuffers> buffers_;
    graph::BufferId cells_, coarse_, masks_, entries_, slices_, total_;
};

/// Words of a coarse cell's mask: a bit a light, and a bit a word.
uint32_t mask_words(uint64_t lights) {
    const uint32_t words = groups_of(lights, 32);
    return std::max(1u, words + groups_of(words, 32));
}

} // namespace

LightLists build_light_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                             const LightListInputs& inputs) {
    if (view.context().features().shuffle_lanes == 0)
        throw Error(view.context().name() +
                    ": light lists need compute shaders that shuffle within subgroups of at most 64");
    LightListConstants layout{};
    layout.lights.w = mask_words(std::min<uint64_t>(view.lights().capacity(), inputs.rounds.lights));
    LightGrid grid;
    if (inputs.surface) {
        const auto [width, height] = graph.raster(inputs.surface->depth).extent;
        const uint32_t across = groups_of(width, inputs.tile_size), down = groups_of(height, inputs.tile_size);
        layout.cells = {across, down, 1, 0};
        layout.blocks = {groups_of(width, LIT_BLOCK), groups_of(height, LIT_BLOCK), 1, 0};
        layout.coarse = {groups_of(across, LIST_COARSE_TILES), groups_of(down, LIST_COARSE_TILES), 1, 0};
    } else {
        grid = light_grid(box_of(inputs.over, view.scene()));
        grid.over = inputs.over;
        layout.cells = glm::uvec4(grid.cells, 0);
        layout.coarse = glm::uvec4((grid.cells + glm::uvec3(LIST_COARSE_CELLS - 1)) / glm::uvec3(LIST_COARSE_CELLS), 0);
    }
    layout.cells.w = layout.cells.x * layout.cells.y * layout.cells.z;
    layout.coarse.w = layout.coarse.x * layout.coarse.y * layout.coarse.z;
    LightLists lists{
        .tile_size = inputs.tile_size, .sliced = inputs.sliced, .masked = inputs.masked, .walk = inputs.walk};
    for (uint32_t round = 0; round < inputs.rounds.count; ++round)
        lists.rounds.push_back(Builder(graph, view, name, inputs, round, layout, grid).build());
    return lists;
}

bool is_idle(const LightListConstants& constants, const graph::PassContext& pass) {
    return constants.round.z > 0 && constants.lights.x + constants.lights.y == 0 && !pass.one_pixel;
}

void dispatch_lists(graph::Pass& pass, const resident::View& view,
                    std::shared_ptr<const shared::LightListConstants> push, const gpu::ShaderKey& shader,
                    const gpu::Constants& constants, std::function<void(const graph::PassContext&)> dispatch) {
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &view, name = pass.name()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(view.context(), {.name = name,
                                                          .shader = shader,
                                                          .constants = constants,
                                                          .sets = {view.layout(), interface.inputs},
                                                          .push_bytes = sizeof(LightListConstants)});
    });
    pass.record(
        [pipeline, dispatch = std::move(dispatch), push = std::move(push), &view](const graph::PassContext& context) {
            if (is_idle(*push, context))
                return;
            pipeline->bind(context.commands);
            pipeline->bind_set(context.commands, SET_FRAME, view.set());
            pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
            pipeline->push(context.commands, std::as_bytes(std::span(push.get(), 1)));
            dispatch(context);
        });
}

void declare_light_lists(graph::Pass& pass, const LightListRound& round, bool writes) {
    pass.storage(INPUT_LIGHT_CELLS, round.cells, writes).storage(INPUT_LIGHT_ENTRIES, round.entries, writes);
    pass.storage(INPUT_DEPTH_SLICES, round.slices, false);
}

gpu::Constants light_list_constants(const LightLists& lists) {
    return {{CONSTANT_LIST_TILE_SIZE, lists.tile_size}, {CONSTANT_LIST_SLICED, lists.sliced}};
}

} // namespace prelight::passes
