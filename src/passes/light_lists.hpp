#pragma once
#include "depth_normal.hpp"
#include "light_grid.hpp"
#include "light_rounds.hpp"
#include <shared/light_lists.h>

namespace prelight::passes {

/// Where the lists' cells lie, and who will walk them.
struct LightListInputs {
    const SurfaceBuffers* surface = nullptr; ///< tiles and clusters; null: a grid over the world
    GridOver over = GridOver::world;         ///< of that grid
    uint32_t tile_size = 8;                  ///< tiles and clusters: 8, 16 or 32 pixels
    bool sliced = false;                     ///< clusters
    bool masked = false;                     ///< tiles: masks of the lists of 8 × 8 tiles instead of lists
    LightWalk walk = LightWalk::fragment;
    /// Who walks the first round's lights surfaces that no list's light reaches, too.
    bool everywhere = false;
    LightRounds rounds; ///< as `walk` needs them
    /// Room for lists in the first frame, in lights; 0: a guess. It grows by itself.
    uint64_t first_room = 0;
};

/// The lists of one round's lights (shaders/shared/light_lists.glsl).
struct LightListRound {
    graph::BufferId cells;
    graph::BufferId tiles; ///< screen: those of tiles, with how many lights each has
    graph::BufferId entries;
    graph::BufferId slices;
    /// Push constants of this frame; set before its first pass records.
    std::shared_ptr<const shared::LightListConstants> constants;
    bool everywhere = false; ///< as LightListInputs has it, and where later rounds add to the first
    std::string ending;      ///< of the names of passes: round_name()
};

/// What a pass that walks light lists is given: built once, and walked by any number of passes after.
struct LightLists {
    std::vector<LightListRound> rounds;
    uint32_t tile_size = 8; ///< screen: pixels
    bool sliced = false;
    bool masked = false; ///< `cells` are coarse ones, of whose lists each tile has a mask
    LightWalk walk = LightWalk::fragment;
};

/// Builds lists of the lights that may reach each cell, in the order of View::light_groups(), on the device:
/// count, make room, fill. There is no cap: a list that does not fit makes its cell walk all lights
/// in that frame, and the buffer grows before the next. `name` begins the passes' names.
/// Throws Error when a buffer of a fixed size would be larger than the device allows.
LightLists build_light_lists(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                             const LightListInputs& inputs);

/// A round after the first that has no light in this frame: nothing is recorded for it.
bool is_idle(const shared::LightListConstants& constants, const graph::PassContext& pass);

/// Makes `pass` run one compute shader with the lists' push constants; `dispatch` is called when all is bound.
void dispatch_lists(graph::Pass& pass, const resident::View& view,
                    std::shared_ptr<const shared::LightListConstants> push, const gpu::ShaderKey& shader,
                    const gpu::Constants& constants, std::function<void(const graph::PassContext&)> dispatch);

/// The lists as bindings of a pass that walks them, and its constants.
void declare_light_lists(graph::Pass& pass, const LightListRound& round, bool writes = false);
gpu::Constants light_list_constants(const LightLists& lists);

} // namespace prelight::passes
