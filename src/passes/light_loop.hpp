#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights of a frame on every pixel in one full-screen pass, summed in registers and written
/// once: what light buffers need that cannot be blended, and the baseline for blending's rounding.
void light_loop_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                     const LightingInputs& inputs);

} // namespace prelight::passes
