#pragma once
#include "shadow_maps.hpp"

namespace prelight::passes {

/// Whether lookups of these maps ask for extremes first: `pcf` does. `hard` is as cheap without, the disc of `contact`
/// is too wide for a cell to know much, and maps that are drawn light by light have none.
bool has_shadow_extremes(const resident::ShadowOptions& options);

/// "shadow extremes": for each cell of SHADOW_CELL² texels of the atlas the nearest and the farthest depth that a
/// lookup from there may meet, of the maps that the passes before have drawn anew. In: the atlas and its transmittance.
/// Out: Shadows::extremes.
void shadow_extremes_pass(graph::FrameGraph& graph, const resident::View& view, const Shadows& shadows);

} // namespace prelight::passes
