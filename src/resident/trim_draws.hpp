#pragma once
#include "trim_indices.hpp"
#include "visible_draws.hpp"
#include <functional>
#include <span>

namespace prelight::resident {

/// Trims the indices of `draws` on all processors where that is worth while. Of each draw that it trims, `first_index`
/// and `index_count` become places in `room`, one draw after the other, and `trimmed` true; a draw whose indices do not
/// fit, or that faces the viewer, stays as it is. `objects`: of each draw. Neither depends on how many processors there
/// are. `view_of`: by the place among `draws`. Returns the indices used, and in `helpers_ms` the CPU time of threads
/// other than the calling one.
size_t trim_draws(std::span<VisibleDraw> draws, std::span<const shared::ObjectData> objects, std::span<const Draw> all,
                  const std::function<const TrimView&(size_t)>& view_of, std::span<uint32_t> room, double& helpers_ms);
/// All of them seen alike.
inline size_t trim_draws(std::span<VisibleDraw> draws, std::span<const shared::ObjectData> objects,
                         std::span<const Draw> all, const TrimView& view, std::span<uint32_t> room,
                         double& helpers_ms) {
    return trim_draws(
        draws, objects, all, [&view](size_t) -> const TrimView& { return view; }, room, helpers_ms);
}

} // namespace prelight::resident
