#pragma once
#include "forward.hpp"

namespace prelight::passes {

/// Where blended surfaces find their lights: the lists of a grid over the world, which knows places before opaque
/// surfaces too; without lists, View::reach() of their object, `per_draw` lights (1 … FORWARD_MOST_LIGHTS) at a time.
struct BlendedLights {
    const LightLists* lists = nullptr; ///< of one round
    uint32_t per_draw = 0;
};

/// Which fragments of blended objects a pass draws.
enum class BlendedPart {
    all,    ///< at or before `inputs.depth`; objects back to front
    layer,  ///< at `inputs.depth`; where surfaces coincide the world's first one comes last, and lies on top
    nearer, ///< before `inputs.depth`; objects back to front
};

/// What draws blended objects has in common, whatever becomes of their light and alpha. `more`: of draws that add
/// further lights to those of a first one.
SurfaceDraws::Desc blended_desc(const resident::View& view, ForwardInputs inputs, bool lists, bool more);
/// What such draws read beside attachments; with `lists`, returns their constants.
std::shared_ptr<const shared::LightListConstants> declare_blended(graph::FrameGraph& graph, graph::Pass& pass,
                                                                  const ForwardInputs& inputs, const LightLists* lists);

/// Draws one object with its lights: `first` with `lists`; without, `per_draw` of `reach` at a time, `more` after the
/// first draw. Returns the number of draws.
uint64_t draw_lit(const graph::PassContext& pass, SurfaceDraws::Bound& bound, const SurfaceDraws& first,
                  const SurfaceDraws* more, uint32_t index, const shared::LightListConstants* lists,
                  const resident::LightReach& reach, uint32_t per_draw,
                  SurfaceDraws::Faces faces = SurfaceDraws::Faces::all);

/// In which order objects are drawn: few pipelines and materials change; or as BlendedPart::layer has it.
enum class BlendedOrder { cheapest, layer };
/// Makes `pass` draw every blended object once. `push`: the push constants of each. `counted` gets the number of draws
/// at each recording.
void draw_blended(graph::Pass& pass, const resident::View& view, const SurfaceDraws::Desc& desc,
                  BlendedOrder order = BlendedOrder::cheapest, uint64_t* counted = nullptr,
                  std::shared_ptr<const shared::LightListConstants> push = nullptr);

/// A pass "blended": objects that are resident::Draw::blended() over what `inputs.colour` holds, which is scene-linear.
/// `inputs.depth` is tested and stays. Of a double-sided object back faces come before front ones. Its first draw
/// carries the share of what is behind; further ones, for further lights, add. `kinds`, `plan`, `decals` and
/// `lights_test` of the inputs are not used.
void blended_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                  const BlendedLights& lights, BlendedPart part = BlendedPart::all);

} // namespace prelight::passes
