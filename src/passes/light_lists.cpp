#include "light_lists.hpp"
#include "light_grid.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <gpu/compute_pipeline.hpp>
#include <prelight/error.hpp>
#include <shared/bindings.h>
#include <utility>

namespace prelight::passes {
namespace {

using shared::LightListConstants;

uint32_t groups_of(uint64_t count, uint32_t size) { return static_cast<uint32_t>((count + size - 1) / size); }

gpu::Buffer make_storage(const resident::Frame& frame, const char* name, uint64_t size,
                         gpu::BufferPlace place = gpu::BufferPlace::device) {
    const uint64_t limit = frame.context().limits().maxStorageBufferRange;
    if (size > limit)
        throw Error(fmt::format("{}: {} for {} lights and {}x{} pixels need {} bytes, and the device's limit is {}",
                                frame.context().name(), name, frame.light_capacity(), frame.extent().width,
                                frame.extent().height, size, limit));
    return gpu::Buffer(frame.context(), name, size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, place);
}

/// The buffers, and what changes from frame to frame.
class ListBuffers {
public:
    ListBuffers(const resident::Frame& frame, const LightListConstants& layout, const LightGrid& grid,
                uint64_t first_room)
        : frame_(frame), grid_(grid), guesses_(first_room == 0), constants_(std::make_shared<LightListConstants>(layout)),
          cells(make_storage(frame, "light cells", uint64_t(layout.cells.w) * sizeof(shared::LightCell))),
          coarse(make_storage(frame, "coarse light cells", uint64_t(layout.coarse.w) * sizeof(shared::LightCell))),
          masks(make_storage(frame, "light masks", uint64_t(layout.coarse.w) * layout.lights.w * sizeof(uint32_t))),
          slices(make_storage(frame, "depth slices", (LIST_SLICES + 1) * sizeof(float))) {
        for (gpu::Buffer& one : total) {
            one = make_storage(frame, "light list total", sizeof(uint32_t), gpu::BufferPlace::readback);
            *one.mapped<uint32_t>() = 0;
        }
        make_entries(all_lights() + first_room);
    }

    /// Before each frame: the buffer whose place another one took as `entries`, if so.
    std::optional<gpu::Buffer> update(const gpu::FrameTurn& turn) {
        const resident::LightGroups& lights = frame_.lights();
        const auto count = [&](resident::LightGroup group) { return lights.count[static_cast<size_t>(group)]; };
        uint64_t needed = 0; // by the frames that are done
        for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
            if (turn.alone || slot == turn.slot)
                needed = std::max<uint64_t>(needed, *total[slot].mapped<uint32_t>());
        // The first frame has no other to learn from, and neither has one with other lights.
        const uint32_t listed = count(resident::LightGroup::listed);
        if (guesses_ && std::exchange(listed_, listed) != listed)
            needed = std::max(needed, std::min<uint64_t>(first_guess(), most_entries()));
        const bool grows = needed > constants_->lights.z && constants_->lights.z < most_entries();
        if (grows && !full_)
            grow(needed + needed / 4);
        const glm::dvec3 origin = grid_.low - frame_.eye();
        constants_->grid_origin = glm::vec4(origin, 0);
        constants_->lights.x = count(resident::LightGroup::fullscreen);
        constants_->lights.y = listed;
        return std::exchange(outgrown_, std::nullopt);
    }
    std::shared_ptr<const LightListConstants> constants() const { return constants_; }

private:
    uint64_t first_guess() const {
        const double overlap = grid_.cells.x > 0 ? grid_overlap(grid_, frame_.placed_lights())
                                                 : 1.5 * frame_.lights().listed_pictures * constants_->cells.w;
        constexpr double most_guessed = 1 << 24; // 64 MiB; what is really needed is known a frame later
        return static_cast<uint64_t>(std::min(overlap, most_guessed)) + 2 * uint64_t(constants_->cells.w) + 16 * all_lights();
    }
    uint64_t all_lights() const { return frame_.light_capacity(); }
    uint64_t most_entries() const { return frame_.context().limits().maxStorageBufferRange / sizeof(uint32_t); }
    void make_entries(uint64_t count) {
        const uint64_t size = std::clamp<uint64_t>(count, all_lights() + 1, std::max(most_entries(), all_lights() + 1));
        entries = make_storage(frame_, "light lists", size * sizeof(uint32_t));
        constants_->lights.z = static_cast<uint32_t>(std::min<uint64_t>(size, 0xffffffffu));
    }

    /// A device without room keeps the lists it has: what does not fit walks all lights.
    void grow(uint64_t count) {
        gpu::Buffer old = std::exchange(entries, gpu::Buffer());
        try {
            make_entries(count);
            outgrown_ = std::move(old);
        } catch (const Error&) {
            entries = std::move(old);
            full_ = true;
        }
    }

    const resident::Frame& frame_;
    LightGrid grid_;
    bool full_ = false;
    std::optional<gpu::Buffer> outgrown_;
    bool guesses_;
    uint32_t listed_ = 0; ///< lights of the last frame's lists
    std::shared_ptr<LightListConstants> constants_;

public:
    gpu::Buffer cells, coarse, masks, slices, entries;
    gpu::PerFrame<gpu::Buffer> total; ///< read by the host when its frame is done
};

/// All compute passes of one kind of list.
class Builder {
public:
    Builder(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
            const LightListInputs& inputs, const LightListConstants& layout, const LightGrid& grid)
        : graph_(graph), frame_(frame), name_(name), inputs_(inputs),
          buffers_(std::make_shared<ListBuffers>(frame, layout, grid, inputs.first_room)) {
        cells_ = graph.buffer("light cells", buffers_->cells);
        coarse_ = graph.buffer("coarse light cells", buffers_->coarse);
        masks_ = graph.buffer("light masks", buffers_->masks);
        entries_ = graph.buffer("light lists", buffers_->entries);
        slices_ = graph.buffer("depth slices", buffers_->slices);
        total_ = graph.buffer("light list total", buffers_->total);
        graph.before_frame([&graph, buffers = buffers_, entries = entries_](const gpu::FrameTurn& turn) {
            if (std::optional<gpu::Buffer> outgrown = buffers->update(turn)) {
                graph.rebind(entries, buffers->entries);
                graph.retire(std::move(*outgrown)); // frames on their way still read it
            }
        });
        if (inputs.surface)
            constants_ = inputs.surface->format.constants();
        constants_.insert(constants_.end(), {{CONSTANT_LIST_TILE_SIZE, inputs.tile_size},
                                             {CONSTANT_LIST_SLICED, inputs.sliced},
                                             {CONSTANT_LIGHT_KINDS, frame.light_kinds()}});
    }

    LightLists build() {
        const auto whole = [](const LightListConstants& c) { return VkExtent3D{c.coarse.x, c.coarse.y, c.coarse.z}; };
        const auto each_coarse = [](const LightListConstants& c) { return VkExtent3D{groups_of(c.coarse.w, LIST_GROUP), 1, 1}; };
        const auto each_light = [](const LightListConstants& c) {
            return VkExtent3D{groups_of(c.lights.x + c.lights.y, LIST_GROUP), 1, 1};
        };
        const std::string kind = inputs_.surface ? ".comp" : "+grid.comp";
        if (inputs_.surface) {
            graph::Pass& range = add("depth-range", "depth_range.comp", whole);
            range.storage(INPUT_LIGHT_CELLS, cells_, true);
            read_depth(range);
        }

        add(name_ + "-lists coarse", "light_lists_coarse" + kind, each_coarse)
            .storage(INPUT_LIGHT_CELLS, cells_, false)
            .storage(INPUT_COARSE_CELLS, coarse_, true)
            .storage(INPUT_LIGHT_MASKS, masks_, true);

        if (inputs_.sliced)
            add(name_ + "-lists slices", "light_lists_slices.comp", once)
                .storage(INPUT_COARSE_CELLS, coarse_, false)
                .storage(INPUT_DEPTH_SLICES, slices_, true);

        add(name_ + "-lists scatter", "light_lists_scatter" + kind, each_light)
            .storage(INPUT_COARSE_CELLS, coarse_, true)
            .storage(INPUT_LIGHT_MASKS, masks_, true)
            .storage(INPUT_LIGHT_ENTRIES, entries_, true);

        add_offsets("-lists coarse offsets", coarse_, true);
        add(name_ + "-lists candidates", "light_lists_candidates" + kind, each_coarse)
            .storage(INPUT_COARSE_CELLS, coarse_, false)
            .storage(INPUT_LIGHT_MASKS, masks_, false)
            .storage(INPUT_LIGHT_ENTRIES, entries_, true);

        LightLists lists{.cells = coarse_, .tiles = cells_, .entries = entries_, .slices = slices_, .constants = buffers_->constants(),
                         .tile_size = inputs_.tile_size, .sliced = inputs_.sliced, .masked = inputs_.masked};
        if (lists.masked) {
            add(name_ + "-lists masks", "light_lists_masks.comp", whole)
                .storage(INPUT_LIGHT_CELLS, cells_, true)
                .storage(INPUT_COARSE_CELLS, coarse_, false)
                .storage(INPUT_LIGHT_ENTRIES, entries_, true)
                .storage(INPUT_DEPTH_SLICES, slices_, false);
            return lists;
        }
        for (const bool fill : {false, true}) {
            graph::Pass& pass = add(name_ + (fill ? "-lists fill" : "-lists count"), "light_lists_cells" + kind,
                                     whole, {{CONSTANT_LIST_FILL, fill}});
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

    graph::Pass& add(const std::string& name, const std::string& shader, Groups groups, gpu::Constants own = {}) {
        graph::Pass& pass = graph_.pass(name);
        own.insert(own.end(), constants_.begin(), constants_.end());
        dispatch_lists(pass, frame_, buffers_->constants(), shader, own,
                       [groups, constants = buffers_->constants()](const graph::PassContext& context) {
                           const VkExtent3D count = groups(*constants);
                           vkCmdDispatch(context.commands, count.width, count.height, count.depth);
                       });
        return pass;
    }
    void add_offsets(const char* what, graph::BufferId cells, bool coarse) {
        add(name_ + what, "light_lists_offsets.comp", once, {{CONSTANT_LIST_COARSE, coarse}, {CONSTANT_LIST_MASKED, inputs_.masked}})
            .storage(INPUT_LIGHT_CELLS, cells, true)
            .storage(INPUT_LIST_TOTAL, total_, true);
    }
    static VkExtent3D once(const LightListConstants&) { return {1, 1, 1}; }
    void read_depth(graph::Pass& pass) const { pass.sample(INPUT_DEPTH, inputs_.surface->depth_source); }

    graph::FrameGraph& graph_;
    const resident::Frame& frame_;
    std::string name_;
    LightListInputs inputs_;
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

LightLists light_list_passes(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightListInputs& inputs) {
    LightListConstants layout{};
    layout.lights.w = mask_words(frame.light_capacity());
    LightGrid grid;
    if (inputs.surface) {
        const uint32_t across = groups_of(frame.extent().width, inputs.tile_size);
        const uint32_t down = groups_of(frame.extent().height, inputs.tile_size);
        layout.cells = {across, down, 1, 0};
        layout.blocks = {groups_of(frame.extent().width, LIT_BLOCK), groups_of(frame.extent().height, LIT_BLOCK), 1, 0};
        layout.coarse = {groups_of(across, LIST_COARSE_TILES), groups_of(down, LIST_COARSE_TILES), 1, 0};
    } else {
        grid = light_grid(frame.geometry().draws);
        layout.cells = glm::uvec4(grid.cells, 0);
        layout.coarse = glm::uvec4((grid.cells + glm::uvec3(LIST_COARSE_CELLS - 1)) / glm::uvec3(LIST_COARSE_CELLS), 0);
        layout.grid_cell = glm::vec4(grid.cell, 0);
    }
    layout.cells.w = layout.cells.x * layout.cells.y * layout.cells.z;
    layout.coarse.w = layout.coarse.x * layout.coarse.y * layout.coarse.z;
    return Builder(graph, frame, name, inputs, layout, grid).build();
}

void dispatch_lists(graph::Pass& pass, const resident::Frame& frame,
                    std::shared_ptr<const shared::LightListConstants> push, const std::string& shader,
                    const gpu::Constants& constants, std::function<void(const graph::PassContext&)> dispatch) {
    auto pipeline = std::make_shared<gpu::ComputePipeline>();
    pass.prepare([=, &frame, name = pass.name()](const graph::PassInterface& interface) {
        *pipeline = gpu::ComputePipeline(frame.context(), {.name = name,
                                                           .shader = shader,
                                                           .constants = constants,
                                                           .sets = {frame.layout(), interface.inputs},
                                                           .push_bytes = sizeof(LightListConstants)});
    });
    pass.record([pipeline, dispatch = std::move(dispatch), push = std::move(push), &frame](const graph::PassContext& context) {
        pipeline->bind(context.commands);
        pipeline->bind_set(context.commands, SET_FRAME, frame.set());
        pipeline->bind_set(context.commands, SET_INPUTS, context.inputs);
        pipeline->push(context.commands, std::as_bytes(std::span(push.get(), 1)));
        dispatch(context);
    });
}

void declare_light_lists(graph::Pass& pass, const LightLists& lists, bool writes) {
    pass.storage(INPUT_LIGHT_CELLS, lists.cells, writes).storage(INPUT_LIGHT_ENTRIES, lists.entries, writes);
    if (lists.tile_size > 0)
        pass.storage(INPUT_DEPTH_SLICES, lists.slices, false);
}

gpu::Constants light_list_constants(const LightLists& lists) {
    return {{CONSTANT_LIST_TILE_SIZE, lists.tile_size}, {CONSTANT_LIST_SLICED, lists.sliced}};
}

} // namespace prelight::passes
