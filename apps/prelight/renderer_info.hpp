#pragma once
#include <prelight/renderer.hpp>
#include <string>

namespace prelight::app {

/// Throws UsageError naming the renderers there are.
RendererInfo find_renderer(const std::string& name);

} // namespace prelight::app
