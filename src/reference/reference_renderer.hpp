#pragma once
#include <memory>
#include <prelight/renderer.hpp>

namespace prelight {

/// `--renderer reference`: ray casting with Embree, shaded in double precision; needs no device.
RendererInfo reference_info();

/// Throws UsageError for an unknown setting, value, view or preset, for a zero-size picture, and
/// for samples a pixel that are none of sample_counts.
std::unique_ptr<Renderer> make_reference_renderer(const RenderOptions& options);

} // namespace prelight
