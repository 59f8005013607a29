#pragma once
#include <memory>
#include <prelight/renderer.hpp>

namespace prelight {

/// `--renderer reference`: ray casting with Embree, shaded in double precision; needs no device.
RendererInfo reference_info();

/// Throws UsageError for an unknown setting, value, view or preset, for a zero-size picture, and
/// for more than one sample a pixel (the reference casts one ray through each pixel's centre).
std::unique_ptr<Renderer> make_reference_renderer(const RenderOptions& options);

} // namespace prelight
