#pragma once
#include "forward.hpp"
#include "k_buffer.hpp"

namespace prelight::passes {

/// Weighted blended transparency (McGuire and Bavoil, JCGT 2(2), 2013): a pass "blended" sums up what all blended
/// objects are like, in whatever order, and "blended compose" lays the mean over what `inputs.colour` holds, which is
/// scene-linear. One layer is exact and so is how much of what is behind is left; colours of several are approximate.
/// `inputs`: as of blended_pass(). `lists`: of a grid over the world and of one round. `nearest`: layers that others
/// draw; only what lies behind the last of them is summed up.
void weighted_blended_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                           const LightLists& lists, const KBuffer* nearest = nullptr);

} // namespace prelight::passes
