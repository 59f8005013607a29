#pragma once
#include "lighting.hpp"
#include <shared/light_lists.h>

namespace prelight::passes {

/// What a pass that walks light lists needs (shaders/shared/light_lists.glsl).
struct LightLists {
    graph::BufferId cells;
    graph::BufferId tiles; ///< screen: those of tiles, with how many lights each has
    graph::BufferId entries;
    graph::BufferId slices;
    /// Push constants of this frame; set before its first pass records.
    std::shared_ptr<const shared::LightListConstants> constants;
    uint32_t tile_size = 0; ///< screen: pixels
    bool sliced = false;
    bool masked = false; ///< `cells` are coarse ones, of whose lists each tile has a mask
};

struct LightRounds;

/// Where the lists' cells lie.
struct LightListInputs {
    const SurfaceBuffers* surface = nullptr; ///< tiles and clusters
    uint32_t tile_size = 8;                  ///< tiles and clusters: 8, 16 or 32 pixels
    bool sliced = false;                     ///< clusters; without `surface`: a grid over the world
    bool masked = false;                     ///< tiles: masks of the lists of 8 × 8 tiles instead of lists
    bool ambient = false;                    ///< who walks them lights surfaces that no list's light reaches
    /// Room for lists in the first frame, in lights; 0: a guess. It grows by itself.
    uint64_t first_room = 0;
    const LightRounds* rounds = nullptr; ///< read at once
    uint32_t round = 0;                  ///< whose lights are listed
};

/// Builds lists of the lights that may reach each cell, in the order of Frame::lights(), on the device:
/// count, make room, fill. There is no cap: a list that does not fit makes its cell walk all lights
/// in that frame, and the buffer grows before the next. `name` begins the passes' names.
/// Throws Error when a buffer of a fixed size would be larger than the device allows.
LightLists light_list_passes(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightListInputs& inputs);

/// A round after the first that has no light in this frame: nothing is recorded for it.
bool is_idle(const shared::LightListConstants& constants, const graph::PassContext& pass);

/// Takes lights out of tiles' lists: ListContents. Passes of their own, "NAME-lists perfect …" or "NAME-lists empty".
void trim_light_lists(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                      const LightingInputs& inputs, const LightLists& lists, const std::string& ending);

/// Makes `pass` run one compute shader with the lists' push constants; `dispatch` is called when all is bound.
void dispatch_lists(graph::Pass& pass, const resident::Frame& frame,
                    std::shared_ptr<const shared::LightListConstants> push, const std::string& shader,
                    const gpu::Constants& constants, std::function<void(const graph::PassContext&)> dispatch);

/// The lists as bindings of a pass that walks them, and its constants.
void declare_light_lists(graph::Pass& pass, const LightLists& lists, bool writes = false);
gpu::Constants light_list_constants(const LightLists& lists);
/// These and lighting_constants(): of shaders that walk lists and evaluate lights.
gpu::Constants list_lighting_constants(const resident::Frame& frame, const LightingInputs& inputs,
                                       const LightLists& lists);

} // namespace prelight::passes
