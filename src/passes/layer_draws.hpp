#pragma once
#include "surface_draws.hpp"
#include <memory>

namespace prelight::passes {

/// Makes `pass` draw the blended objects that have a slot in `slots`, which may be another view of the same camera:
/// back to front, back faces before front ones where both show, with LayerConstants pushed. `desc`: but for what makes
/// the draws those. `drawn`: set to their number when the pass is recorded.
void draw_layers(graph::Pass& pass, const resident::View& view, SurfaceDraws::Desc desc, const resident::View& slots,
                 uint64_t* drawn = nullptr);

} // namespace prelight::passes
