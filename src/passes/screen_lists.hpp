#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// How light lists are walked: by a full-screen draw, or (tiles only) by a compute pass whose subgroups share what
/// they load. Automatic: compute on software devices, which load slowly.
enum class ListShading { automatic, fragment, compute };

/// Light lists as they are built; or, for measuring and for tiles only, without the lights that contribute to
/// no pixel of their tile (the limit of what lists can be), or without any.
enum class ListContents { built, perfect, empty };

struct ScreenListOptions {
    const SurfaceBuffers* samples = nullptr; ///< surfaces with all samples, where some are lit by themselves
    uint32_t tile_size = 8;                  ///< pixels of a tile's side: 8, 16 or 32
    ListShading shading = ListShading::automatic;
    ListContents contents = ListContents::built;
    uint64_t first_room = 0; ///< LightListInputs::first_room
};

/// Lists of tiles or clusters over the surfaces of `inputs`, for passes that light them into a target like that of
/// `inputs`, or count their lights; none where View::culling() knows no lists. A note in the graph says why what was
/// asked for cannot be had.
std::optional<LightLists> screen_light_lists(graph::FrameGraph& graph, const resident::View& view,
                                             const std::string& name, const LightingInputs& inputs,
                                             const ScreenListOptions& options);

/// Whether a compute pass walks lists of tiles on this device, where its target can be stored to.
bool compute_walks(const resident::View& view, ListShading asked);

} // namespace prelight::passes
