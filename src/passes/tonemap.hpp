#pragma once
#include <gpu/pipeline.hpp>
#include <graph/frame_graph.hpp>
#include <optional>
#include <resident/view.hpp>

namespace prelight::passes {

/// What a pass that shades makes of its colours: with a curve the finished picture, tone mapped by the
/// pass itself, "final", sRGB-encoded RGBA8, encoded by the
/// target where a GPU has sRGB targets; without one "linear", scene-linear RGBA16F for
/// tonemap_pass() and others. The shader ends with stored_colour() of shaders/shared/display.glsl.
using Display = std::optional<Tonemap>;
/// `wide`: "linear" is RGBA32F, for many lights that blending adds up.
graph::ImageId picture_image(graph::FrameGraph& graph, const resident::View& view, const gpu::Raster& raster,
                             Display display, bool wide = false);
/// The specialisation constants of stored_colour() for a target of this format.
gpu::Constants display_constants(Display display, VkFormat target);

/// Scene-linear `colour` → sRGB-encoded RGBA8, where something else needs the linear picture.
graph::ImageId tonemap_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId colour, Tonemap curve);

} // namespace prelight::passes
