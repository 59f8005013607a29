#pragma once
#include "tonemap.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

/// Which of a pixel's samples make its mean.
enum class Resolved : uint32_t {
    all = RESOLVED_ALL,
    halves = RESOLVED_HALVES, ///< all: in half of them the nearest blended surface, laid over the others first
    opaque = RESOLVED_OPAQUE, ///< of those, the half that shows what is opaque
    first = RESOLVED_SAMPLE,  ///< one sample alone: only_sample()
};
/// `sample`: in Vulkan's order, from 0.
constexpr Resolved only_sample(uint32_t sample) { return static_cast<Resolved>(RESOLVED_SAMPLE + sample); }

/// The mean of each pixel's samples as light: of a picture that is scene-linear, or finished. An image with one sample
/// a pixel stays as it is. `which`: with four samples, scene-linear.
graph::ImageId resolve_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId image,
                            Resolved which = Resolved::all);

/// The finished picture of a scene-linear image with several samples a pixel: the mean of its tone-mapped samples.
graph::ImageId resolve_tonemapped_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear,
                                       Tonemap curve, Resolved which = Resolved::all);

} // namespace prelight::passes
